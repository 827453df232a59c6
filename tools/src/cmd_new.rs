//! `specula new`: a scene file to begin with.
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;

use crate::error::ToolError;
use crate::output::{Interrupts, write_file};
use crate::verdict::Verdict;

const TEMPLATE: &str = include_str!("new_scene.toml");

const EXAMPLE: &str = "\
The file says in comments what else could stand in it; docs/scene-format.md says all of it.

Example: specula new donut && specula run donut.toml";

/// Arguments of `new`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    /// The scene's name, or a path; the file's name ends in .toml
    #[arg(value_name = "NAME", value_parser = parse_path)]
    path: PathBuf,
}

/// Writes a scene file where there is none, and says how to go on.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let path = &arguments.path;
    if path.symlink_metadata().is_ok() {
        return Err(ToolError::Exists { path: path.clone() });
    }
    write_file(path, interrupts, |file| fs::write(file, TEMPLATE))?;
    let shown = path.display();
    writeln!(stdout, "{shown}: a torus under one light; `specula run {shown}` makes its core")
        .map_err(ToolError::Print)?;
    Ok(Verdict::Done)
}

/// A path to a scene file; one without an ending gets that of scene files.
fn parse_path(text: &str) -> Result<PathBuf, String> {
    let path = Path::new(text);
    let name = path.file_name().ok_or("write the name of a file, such as `donut`")?;
    match path.extension() {
        None => Ok(path.with_file_name(Path::new(name).with_extension("toml"))),
        Some(ending) if ending == "toml" => Ok(path.to_owned()),
        Some(_) => Err("write a name that ends in .toml, or in nothing".to_owned()),
    }
}
