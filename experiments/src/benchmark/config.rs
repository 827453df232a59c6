//! Configurations that are measured: an engine and a mode.
use specula_sim::fast::InstructionSet;

use specula_testbench::EngineKind;

/// What an engine records in every clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Only the outputs.
    Outputs,
    /// Every signal, kept in memory.
    EverySignal,
    /// Every signal, written to a value change dump.
    Vcd,
    /// Every signal, written to a value change dump whose bytes are discarded: the cost of
    /// formatting it.
    VcdNull,
    /// Every signal, written to a fast signal trace.
    Fst,
}

impl Mode {
    /// Every mode.
    pub const ALL: [Mode; 5] =
        [Mode::Outputs, Mode::EverySignal, Mode::Vcd, Mode::VcdNull, Mode::Fst];

    /// The name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Mode::Outputs => "outputs",
            Mode::EverySignal => "every-signal",
            Mode::Vcd => "vcd",
            Mode::VcdNull => "vcd-null",
            Mode::Fst => "fst",
        }
    }
}

/// An engine in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Config {
    /// The engine.
    pub engine: EngineKind,
    /// The mode, that is, what it records.
    pub mode: Mode,
    /// The variant, if there are several of an engine: the instruction set that it uses, or the
    /// compiler's option.
    pub variant: Option<&'static str>,
    /// Number of threads that it uses.
    pub threads: usize,
}

impl Config {
    /// The configuration of an engine without variants.
    pub(crate) const fn only(engine: EngineKind, mode: Mode) -> Config {
        Config { engine, mode, variant: None, threads: 1 }
    }

    /// A configuration of the columnar engine.
    pub(crate) const fn fast(
        mode: Mode,
        instruction_set: InstructionSet,
        threads: usize,
    ) -> Config {
        Config { engine: EngineKind::Fast, mode, variant: Some(instruction_set.name()), threads }
    }

    /// The configuration as text.
    pub fn describe(&self) -> String {
        let mut words = vec![self.engine.program(), self.mode.name()];
        words.extend(self.variant);
        let threads =
            if self.threads > 1 { format!(" {} threads", self.threads) } else { String::new() };
        words.join(" ") + &threads
    }
}
