//! What can go wrong between a scene and its pixels.
use specula_datapath::BuildError;
use specula_golden::fixed::PacketError;
use specula_sim::SimError;
use specula_spec::SpecError;

/// Why a bench cannot be run.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum BenchError {
    /// The spec's formats ask for too wide a signal.
    #[error("the core cannot be built: {0}")]
    #[diagnostic(
        code(specula::core::width),
        help("lower the fraction bits in the scene file's [core] table")
    )]
    TooWide(BuildError),
    /// A unit uses the builder wrongly.
    #[error("the core cannot be built: {0}")]
    #[diagnostic(
        code(specula::core::build),
        help("this is a fault of Specula's: please report it with the scene")
    )]
    Build(BuildError),
    /// No core can be built for the frame.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Spec(#[from] SpecError),
    /// The engine failed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Simulation(#[from] SimError),
    /// The model refused a span's set-up.
    #[error("a span was set up wrongly: {0}")]
    #[diagnostic(
        code(specula::core::packet),
        help("this is a fault of Specula's: please report it with the scene")
    )]
    Packet(PacketError),
}

impl From<BuildError> for BenchError {
    fn from(error: BuildError) -> BenchError {
        match error {
            BuildError::SignalTooWide { .. } => BenchError::TooWide(error),
            _ => BenchError::Build(error),
        }
    }
}

impl From<PacketError> for BenchError {
    fn from(error: PacketError) -> BenchError {
        BenchError::Packet(error)
    }
}
