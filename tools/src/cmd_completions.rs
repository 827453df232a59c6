//! `specula completions`: what a shell completes on the command line.
use std::io::Write;

use clap::{Args, CommandFactory};
use clap_complete::{Shell, generate};

use crate::cli::Cli;
use crate::error::ToolError;
use crate::verdict::Verdict;

const EXAMPLE: &str = "\
Example: specula completions bash > ~/.local/share/bash-completion/completions/specula";

/// Arguments of `completions`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// The shell
    #[arg(value_enum)]
    shell: Shell,
}

/// Prints the shell's script.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let mut script = Vec::new();
    generate(arguments.shell, &mut Cli::command(), "specula", &mut script);
    stdout.write_all(&script).and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}
