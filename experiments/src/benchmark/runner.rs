//! The interface of engines that a measurement times.
use super::checksum::Checksum;
use super::{Config, MeasureError};

/// An engine in a mode, ready to run.
pub(crate) trait Runner {
    /// The engine and its mode.
    fn config(&self) -> Config;

    /// Seconds from the spec of a core to the first values. A long start is measured once, a short
    /// one anew in each call.
    ///
    /// # Errors
    /// [`MeasureError`] if the engine fails.
    fn start_up(&mut self) -> Result<f64, MeasureError>;

    /// Shades the first `spans` spans of an endless sequence of frames.
    ///
    /// # Errors
    /// [`MeasureError`] if the engine fails.
    fn run(&mut self, spans: usize) -> Result<Timed, MeasureError>;
}

/// A run that has been timed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Timed {
    /// Duration in seconds.
    pub seconds: f64,
    /// Number of clocks simulated.
    pub clocks: u64,
    /// Checksum of the codes of all pixels.
    pub checksum: Checksum,
}
