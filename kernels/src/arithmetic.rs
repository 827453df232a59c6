//! Sums, differences and products, computed in one lane width and stored in another.
use crate::kernel::Binary;
use crate::post::{Amounts, Floor, Keep, Round, ShiftKind, Signed, Unsigned, WrapKind};
use crate::{Lane, Level, Post, Shift, Wrap};

/// An arithmetic operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// The first operand.
    Copy,
    /// Sum.
    Add,
    /// Difference.
    Sub,
    /// Product.
    Mul,
}

/// An operator as a type.
trait Operator {
    fn apply<L: Lane>(a: L, b: L) -> L;
}

struct First;
struct Add;
struct Sub;
struct Mul;

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

/// Operands of lanes `I`, computed in lanes `C`, stored in lanes `O`.
#[inline(always)]
fn body<I: Lane, C: Lane, O: Lane, F: Operator, S: ShiftKind, W: WrapKind>(out: &mut [O], a: &[I], b: &[I], amounts: Amounts) {
    let n = out.len();
    let (a, b) = (&a[..n], &b[..n]);
    for i in 0..n {
        let raw = F::apply(C::from_i64(a[i].to_i64()), C::from_i64(b[i].to_i64()));
        out[i] = O::from_i64(W::apply(S::apply(raw, amounts.shift), amounts.unused).to_i64());
    }
}

fn baseline<I: Lane, C: Lane, O: Lane, F: Operator, S: ShiftKind, W: WrapKind>(out: &mut [O], a: &[I], b: &[I], amounts: Amounts) {
    body::<I, C, O, F, S, W>(out, a, b, amounts)
}

#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2"))]
unsafe fn avx2<I: Lane, C: Lane, O: Lane, F: Operator, S: ShiftKind, W: WrapKind>(
    out: &mut [O],
    a: &[I],
    b: &[I],
    amounts: Amounts,
) {
    body::<I, C, O, F, S, W>(out, a, b, amounts)
}

/// Operands and results of 32 bits, computed in 32.
pub fn narrow(operator: Arithmetic, post: Post, level: Level) -> Binary<i32, i32> {
    arithmetic::<i32, i32, i32>(operator, post, level)
}

/// Operands of 32 bits, computed in 64, results of 32.
pub fn narrow_through_wide(operator: Arithmetic, post: Post, level: Level) -> Binary<i32, i32> {
    arithmetic::<i32, i64, i32>(operator, post, level)
}

/// Operands of 32 bits, computed in 64, results of 64.
pub fn widening(operator: Arithmetic, post: Post, level: Level) -> Binary<i32, i64> {
    arithmetic::<i32, i64, i64>(operator, post, level)
}

/// Operands and results of 64 bits.
pub fn wide(operator: Arithmetic, post: Post, level: Level) -> Binary<i64, i64> {
    arithmetic::<i64, i64, i64>(operator, post, level)
}

/// Operands of 64 bits, results of 32.
pub fn narrowing(operator: Arithmetic, post: Post, level: Level) -> Binary<i64, i32> {
    arithmetic::<i64, i64, i32>(operator, post, level)
}

/// The kernel of `operator` on operands of lanes `I`, computed in lanes `C`, after `post` stored in lanes `O`.
///
/// The result is right where the raw result fits `C` and the result after `post` fits `O`.
fn arithmetic<I: Lane, C: Lane, O: Lane>(operator: Arithmetic, post: Post, level: Level) -> Binary<I, O> {
    match operator {
        Arithmetic::Copy => with_operator::<I, C, O, First>(post, level),
        Arithmetic::Add => with_operator::<I, C, O, Add>(post, level),
        Arithmetic::Sub => with_operator::<I, C, O, Sub>(post, level),
        Arithmetic::Mul => with_operator::<I, C, O, Mul>(post, level),
    }
}

fn with_operator<I: Lane, C: Lane, O: Lane, F: Operator>(post: Post, level: Level) -> Binary<I, O> {
    match post.shift {
        Shift::None => with_shift::<I, C, O, F, Keep>(post, level),
        Shift::Floor(_) => with_shift::<I, C, O, F, Floor>(post, level),
        Shift::Round(_) => with_shift::<I, C, O, F, Round>(post, level),
    }
}

fn with_shift<I: Lane, C: Lane, O: Lane, F: Operator, S: ShiftKind>(post: Post, level: Level) -> Binary<I, O> {
    match post.wrap {
        Wrap::None => chosen::<I, C, O, F, S, Keep>(post, level),
        Wrap::Signed(_) => chosen::<I, C, O, F, S, Signed>(post, level),
        Wrap::Unsigned(_) => chosen::<I, C, O, F, S, Unsigned>(post, level),
    }
}

fn chosen<I: Lane, C: Lane, O: Lane, F: Operator, S: ShiftKind, W: WrapKind>(post: Post, level: Level) -> Binary<I, O> {
    Binary::new(baseline::<I, C, O, F, S, W>, avx2::<I, C, O, F, S, W>, level, post.amounts(C::BITS))
}
