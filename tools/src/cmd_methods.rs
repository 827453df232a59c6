//! `specula methods`: the shading methods.
use std::io::Write;

use specula_scene::Method;

use crate::cli::Verdict;
use crate::error::ToolError;
use crate::table;

/// Prints a line for each method.
pub fn execute(stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    let rows = Method::ALL.map(|method| [method.name().to_owned(), method.summary().to_owned()]);
    write!(stdout, "{}", table::lines(&rows)).map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}
