//! Compiled kernels: a loop, its constants, and the proof that the processor can run it.
use crate::InstructionSet;
use crate::post::Amounts;

/// A loop over an output and `N` input columns of one length.
pub(crate) type Loop<I, O> = fn(&mut [O], &[I], &[I], &Amounts);
/// The same loop, compiled for instructions that the processor must have.
pub(crate) type FeatureLoop<I, O> = unsafe fn(&mut [O], &[I], &[I], &Amounts);

/// A kernel of two operands with lanes `I` and a result with lanes `O`.
pub struct Binary<I, O> {
    baseline: Loop<I, O>,
    avx2: FeatureLoop<I, O>,
    instruction_set: InstructionSet,
    amounts: Amounts,
}

impl<I, O> Clone for Binary<I, O> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<I, O> Copy for Binary<I, O> {}

impl<I, O> Binary<I, O> {
    pub(crate) fn new(
        baseline: Loop<I, O>,
        avx2: FeatureLoop<I, O>,
        instruction_set: InstructionSet,
        amounts: Amounts,
    ) -> Self {
        Binary { baseline, avx2, instruction_set, amounts }
    }

    /// Fills `out` from the operands.
    ///
    /// # Panics
    /// If an operand is shorter than `out`.
    #[inline]
    pub fn run(&self, out: &mut [O], a: &[I], b: &[I]) {
        if self.instruction_set.avx2 {
            // SAFETY: an `InstructionSet` with `avx2` is made by `InstructionSet::best` only, which has seen that the
            // processor has AVX2.
            unsafe { (self.avx2)(out, a, b, &self.amounts) }
        } else {
            (self.baseline)(out, a, b, &self.amounts)
        }
    }
}

/// A loop over an output and `N` pairs of columns.
pub(crate) type SumLoop<O, const N: usize> = fn(&mut [O], [[&[i32]; 2]; N], &Amounts);
pub(crate) type FeatureSumLoop<O, const N: usize> = unsafe fn(&mut [O], [[&[i32]; 2]; N], &Amounts);

/// A kernel of `N` products of 32-bit lanes and a result with lanes `O`.
pub struct Products<O, const N: usize> {
    baseline: SumLoop<O, N>,
    avx2: FeatureSumLoop<O, N>,
    instruction_set: InstructionSet,
    amounts: Amounts,
}

impl<O, const N: usize> Clone for Products<O, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<O, const N: usize> Copy for Products<O, N> {}

impl<O, const N: usize> Products<O, N> {
    pub(crate) fn new(
        baseline: SumLoop<O, N>,
        avx2: FeatureSumLoop<O, N>,
        instruction_set: InstructionSet,
        amounts: Amounts,
    ) -> Self {
        Products { baseline, avx2, instruction_set, amounts }
    }

    /// Fills `out` from the factors of each product.
    ///
    /// # Panics
    /// If a factor is shorter than `out`.
    #[inline]
    pub fn run(&self, out: &mut [O], factors: [[&[i32]; 2]; N]) {
        if self.instruction_set.avx2 {
            // SAFETY: an `InstructionSet` with `avx2` is made by `InstructionSet::best` only, which has seen that the
            // processor has AVX2.
            unsafe { (self.avx2)(out, factors, &self.amounts) }
        } else {
            (self.baseline)(out, factors, &self.amounts)
        }
    }
}

/// A loop that selects between two columns by a third.
pub(crate) type ChoiceLoop<L> = fn(&mut [L], &[i32], &[L], &[L]);
pub(crate) type FeatureChoiceLoop<L> = unsafe fn(&mut [L], &[i32], &[L], &[L]);

/// A kernel that selects, lane by lane, between two columns.
pub struct Ternary<L> {
    baseline: ChoiceLoop<L>,
    avx2: FeatureChoiceLoop<L>,
    instruction_set: InstructionSet,
}

impl<L> Clone for Ternary<L> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<L> Copy for Ternary<L> {}

impl<L> Ternary<L> {
    pub(crate) fn new(
        baseline: ChoiceLoop<L>,
        avx2: FeatureChoiceLoop<L>,
        instruction_set: InstructionSet,
    ) -> Self {
        Ternary { baseline, avx2, instruction_set }
    }

    /// Fills `out` with `yes` where `condition` is not 0, else with `no`.
    ///
    /// # Panics
    /// If an operand is shorter than `out`.
    #[inline]
    pub fn run(&self, out: &mut [L], condition: &[i32], yes: &[L], no: &[L]) {
        if self.instruction_set.avx2 {
            // SAFETY: an `InstructionSet` with `avx2` is made by `InstructionSet::best` only, which has seen that the
            // processor has AVX2.
            unsafe { (self.avx2)(out, condition, yes, no) }
        } else {
            (self.baseline)(out, condition, yes, no)
        }
    }
}
