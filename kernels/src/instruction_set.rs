//! The instruction sets that kernels are compiled for.

/// An instruction set that kernels are compiled for. A value other than the baseline exists only
/// where the processor has it, since only [`InstructionSet::best`] makes one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InstructionSet {
    pub(crate) avx2: bool,
}

impl InstructionSet {
    /// The instructions that every processor of the compilation target has.
    pub const BASELINE: InstructionSet = InstructionSet { avx2: false };

    /// The best instruction set that this processor has.
    pub fn best() -> InstructionSet {
        #[cfg(target_arch = "x86_64")]
        let avx2 = std::arch::is_x86_feature_detected!("avx2");
        #[cfg(not(target_arch = "x86_64"))]
        let avx2 = false;
        InstructionSet { avx2 }
    }

    /// Its name.
    pub const fn name(self) -> &'static str {
        if self.avx2 { "avx2" } else { "baseline" }
    }
}
