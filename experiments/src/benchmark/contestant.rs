//! What takes part in a measurement.
use super::sums::Sums;
use super::{Entry, MeasureError};

/// An engine in a mode, ready to run.
pub(crate) trait Contestant {
    /// Which it is.
    fn entry(&self) -> Entry;

    /// Seconds from the spec of a core to the first values. What takes long is measured once, what
    /// takes short anew each time.
    ///
    /// # Errors
    /// [`MeasureError`] if the engine fails.
    fn start_up(&mut self) -> Result<f64, MeasureError>;

    /// Shades the first `spans` spans of an endless row of frames.
    ///
    /// # Errors
    /// [`MeasureError`] if the engine fails.
    fn run(&mut self, spans: usize) -> Result<Timed, MeasureError>;
}

/// A run that has been timed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Timed {
    /// Seconds.
    pub seconds: f64,
    /// Clocks simulated.
    pub clocks: u64,
    /// Sums of the codes of all pixels.
    pub sums: Sums,
}
