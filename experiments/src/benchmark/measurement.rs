//! What was measured.
use super::{Config, Machine, Mode};
use specula_testbench::EngineKind;
use specula_testbench::statistics::median;

/// A whole measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// The machine.
    pub machine: Machine,
    /// Clocks that a frame takes.
    pub clocks_of_a_frame: u64,
    /// What took part, in the order in which it did.
    pub rows: Vec<Row>,
    /// What could not.
    pub skipped: Vec<Skipped>,
}

/// What came of an engine in a mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which it is.
    pub config: Config,
    /// Clocks of each of its runs.
    pub clocks: u64,
    /// Clocks a second, round by round.
    pub rates: Vec<f64>,
    /// Seconds before the first clock: the median, where it was measured in every round.
    pub build_seconds: f64,
}

/// What did not take part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skipped {
    /// The engine.
    pub engine: EngineKind,
    /// The mode; all of them if there is none.
    pub mode: Option<Mode>,
    /// Why not, and what to do about it.
    pub reason: String,
}

impl Row {
    /// Clocks a second.
    pub fn rate(&self) -> f64 {
        median(&self.rates)
    }
}

impl Measurement {
    /// How many times as fast as Verilator with its outputs alone; `None` if that did not take
    /// part.
    pub fn ratio_to_verilator(&self, row: &Row) -> Option<f64> {
        let is_reference = |row: &&Row| {
            row.config.engine == EngineKind::Verilator && row.config.mode == Mode::Outputs
        };
        self.rows.iter().find(is_reference).map(|reference| row.rate() / reference.rate())
    }
}
