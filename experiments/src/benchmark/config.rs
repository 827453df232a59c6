//! Configurations that are measured: an engine in a mode.
use specula_sim::fast::InstructionSet;

use specula_testbench::EngineKind;

/// What an engine keeps of every clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// The outputs.
    Outputs,
    /// Every signal, in memory.
    EverySignal,
    /// Every signal, in a value change dump.
    Vcd,
    /// The same with the bytes discarded: the cost of making them.
    VcdNull,
    /// Every signal, in a fast signal trace.
    Fst,
}

impl Mode {
    /// Every mode.
    pub const ALL: [Mode; 5] =
        [Mode::Outputs, Mode::EverySignal, Mode::Vcd, Mode::VcdNull, Mode::Fst];

    /// Its name in tables.
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
    /// What it keeps.
    pub mode: Mode,
    /// Where there are several of an engine, which of them: the instruction set that it uses, or
    /// the compiler's option.
    pub variant: Option<&'static str>,
    /// Threads that it works with.
    pub threads: usize,
}

impl Config {
    /// An engine of which there is only one.
    pub(crate) const fn only(engine: EngineKind, mode: Mode) -> Config {
        Config { engine, mode, variant: None, threads: 1 }
    }

    /// The columnar engine.
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
