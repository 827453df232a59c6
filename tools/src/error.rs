//! The reasons why a command fails.
use std::io;
use std::path::PathBuf;

use miette::Diagnostic;
use specula_experiments::KeepError;
use specula_experiments::auto::AutoError;
use specula_experiments::benchmark::MeasureError;
use specula_experiments::formats::{NotProven, SequenceError};
use specula_experiments::search::NotFound;
use specula_experiments::tradeoff::{JournalError, SweepError};
use specula_flow::stream::Stuck;
use specula_flow::synth::SynthError;
use specula_proof::ProofError;
use specula_scene::SceneError;
use specula_spec::{CoreError, SpecError};
use specula_testbench::BenchError;
use thiserror::Error;

use crate::output::OutputError;
use specula_wave::WaveError;

/// The reason why a command failed. Nothing has been written then.
#[derive(Debug, Error, Diagnostic)]
pub enum ToolError {
    /// The scene cannot be used.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scene(Box<SceneError>),
    /// There is no core for the scene.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Core(Box<CoreError>),
    /// The core cannot be built or run.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Bench(#[from] BenchError),
    /// Engines cannot be measured.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Measure(Box<MeasureError>),
    /// A core cannot be synthesised, placed or routed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Synth(#[from] SynthError),
    /// A core is made for a target that no open place-and-route is known for.
    #[error("a core for `{target}` cannot be placed and routed here")]
    #[diagnostic(code(specula::synth::target), help("cores for {known} can be"))]
    NotPlaceable {
        /// The target.
        target: String,
        /// The targets for which it can.
        known: String,
    },
    /// Gappa cannot be asked.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Proof(#[from] ProofError),
    /// No core is as exact as the user asked for.
    #[error(transparent)]
    #[diagnostic(transparent)]
    NotFound(#[from] NotFound),
    /// No method has a core for the scene.
    #[error(transparent)]
    #[diagnostic(transparent)]
    NoMethod(AutoError),
    /// An error is to be measured on a scene of which no single frame stands for all.
    #[error(
        "formats cannot be chosen by errors that are measured, as the scene has several frames"
    )]
    #[diagnostic(
        code(specula::sequence::measured),
        help("ask for a proven error with `--bound`: it holds for every frame")
    )]
    MeasuredSequence,
    /// No core is proven as exact as the user asked for.
    #[error(transparent)]
    #[diagnostic(transparent)]
    NotProven(#[from] NotProven),
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
        /// The configurations, each with its reason.
        reasons: String,
    },
    /// No core that was tried is as exact as the user asked for.
    #[error(transparent)]
    #[diagnostic(transparent)]
    NothingExplored(#[from] NothingExplored),
    /// A core takes more than the device has.
    #[error(transparent)]
    #[diagnostic(transparent)]
    DoesNotFit(#[from] DoesNotFit),
    /// A core is made for a target that its device does not belong to.
    #[error(transparent)]
    #[diagnostic(transparent)]
    OtherTarget(#[from] OtherTarget),
    /// A core lacks what the scene needs.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Refused(#[from] Refused),
    /// Nothing says on which scene a core from a file is to be simulated.
    #[error("there is no scene to simulate the core on")]
    #[diagnostic(
        code(specula::synth::scene),
        help(
            "name one that the core can shade, such as `--simulate=teapot` or `--vectors teapot`"
        )
    )]
    NoScene,
    /// There are no spans for a bench.
    #[error("no triangle of `{scene}` is to be seen, so there are no packets for a bench")]
    #[diagnostic(code(specula::generate::vectors), help("turn the camera, or name another scene"))]
    NoVectors {
        /// The scene.
        scene: String,
    },
    /// A stream top stands still.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Stuck(#[from] Stuck),
    /// Directions leave a core that is to have streams.
    #[error("pixels in a stream have no place for the directions that leave this core")]
    #[diagnostic(
        code(specula::stream::directions),
        help(
            "leave out `directions` of `[core.consistent]`, or take the core itself: `generate` without `--ip`, `run` without `--top axis`"
        )
    )]
    DirectionsInStream,
    /// Several files are to go to standard output.
    #[error("a block is many files, which standard output cannot take")]
    #[diagnostic(
        code(specula::generate::folder),
        help("name a folder with `--output`, or leave out `--ip`")
    )]
    FolderNeeded,
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
    /// `--name` asks for a name that a module cannot have.
    #[error("the core cannot be called `{}`", name.escape_debug())]
    #[diagnostic(
        code(specula::name),
        help(
            "write small letters, digits and single underscores between them, 48 at most, no digit first, and neither a port of the core's nor a word that Verilog or VHDL keeps, such as `--name {possible}`"
        )
    )]
    Name {
        /// The name asked for.
        name: String,
        /// A similar name that is possible.
        possible: String,
    },
    /// `--trace` asks for clocks or a span that the run does not have.
    #[error("there is no {asked} to trace: the run has {there}")]
    #[diagnostic(code(specula::trace), help("choose among those, or `--trace worst`"))]
    Trace {
        /// What the user asked for.
        asked: String,
        /// What the run has.
        there: String,
    },
    /// There is a file where a new one is to be written.
    #[error("{} is there already", path.display())]
    #[diagnostic(code(specula::new), help("choose another name, or remove it"))]
    Exists {
        /// The file.
        path: PathBuf,
    },
    /// There is no such subcommand.
    #[error("there is no subcommand `{}`", name.escape_debug())]
    #[diagnostic(code(specula::manual), help("there are {known}"))]
    NoSuchCommand {
        /// The name asked for.
        name: String,
        /// The subcommands that there are.
        known: String,
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

impl From<CoreError> for ToolError {
    fn from(error: CoreError) -> ToolError {
        ToolError::Core(Box::new(error))
    }
}

impl From<KeepError> for ToolError {
    fn from(error: KeepError) -> ToolError {
        match error {
            KeepError::Core(error) => error.into(),
            KeepError::Bench(error) => error.into(),
        }
    }
}

impl From<AutoError> for ToolError {
    fn from(error: AutoError) -> ToolError {
        match error {
            AutoError::Core(error) => error.into(),
            AutoError::Bench(error) => error.into(),
            AutoError::Nothing => ToolError::NoMethod(error),
        }
    }
}

impl From<SequenceError> for ToolError {
    fn from(error: SequenceError) -> ToolError {
        match error {
            SequenceError::Scene(error) => error.into(),
            SequenceError::Bench(error) => error.into(),
        }
    }
}

impl From<MeasureError> for ToolError {
    fn from(error: MeasureError) -> ToolError {
        ToolError::Measure(Box::new(error))
    }
}

/// None of the cores that were tried is close enough to exact shading.
#[derive(Debug, Error, Diagnostic)]
#[error("none of the cores that were tried is within {wanted} LSB of exact shading; {nearest}")]
#[diagnostic(
    code(specula::explore),
    help(
        "ask for a larger error, for other methods or for a larger device; rounding to 8 bits alone takes up to 0.5 LSB"
    )
)]
pub struct NothingExplored {
    /// The largest total error asked for, in LSBs.
    pub wanted: f64,
    /// How close the closest core comes, or why there is none.
    pub nearest: String,
}

/// A core takes more than the device has.
#[derive(Debug, Error, Diagnostic)]
#[error("the core does not fit {taken}")]
#[diagnostic(
    code(specula::device),
    help(
        "`specula explore SCENE --max-error 2lsb --device {device}` looks for a core that fits; narrower formats (`--bound`, `--max-error`) or another method may; {larger}"
    )
)]
pub struct DoesNotFit {
    /// Name of the device.
    pub device: String,
    /// The device, with the resources that the core takes and those that it has.
    pub taken: String,
    /// The name of a larger device that has enough, if one is known.
    pub larger: String,
}

/// A core is made for a target that its device does not belong to.
#[derive(Debug, Error, Diagnostic)]
#[error("`{device}` is a device of the target `{own}`, and the core is for `{target}`")]
#[diagnostic(
    code(specula::device::target),
    help("leave `--target` out, or name a device of `{target}`")
)]
pub struct OtherTarget {
    /// Name of the device.
    pub device: String,
    /// Its target.
    pub own: String,
    /// The target that the core is made for.
    pub target: String,
}

/// A core lacks something that the scene it is to shade needs.
#[derive(Debug, Error, Diagnostic)]
#[error("the core `{}` cannot shade `{scene}`: {error}", core.display())]
#[diagnostic(forward(error))]
pub struct Refused {
    /// Path of the core.
    pub core: PathBuf,
    /// The scene.
    pub scene: String,
    /// What the core lacks.
    pub error: SpecError,
}
