//! Why Gappa gives no answer.
use miette::Diagnostic;
use thiserror::Error;

/// Why Gappa gives no answer.
#[derive(Debug, Error, Diagnostic)]
pub enum ProofError {
    /// It cannot be run.
    #[error("`gappa` cannot be run: {0}")]
    #[diagnostic(
        code(specula::prove::absent),
        help("install Gappa, from its own site or by the package `gappa`")
    )]
    NotRun(std::io::Error),
    /// It does not understand a script.
    #[error("Gappa does not understand a script: {said}\n{script}")]
    #[diagnostic(
        code(specula::prove::script),
        help("this is a fault of Specula's: please report it with the command")
    )]
    NotUnderstood {
        /// What it says.
        said: String,
        /// The script.
        script: String,
    },
}
