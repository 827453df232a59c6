//! `specula methods`: the shading methods.
mod json;

use std::io::Write;

use clap::Args;
use specula_spec::Method;

use crate::error::ToolError;
use crate::table;
use crate::verdict::Verdict;

const EXAMPLE: &str = "\
With --json each method has its source, its requirements on a scene, its options, and the formats, \
the latency in clocks, the operations per pixel (also with each value of each option) and the size \
of its core for the built-in teapot.

Example: specula methods --json";

/// Arguments of `methods`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// Print JSON instead of a table
    #[arg(long)]
    json: bool,
}

/// Prints a line for each method, or everything that is known about each as JSON.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let text = if arguments.json { json::text()? } else { lines() };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

fn lines() -> String {
    table::shown(&Method::ALL.map(|method| [method.name().to_owned(), method.summary().to_owned()]))
}
