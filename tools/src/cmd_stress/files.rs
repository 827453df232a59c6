//! The files that `stress` writes.
use std::fs;
use std::io;

use specula_experiments::stress::{CATALOGUE, RAW};
use specula_spec::Method;

use super::results::Stress;
use super::scene_files::{scene_name, scene_of};
use super::{json, plots, table};
use crate::error::ToolError;
use crate::output::{Destination, MARKDOWN, REPORT, Staging};

/// Every file that may be written.
pub fn possible_names(methods: &[Method]) -> Vec<String> {
    let ids = CATALOGUE.iter().map(|row| row.id).chain([RAW]);
    let scenes = ids.flat_map(|id| methods.iter().map(move |method| scene_name(id, method.name())));
    [MARKDOWN, REPORT].map(str::to_owned).into_iter().chain(plots::names()).chain(scenes).collect()
}

/// Writes all files and returns the JSON report.
pub fn write(destination: &Destination, stress: &Stress) -> Result<String, ToolError> {
    let staging = destination.stage()?;
    let put =
        |name: &str, text: &str| fs::write(staging.file(name), text).map_err(staging.failed(name));
    let mut files = vec![MARKDOWN.to_owned(), REPORT.to_owned()];
    for (name, svg) in plots::all()? {
        put(&name, &svg)?;
        files.push(name);
    }
    for cell in stress.rows.iter().flat_map(|row| &row.cells) {
        if let (Some(name), Some(text)) = (scene_of(cell), &cell.reproducer) {
            put(&name, text)?;
            files.push(name);
        }
    }
    put(MARKDOWN, &table::markdown(stress))?;
    let report = json::text(stress, &files).map_err(|error| unwritten(&staging, error))?;
    put(REPORT, &report)?;
    staging.publish()?;
    Ok(report)
}

fn unwritten(staging: &Staging, error: serde_json::Error) -> ToolError {
    staging.failed(REPORT)(io::Error::other(error)).into()
}
