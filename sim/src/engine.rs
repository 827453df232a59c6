//! What every engine offers.
use specula_datapath::design::NodeId;

use crate::{Batch, Stimulus};

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

    /// Runs `stimulus` from reset to its last clock and hands the values of the `watched` signals
    /// to `sink`, batch after batch, until it has them all or `sink` stops it.
    ///
    /// # Errors
    /// [`SimError`] if the design does not settle or an external simulator fails.
    fn run(
        &mut self,
        stimulus: &Stimulus,
        watched: &[NodeId],
        sink: &mut dyn FnMut(&Batch) -> Flow,
    ) -> Result<(), SimError>;
}

/// Why a simulation did not come to its end.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SimError {
    /// rust-hdl found a fault in the design.
    #[error("rust-hdl's check of the design failed: {0}")]
    #[diagnostic(
        code(specula::sim::check),
        help("this is a fault of Specula's: please report it with the scene")
    )]
    Check(String),
    /// Signals kept changing.
    #[error("the design did not settle at clock {clock}")]
    #[diagnostic(
        code(specula::sim::settle),
        help("this is a fault of Specula's: please report it with the scene")
    )]
    Unsettled {
        /// The clock.
        clock: u64,
    },
    /// An external tool is not installed.
    #[error("{tool} is not installed: there is no program `{command}` on the search path")]
    #[diagnostic(code(specula::sim::absent), help("{install}, or {otherwise}"))]
    ToolAbsent {
        /// What people call it.
        tool: &'static str,
        /// The program looked for.
        command: &'static str,
        /// How to get it.
        install: &'static str,
        /// What does without it.
        otherwise: &'static str,
    },
    /// An external tool failed, or had something to complain of.
    #[error("`{command}` failed or gave a warning ({status}):\n{output}")]
    #[diagnostic(
        code(specula::sim::tool),
        help(
            "Specula's Verilog is meant to pass without a warning: if the tool is complete, please report this with the scene"
        )
    )]
    ToolFailed {
        /// The command line.
        command: String,
        /// How it ended.
        status: String,
        /// What it printed.
        output: String,
    },
    /// An external simulator left a signal out of its trace.
    #[error("{tool} does not trace the signal `{signal}`")]
    #[diagnostic(
        code(specula::sim::untraced),
        help("this is a fault of Specula's: please report it with the scene")
    )]
    Untraced {
        /// The simulator.
        tool: &'static str,
        /// Full name of the signal.
        signal: String,
    },
    /// An external simulator came to its end too early.
    #[error(
        "{tool} gave no values from clock {missing} on, and the stimulus goes on to clock {end}"
    )]
    #[diagnostic(
        code(specula::sim::short),
        help("look whether the disk of the temporary directory is full")
    )]
    TooFewClocks {
        /// The simulator.
        tool: &'static str,
        /// The first clock without values.
        missing: u64,
        /// The clock behind the last of the stimulus.
        end: u64,
    },
    /// A file of a simulation could not be written or read.
    #[error("cannot {doing}: {source}")]
    #[diagnostic(
        code(specula::sim::file),
        help(
            "simulations need room in the temporary directory; the environment variable TMPDIR names another"
        )
    )]
    File {
        /// What was tried.
        doing: String,
        /// What the system says.
        source: std::io::Error,
    },
}

impl SimError {
    /// The error of having failed at `doing`.
    pub fn file(doing: impl Into<String>) -> impl FnOnce(std::io::Error) -> SimError {
        let doing = doing.into();
        move |source| SimError::File { doing, source }
    }
}
