//! How far a measurement is.
use super::{Config, Mode};
use specula_testbench::EngineKind;

/// A step of a measurement, for a progress bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A program is built.
    Building {
        /// The engine.
        engine: EngineKind,
        /// The mode that it is for.
        mode: Mode,
    },
    /// Finding out how many spans make a run long enough.
    Trying {
        /// The engine and its mode.
        config: Config,
    },
    /// A run is measured.
    Measuring {
        /// The engine and its mode.
        config: Config,
        /// Runs measured before.
        done: usize,
        /// Runs in all.
        all: usize,
    },
}
