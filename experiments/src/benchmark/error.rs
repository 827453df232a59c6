//! Errors of measurements.
use std::io;

use specula_datapath::builder::BuildError;
use specula_golden::fixed::PacketError;
use specula_sim::SimError;

use specula_testbench::BenchError;

/// The reason why a measurement was not made.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum MeasureError {
    /// The core cannot be built or simulated.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Bench(#[from] BenchError),
    /// The scene shades nothing.
    #[error("there is nothing to measure: no pixel of the frame is shaded")]
    #[diagnostic(code(specula::measure::empty), help("choose a larger picture or another scene"))]
    NoPixels,
    /// An engine's pixels differ from the model's.
    #[error(
        "{config} is wrong: over {spans} spans the sums of its codes are {given:?}, and the model's are {expected:?}"
    )]
    #[diagnostic(
        code(specula::measure::sums),
        help("this is a fault of Specula's: please report it with the scene")
    )]
    WrongSums {
        /// The configuration that was measured.
        config: String,
        /// Spans shaded.
        spans: usize,
        /// The engine's sums, modulo 2^32.
        given: Vec<u32>,
        /// The model's sums.
        expected: Vec<u32>,
    },
    /// A waveform could not be written.
    #[error("{config} cannot write its waveform: {reason}")]
    #[diagnostic(
        code(specula::measure::file),
        help(
            "waveforms need some gigabytes in the temporary directory; the environment variable TMPDIR names another"
        )
    )]
    Waveform {
        /// The configuration that was measured.
        config: String,
        /// The operating system's error.
        reason: io::Error,
    },
    /// No folder for waveforms can be made.
    #[error("cannot make a temporary directory: {0}")]
    #[diagnostic(
        code(specula::measure::room),
        help("the environment variable TMPDIR names another")
    )]
    Scratch(io::Error),
}

impl From<SimError> for MeasureError {
    fn from(error: SimError) -> MeasureError {
        MeasureError::Bench(error.into())
    }
}

impl From<PacketError> for MeasureError {
    fn from(error: PacketError) -> MeasureError {
        MeasureError::Bench(error.into())
    }
}

impl From<BuildError> for MeasureError {
    fn from(error: BuildError) -> MeasureError {
        MeasureError::Bench(error.into())
    }
}
