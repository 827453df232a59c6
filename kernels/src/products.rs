//! Products of 32-bit lanes, and sums of two or three of them in one pass, so that no column is
//! stored for each product.
use crate::kernel::Products;
use crate::post::{
    Amounts, Fill, Finish, Kind, Plain, Shifted, SignFilled, Wrapped, WrappedAndShifted, ZeroFilled,
};
use crate::{InstructionSet, Lane, Post};

/// Whether the second of several products is added or subtracted; all others are added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Second {
    /// It is added.
    Added,
    /// It is subtracted.
    Subtracted,
}

/// A bound on the magnitudes of the products and of all their partial sums.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Magnitude {
    /// Products and sums fit 64 bits.
    Any,
    /// Products and sums are at most 2^51.
    UpTo51Bits,
}

/// The kind of number in which products are computed.
trait Number: Copy {
    /// The lane of the result.
    type Raw: Lane;
    fn product(a: i32, b: i32) -> Self;
    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    fn raw(self) -> Self::Raw;
}

macro_rules! integer {
    ($lane:ty) => {
        impl Number for $lane {
            type Raw = $lane;
            #[inline(always)]
            fn product(a: i32, b: i32) -> Self {
                <$lane>::from(a).times(<$lane>::from(b))
            }
            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                Lane::plus(self, other)
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                Lane::minus(self, other)
            }
            #[inline(always)]
            fn raw(self) -> Self {
                self
            }
        }
    };
}

integer!(i32);
integer!(i64);

/// Whole numbers up to 2^51 as floating point, which is exact. Baseline x86-64 multiplies these
/// four times as fast as 64-bit integers: it has no instruction for a signed product of 32-bit
/// lanes.
#[derive(Clone, Copy)]
struct Exact(f64);

/// 1.5 · 2^52. A double from 2^52 to 2^53 has a last place of 1. So the bits of this constant and
/// those of this constant plus a whole x, |x| ≤ 2^51, differ by x.
const MIDDLE: f64 = 6_755_399_441_055_744.0;

impl Number for Exact {
    type Raw = i64;
    #[inline(always)]
    fn product(a: i32, b: i32) -> Self {
        Exact(f64::from(a) * f64::from(b))
    }
    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        Exact(self.0 + other.0)
    }
    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        Exact(self.0 - other.0)
    }
    #[inline(always)]
    fn raw(self) -> i64 {
        (self.0 + MIDDLE).to_bits().wrapping_sub(MIDDLE.to_bits()) as i64
    }
}

/// The sign of the second product, as a type.
trait Sign {
    fn apply<C: Number>(first: C, second: C) -> C;
}

struct Added;
struct Subtracted;

impl Sign for Added {
    #[inline(always)]
    fn apply<C: Number>(first: C, second: C) -> C {
        first.plus(second)
    }
}

impl Sign for Subtracted {
    #[inline(always)]
    fn apply<C: Number>(first: C, second: C) -> C {
        first.minus(second)
    }
}

type Factors<'a, const N: usize> = [[&'a [i32]; 2]; N];

#[inline(always)]
fn body<C: Number, O: Lane, F: Sign, P: Finish, const N: usize>(
    out: &mut [O],
    factors: Factors<N>,
    amounts: &Amounts,
) {
    let n = out.len();
    let factors = factors.map(|pair| pair.map(|column| &column[..n]));
    for i in 0..n {
        let product = |j: usize| C::product(factors[j][0][i], factors[j][1][i]);
        let mut sum = product(0);
        // A loop over the products would keep the compiler from vectorising over the lanes.
        if N > 1 {
            sum = F::apply(sum, product(1));
        }
        if N > 2 {
            sum = sum.plus(product(2));
        }
        out[i] = P::apply(sum.raw(), amounts);
    }
}

fn baseline<C: Number, O: Lane, F: Sign, P: Finish, const N: usize>(
    out: &mut [O],
    factors: Factors<N>,
    amounts: &Amounts,
) {
    body::<C, O, F, P, N>(out, factors, amounts)
}

#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2"))]
unsafe fn avx2<C: Number, O: Lane, F: Sign, P: Finish, const N: usize>(
    out: &mut [O],
    factors: Factors<N>,
    amounts: &Amounts,
) {
    body::<C, O, F, P, N>(out, factors, amounts)
}

/// The kernel that computes in 32 bits and has results of 32. There may be 1 to 3 products.
pub fn narrow_products<const N: usize>(
    second: Second,
    post: Post,
    instruction_set: InstructionSet,
) -> Products<i32, N> {
    products::<i32, i32, i32, N>(second, post, instruction_set)
}

/// The kernel that computes in 64 bits and has results of 32. There may be 1 to 3 products.
pub fn products_through_wide<const N: usize>(
    second: Second,
    magnitude: Magnitude,
    post: Post,
    instruction_set: InstructionSet,
) -> Products<i32, N> {
    of_magnitude(second, magnitude, post, instruction_set)
}

/// The kernel that computes in 64 bits and has results of 64. There may be 1 to 3 products.
pub fn wide_products<const N: usize>(
    second: Second,
    magnitude: Magnitude,
    post: Post,
    instruction_set: InstructionSet,
) -> Products<i64, N> {
    of_magnitude(second, magnitude, post, instruction_set)
}

fn of_magnitude<O: Lane, const N: usize>(
    second: Second,
    magnitude: Magnitude,
    post: Post,
    instruction_set: InstructionSet,
) -> Products<O, N> {
    match magnitude {
        Magnitude::Any => products::<i64, i64, O, N>(second, post, instruction_set),
        Magnitude::UpTo51Bits => products::<Exact, i64, O, N>(second, post, instruction_set),
    }
}

/// The kernel that computes in numbers `B`, or with AVX2 in numbers `C`, and stores the result
/// after `post` in lanes `O`.
///
/// The result is right where the sum, with [`Post::half`] more, fits the lane that it is computed
/// in, and the result after `post` fits `O`.
fn products<B, C, O, const N: usize>(
    second: Second,
    post: Post,
    instruction_set: InstructionSet,
) -> Products<O, N>
where
    B: Number<Raw = C::Raw>,
    C: Number,
    O: Lane,
{
    const { assert!(1 <= N && N <= 3) };
    match second {
        Second::Subtracted if N > 1 => with_sign::<B, C, O, Subtracted, N>(post, instruction_set),
        _ => with_sign::<B, C, O, Added, N>(post, instruction_set),
    }
}

fn with_sign<B, C, O, F, const N: usize>(
    post: Post,
    instruction_set: InstructionSet,
) -> Products<O, N>
where
    B: Number<Raw = C::Raw>,
    C: Number,
    O: Lane,
    F: Sign,
{
    match post.kind::<C::Raw, O>() {
        Kind::Plain => with_finish::<B, C, O, F, Plain, N>(post, instruction_set),
        Kind::Shifted(Fill::Zero) => {
            with_finish::<B, C, O, F, Shifted<ZeroFilled>, N>(post, instruction_set)
        }
        Kind::Shifted(Fill::Sign) => {
            with_finish::<B, C, O, F, Shifted<SignFilled>, N>(post, instruction_set)
        }
        Kind::WrappedAndShifted(Fill::Zero) => {
            with_finish::<B, C, O, F, WrappedAndShifted<ZeroFilled>, N>(post, instruction_set)
        }
        Kind::WrappedAndShifted(Fill::Sign) => {
            with_finish::<B, C, O, F, WrappedAndShifted<SignFilled>, N>(post, instruction_set)
        }
    }
}

fn with_finish<B, C, O, F, P, const N: usize>(
    post: Post,
    instruction_set: InstructionSet,
) -> Products<O, N>
where
    B: Number<Raw = C::Raw>,
    C: Number,
    O: Lane,
    F: Sign,
    P: Finish,
{
    if post.wraps() {
        chosen::<B, C, O, F, Wrapped<P>, N>(post, instruction_set)
    } else {
        chosen::<B, C, O, F, P, N>(post, instruction_set)
    }
}

fn chosen<B, C, O, F, P, const N: usize>(
    post: Post,
    instruction_set: InstructionSet,
) -> Products<O, N>
where
    B: Number<Raw = C::Raw>,
    C: Number,
    O: Lane,
    F: Sign,
    P: Finish,
{
    Products::new(
        baseline::<B, O, F, P, N>,
        avx2::<C, O, F, P, N>,
        instruction_set,
        post.amounts::<C::Raw>(),
    )
}
