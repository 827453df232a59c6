//! The results of a measurement.
use super::{Config, Machine, Mode};
use specula_testbench::EngineKind;
use specula_testbench::statistics::median;

/// A whole measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// The machine.
    pub machine: Machine,
    /// Clocks for one frame.
    pub clocks_of_a_frame: u64,
    /// The engines and modes that were measured, in their order.
    pub rows: Vec<EngineResult>,
    /// The engines and modes that could not be measured.
    pub skipped: Vec<Skipped>,
}

/// The result of an engine in a mode.
#[derive(Clone, Debug, PartialEq)]
pub struct EngineResult {
    /// The engine and its mode.
    pub config: Config,
    /// Clocks of each of its runs.
    pub clocks: u64,
    /// Clocks per second in each round.
    pub rates: Vec<f64>,
    /// Seconds before the first clock: the median, if it was measured in every round.
    pub build_seconds: f64,
}

/// An engine or mode that was not measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skipped {
    /// The engine.
    pub engine: EngineKind,
    /// The mode; `None` stands for all of them.
    pub mode: Option<Mode>,
    /// The reason, and what the user can do about it.
    pub reason: String,
}

impl EngineResult {
    /// Clocks per second: the median of the rounds.
    pub fn rate(&self) -> f64 {
        median(&self.rates)
    }
}

impl Measurement {
    /// The rate of `row` divided by that of Verilator with its outputs alone; `None` if that was
    /// not measured.
    pub fn ratio_to_verilator(&self, row: &EngineResult) -> Option<f64> {
        let is_reference = |row: &&EngineResult| {
            row.config.engine == EngineKind::Verilator && row.config.mode == Mode::Outputs
        };
        self.rows.iter().find(is_reference).map(|reference| row.rate() / reference.rate())
    }
}
