//! Sums, differences and products, computed in one lane width and stored in another.
use crate::kernel::Binary;
use crate::post::{
    Amounts, Fill, Finish, Kind, Plain, Shifted, SignFilled, Wrapped, WrappedAndShifted, ZeroFilled,
};
use crate::{InstructionSet, Lane, Post, Wrap};

/// An arithmetic operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// The first operand alone.
    Copy,
    /// Sum.
    Add,
    /// Difference.
    Sub,
    /// Product.
    Mul,
}

/// The smaller or the larger of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extreme {
    /// The smaller.
    Min,
    /// The larger.
    Max,
}

/// An arithmetic operator as a type, so that each has a loop of its own.
trait Operator {
    fn apply<L: Lane>(a: L, b: L) -> L;
}

struct First;
struct Add;
struct Sub;
struct Mul;
struct Min;
struct Max;

impl Operator for First {
    #[inline(always)]
    fn apply<L: Lane>(a: L, _: L) -> L {
        a
    }
}

impl Operator for Add {
    #[inline(always)]
    fn apply<L: Lane>(a: L, b: L) -> L {
        a.plus(b)
    }
}

impl Operator for Sub {
    #[inline(always)]
    fn apply<L: Lane>(a: L, b: L) -> L {
        a.minus(b)
    }
}

impl Operator for Mul {
    #[inline(always)]
    fn apply<L: Lane>(a: L, b: L) -> L {
        a.times(b)
    }
}

impl Operator for Min {
    #[inline(always)]
    fn apply<L: Lane>(a: L, b: L) -> L {
        a.min(b)
    }
}

impl Operator for Max {
    #[inline(always)]
    fn apply<L: Lane>(a: L, b: L) -> L {
        a.max(b)
    }
}

/// The loop: operands in lanes `I`, computed in lanes `C`, stored in lanes `O`.
#[inline(always)]
fn body<I: Lane, C: Lane, O: Lane, F: Operator, P: Finish>(
    out: &mut [O],
    a: &[I],
    b: &[I],
    amounts: &Amounts,
) {
    let n = out.len();
    let (a, b) = (&a[..n], &b[..n]);
    for i in 0..n {
        out[i] =
            P::apply(F::apply(C::from_i64(a[i].to_i64()), C::from_i64(b[i].to_i64())), amounts);
    }
}

fn baseline<I: Lane, C: Lane, O: Lane, F: Operator, P: Finish>(
    out: &mut [O],
    a: &[I],
    b: &[I],
    amounts: &Amounts,
) {
    body::<I, C, O, F, P>(out, a, b, amounts)
}

#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2"))]
unsafe fn avx2<I: Lane, C: Lane, O: Lane, F: Operator, P: Finish>(
    out: &mut [O],
    a: &[I],
    b: &[I],
    amounts: &Amounts,
) {
    body::<I, C, O, F, P>(out, a, b, amounts)
}

/// The kernel for operands and results of 32 bits, computed in 32.
pub fn narrow(
    operator: Arithmetic,
    post: Post,
    instruction_set: InstructionSet,
) -> Binary<i32, i32> {
    arithmetic::<i32, i32, i32>(operator, post, instruction_set)
}

/// The kernel for operands of 32 bits, computed in 64, and results of 32.
pub fn narrow_through_wide(
    operator: Arithmetic,
    post: Post,
    instruction_set: InstructionSet,
) -> Binary<i32, i32> {
    arithmetic::<i32, i64, i32>(operator, post, instruction_set)
}

/// The kernel for operands of 32 bits, computed in 64, and results of 64.
pub fn widening(
    operator: Arithmetic,
    post: Post,
    instruction_set: InstructionSet,
) -> Binary<i32, i64> {
    arithmetic::<i32, i64, i64>(operator, post, instruction_set)
}

/// The kernel for operands and results of 64 bits.
pub fn wide(operator: Arithmetic, post: Post, instruction_set: InstructionSet) -> Binary<i64, i64> {
    arithmetic::<i64, i64, i64>(operator, post, instruction_set)
}

/// The kernel for operands of 64 bits and results of 32.
pub fn narrowing(
    operator: Arithmetic,
    post: Post,
    instruction_set: InstructionSet,
) -> Binary<i64, i32> {
    arithmetic::<i64, i64, i32>(operator, post, instruction_set)
}

/// The kernel for the smaller or larger of two numbers of 32 bits.
pub fn extreme(extreme: Extreme, wrap: Wrap, instruction_set: InstructionSet) -> Binary<i32, i32> {
    let post = Post { wrap, ..Post::default() };
    match (extreme, post.wraps()) {
        (Extreme::Min, false) => chosen::<i32, i32, i32, Min, Plain>(post, instruction_set),
        (Extreme::Min, true) => chosen::<i32, i32, i32, Min, Wrapped<Plain>>(post, instruction_set),
        (Extreme::Max, false) => chosen::<i32, i32, i32, Max, Plain>(post, instruction_set),
        (Extreme::Max, true) => chosen::<i32, i32, i32, Max, Wrapped<Plain>>(post, instruction_set),
    }
}

/// The kernel of `operator` on operands of lanes `I`, computed in lanes `C`, after `post` stored in
/// lanes `O`.
///
/// The result is right where the raw result, with [`Post::half`] more, fits `C` and the result
/// after `post` fits `O`.
fn arithmetic<I: Lane, C: Lane, O: Lane>(
    operator: Arithmetic,
    post: Post,
    instruction_set: InstructionSet,
) -> Binary<I, O> {
    match operator {
        Arithmetic::Copy => with_operator::<I, C, O, First>(post, instruction_set),
        Arithmetic::Add => with_operator::<I, C, O, Add>(post, instruction_set),
        Arithmetic::Sub => with_operator::<I, C, O, Sub>(post, instruction_set),
        Arithmetic::Mul => with_operator::<I, C, O, Mul>(post, instruction_set),
    }
}

fn with_operator<I: Lane, C: Lane, O: Lane, F: Operator>(
    post: Post,
    instruction_set: InstructionSet,
) -> Binary<I, O> {
    match post.kind::<C, O>() {
        Kind::Plain => with_finish::<I, C, O, F, Plain>(post, instruction_set),
        Kind::Shifted(Fill::Zero) => {
            with_finish::<I, C, O, F, Shifted<ZeroFilled>>(post, instruction_set)
        }
        Kind::Shifted(Fill::Sign) => {
            with_finish::<I, C, O, F, Shifted<SignFilled>>(post, instruction_set)
        }
        Kind::WrappedAndShifted(Fill::Zero) => {
            with_finish::<I, C, O, F, WrappedAndShifted<ZeroFilled>>(post, instruction_set)
        }
        Kind::WrappedAndShifted(Fill::Sign) => {
            with_finish::<I, C, O, F, WrappedAndShifted<SignFilled>>(post, instruction_set)
        }
    }
}

fn with_finish<I: Lane, C: Lane, O: Lane, F: Operator, P: Finish>(
    post: Post,
    instruction_set: InstructionSet,
) -> Binary<I, O> {
    if post.wraps() {
        chosen::<I, C, O, F, Wrapped<P>>(post, instruction_set)
    } else {
        chosen::<I, C, O, F, P>(post, instruction_set)
    }
}

fn chosen<I: Lane, C: Lane, O: Lane, F: Operator, P: Finish>(
    post: Post,
    instruction_set: InstructionSet,
) -> Binary<I, O> {
    Binary::new(
        baseline::<I, C, O, F, P>,
        avx2::<I, C, O, F, P>,
        instruction_set,
        post.amounts::<C>(),
    )
}
