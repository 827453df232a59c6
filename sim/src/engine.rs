//! What every engine offers.
use specula_hdl::design::NodeId;

use crate::{Columns, Stimulus};

/// Whether a run goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flow {
    /// Go on.
    Continue,
    /// The rest is not wanted.
    Stop,
}

/// Something that runs an elaborated design clock by clock.
pub trait Engine {
    /// Its name, as `--engine` takes it.
    fn name(&self) -> &'static str;

    /// Runs `stimulus` from reset to its last clock and hands the values of the `watched` signals to `sink`, batch after batch, until
    /// it has them all or `sink` stops it.
    ///
    /// # Errors
    /// [`SimError`] if the design does not settle or an external simulator fails.
    fn run(&mut self, stimulus: &Stimulus, watched: &[NodeId], sink: &mut dyn FnMut(&Columns) -> Flow) -> Result<(), SimError>;
}

/// Why a simulation did not come to its end.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SimError {
    /// rust-hdl found a fault in the design.
    #[error("rust-hdl's check of the design failed: {0}")]
    #[diagnostic(code(specula::sim::check), help("this is a fault of Specula's: please report it with the scene"))]
    Check(String),
    /// Signals kept changing.
    #[error("the design did not settle at clock {clock}")]
    #[diagnostic(code(specula::sim::settle), help("this is a fault of Specula's: please report it with the scene"))]
    Unsettled {
        /// The clock.
        clock: u64,
    },
}
