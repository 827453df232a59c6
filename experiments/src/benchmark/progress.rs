//! The progress of a measurement.
use super::{Config, Mode};
use specula_testbench::EngineKind;

/// A step of a measurement, for a progress bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A program is being built.
    Building {
        /// The engine.
        engine: EngineKind,
        /// The mode for which it is built.
        mode: Mode,
    },
    /// The number of spans for a sufficiently long run is being determined.
    Trying {
        /// The engine and its mode.
        config: Config,
    },
    /// A run is being measured.
    Measuring {
        /// The engine and its mode.
        config: Config,
        /// Number of runs measured before.
        done: usize,
        /// Total number of runs.
        all: usize,
    },
}
