//! How the engine works.
use specula_kernels::InstructionSet;

/// How the engine works. What it computes does not depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Clocks in a batch, at least 1.
    pub batch: usize,
    /// The instruction set.
    pub instruction_set: InstructionSet,
    /// Threads that work at once, at least 1; one does where many signals are watched.
    pub threads: usize,
    /// Clocks that a thread works on at a time, at least 1, where there are several.
    pub piece: usize,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { batch: 512, instruction_set: InstructionSet::best(), threads: 1, piece: 32_768 }
    }
}
