//! Comparisons, bitwise operators, multiplexers, and conversions between lanes.
use crate::kernel::{Binary, Ternary};
use crate::post::Amounts;
use crate::{InstructionSet, Lane};

/// A bitwise operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bits {
    /// AND.
    And,
    /// OR.
    Or,
}

#[inline(always)]
fn less_body<L: Lane>(out: &mut [i32], a: &[L], b: &[L]) {
    let n = out.len();
    let (a, b) = (&a[..n], &b[..n]);
    for i in 0..n {
        out[i] = i32::from(a[i] < b[i]);
    }
}

fn less_baseline<L: Lane>(out: &mut [i32], a: &[L], b: &[L], _: &Amounts) {
    less_body(out, a, b)
}

#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2"))]
unsafe fn less_avx2<L: Lane>(out: &mut [i32], a: &[L], b: &[L], _: &Amounts) {
    less_body(out, a, b)
}

/// The kernel of a < b.
pub fn less_than<L: Lane>(instruction_set: InstructionSet) -> Binary<L, i32> {
    Binary::new(less_baseline::<L>, less_avx2::<L>, instruction_set, Amounts::default())
}

#[inline(always)]
fn bits_body<L: Lane>(out: &mut [L], a: &[L], b: &[L], f: impl Fn(L, L) -> L) {
    let n = out.len();
    let (a, b) = (&a[..n], &b[..n]);
    for i in 0..n {
        out[i] = f(a[i], b[i]);
    }
}

macro_rules! bitwise {
    ($baseline:ident, $avx2:ident, $f:expr) => {
        fn $baseline<L: Lane + std::ops::BitAnd<Output = L> + std::ops::BitOr<Output = L>>(
            out: &mut [L],
            a: &[L],
            b: &[L],
            _: &Amounts,
        ) {
            bits_body(out, a, b, $f)
        }

        #[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2"))]
        unsafe fn $avx2<L: Lane + std::ops::BitAnd<Output = L> + std::ops::BitOr<Output = L>>(
            out: &mut [L],
            a: &[L],
            b: &[L],
            _: &Amounts,
        ) {
            bits_body(out, a, b, $f)
        }
    };
}

bitwise!(and_baseline, and_avx2, |a, b| a & b);
bitwise!(or_baseline, or_avx2, |a, b| a | b);

/// The kernel of a bitwise operator.
pub fn bits<L: Lane + std::ops::BitAnd<Output = L> + std::ops::BitOr<Output = L>>(
    operator: Bits,
    instruction_set: InstructionSet,
) -> Binary<L, L> {
    match operator {
        Bits::And => {
            Binary::new(and_baseline::<L>, and_avx2::<L>, instruction_set, Amounts::default())
        }
        Bits::Or => {
            Binary::new(or_baseline::<L>, or_avx2::<L>, instruction_set, Amounts::default())
        }
    }
}

#[inline(always)]
fn choose_body<L: Lane>(out: &mut [L], condition: &[i32], yes: &[L], no: &[L]) {
    let n = out.len();
    let (condition, yes, no) = (&condition[..n], &yes[..n], &no[..n]);
    for i in 0..n {
        // An `if` would leave a load under a condition, which is not vectorised.
        out[i] = std::hint::select_unpredictable(condition[i] != 0, yes[i], no[i]);
    }
}

fn choose_baseline<L: Lane>(out: &mut [L], condition: &[i32], yes: &[L], no: &[L]) {
    choose_body(out, condition, yes, no)
}

#[cfg_attr(target_arch = "x86_64", target_feature(enable = "avx2"))]
unsafe fn choose_avx2<L: Lane>(out: &mut [L], condition: &[i32], yes: &[L], no: &[L]) {
    choose_body(out, condition, yes, no)
}

/// The kernel of a multiplexer.
pub fn choose<L: Lane>(instruction_set: InstructionSet) -> Ternary<L> {
    Ternary::new(choose_baseline::<L>, choose_avx2::<L>, instruction_set)
}
