//! Why a command was not done.
use std::io;
use std::path::{Path, PathBuf};

use miette::Diagnostic;
use specula_experiments::benchmark::MeasureError;
use specula_experiments::search::NotFound;
use specula_experiments::tradeoff::{JournalError, SweepError};
use specula_scene::SceneError;
use specula_testbench::BenchError;
use thiserror::Error;

use crate::cmd_explore::NothingExplored;
use crate::device::DoesNotFit;
use crate::task::Refused;
use specula_wave::WaveError;

/// Why a command was not done; nothing has been written then.
#[derive(Debug, Error, Diagnostic)]
pub enum ToolError {
    /// The scene cannot be used.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scene(Box<SceneError>),
    /// The core cannot be built or run.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Bench(#[from] BenchError),
    /// Engines cannot be measured.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Measure(Box<MeasureError>),
    /// No core is as good as was asked for.
    #[error(transparent)]
    #[diagnostic(transparent)]
    NotFound(#[from] NotFound),
    /// A sweep was not finished.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Sweep(#[from] SweepError),
    /// Results of a sweep cannot be kept.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Journal(#[from] JournalError),
    /// No core can be built for the scene.
    #[error("there is nothing to compare\n{reasons}")]
    #[diagnostic(
        code(specula::compare::nothing),
        help("choose other methods, or formats nearer to the default")
    )]
    NothingToCompare {
        /// Each configuration with its reason.
        reasons: String,
    },
    /// No core that was tried is as good as was asked for.
    #[error(transparent)]
    #[diagnostic(transparent)]
    NothingExplored(#[from] NothingExplored),
    /// A core takes more than the device has.
    #[error(transparent)]
    #[diagnostic(transparent)]
    DoesNotFit(#[from] DoesNotFit),
    /// A core lacks what the scene needs.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Refused(#[from] Refused),
    /// A result cannot be put into JSON.
    #[error("the result cannot be written as JSON: {0}")]
    #[diagnostic(
        code(specula::json),
        help("this is a fault of Specula's: please report it with the command")
    )]
    Json(serde_json::Error),
    /// A plot cannot be drawn.
    #[error(transparent)]
    #[diagnostic(
        code(specula::plot),
        help("this is a fault of Specula's: please report it with the command")
    )]
    Plot(#[from] crate::plot::PlotError),
    /// The output folder cannot be used.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Output(#[from] OutputError),
    /// A waveform cannot be drawn.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Wave(#[from] WaveError),
    /// `--name` asks for what cannot be a module's name.
    #[error("the core cannot be called `{}`", name.escape_debug())]
    #[diagnostic(
        code(specula::name),
        help(
            "write small letters, digits and single underscores between them, 48 at most, no digit first, and neither a port of the core's nor a word that Verilog or VHDL keeps, such as `--name {possible}`"
        )
    )]
    Name {
        /// What was asked for.
        name: String,
        /// A name that is like it and possible.
        possible: String,
    },
    /// `--trace` asks for what the run does not have.
    #[error("there is no {asked} to trace: the run has {there}")]
    #[diagnostic(code(specula::trace), help("choose among those, or `--trace worst`"))]
    Trace {
        /// What was asked for.
        asked: String,
        /// What there is.
        there: String,
    },
    /// Standard output cannot be written.
    #[error("standard output cannot be written: {0}")]
    #[diagnostic(code(specula::stdout))]
    Print(io::Error),
}

impl From<SceneError> for ToolError {
    fn from(error: SceneError) -> ToolError {
        ToolError::Scene(Box::new(error))
    }
}

impl From<MeasureError> for ToolError {
    fn from(error: MeasureError) -> ToolError {
        ToolError::Measure(Box::new(error))
    }
}

/// Why the output folder cannot be used.
#[derive(Debug, Error, Diagnostic)]
pub enum OutputError {
    /// There is something that is not a folder.
    #[error("output folder `{}`: `{}` is not a folder", folder.display(), at.display())]
    #[diagnostic(
        code(specula::output::file),
        help("name a folder that is not there yet, or one that Specula wrote, with `-o`")
    )]
    NotAFolder {
        /// The folder asked for.
        folder: PathBuf,
        /// What is in the way.
        at: PathBuf,
    },
    /// The folder holds files of somebody else's.
    #[error("output folder `{}` holds `{foreign}` and no report of Specula's: it is somebody else's", folder.display())]
    #[diagnostic(
        code(specula::output::foreign),
        help(
            "name an empty folder, one that is not there yet, or one that Specula wrote, with `-o`"
        )
    )]
    Foreign {
        /// The folder asked for.
        folder: PathBuf,
        /// A file in it.
        foreign: String,
    },
    /// A file of somebody else's has the name of one that would be written.
    #[error("output folder `{}` holds `{name}`, which Specula did not write and would replace", folder.display())]
    #[diagnostic(
        code(specula::output::in_the_way),
        help("move or rename `{name}`, or name another folder with `-o`")
    )]
    InTheWay {
        /// The folder asked for.
        folder: PathBuf,
        /// The name of the file in it.
        name: String,
    },
    /// The folder holds a run's results, and the Verilog in it belongs to them.
    #[error("output folder `{}` holds the results of a run with another core", folder.display())]
    #[diagnostic(
        code(specula::output::core),
        help("name another folder with `-o`, or let `specula run` replace it")
    )]
    OtherCore {
        /// The folder asked for.
        folder: PathBuf,
    },
    /// The folder would have to be replaced while somebody stands in it.
    #[error("output folder `{}` is the current folder, or one above it, and would be replaced", folder.display())]
    #[diagnostic(code(specula::output::current), help("name another folder with `-o`"))]
    Current {
        /// The folder asked for.
        folder: PathBuf,
    },
    /// The system refuses.
    #[error("cannot write `{}`: {reason}", path.display())]
    #[diagnostic(
        code(specula::output::system),
        help(
            "check the folder's name, its permissions and the room on the disk, or name another with `-o`"
        )
    )]
    System {
        /// What was to be written.
        path: PathBuf,
        /// Why not.
        reason: io::Error,
    },
    /// Not everything that belongs into the output folder is in it yet.
    #[error("`{}` could not be moved into the output folder: {reason}", path.display())]
    #[diagnostic(
        code(specula::output::kept),
        help("it is safe there: the next run tries again, or move it by hand")
    )]
    Kept {
        /// Where it is.
        path: PathBuf,
        /// Why it could not be moved.
        reason: io::Error,
    },
}

impl OutputError {
    /// What the system says of `path`.
    pub fn system(path: &Path) -> impl FnOnce(io::Error) -> OutputError + '_ {
        move |reason| OutputError::System { path: path.to_owned(), reason }
    }
}
