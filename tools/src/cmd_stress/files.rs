//! What `stress` writes.
use std::fs;
use std::io;

use specula_experiments::stress::{CATALOGUE, Cell, RAW};
use specula_spec::Method;

use super::{Stress, json, plots, table};
use crate::error::ToolError;
use crate::output::{Destination, MARKDOWN, REPORT, Staging};

/// The name of a row's scene file for a method, such as `row_breaks_1_lyon.toml`.
pub fn scene_name(row: &str, method: &str) -> String {
    format!("row_{}_{method}.toml", row.replace(' ', "_"))
}

/// The scene file of a cell, if it has one.
pub fn scene_of(cell: &Cell) -> Option<String> {
    cell.reproducer.as_ref().and(cell.method).map(|method| scene_name(cell.row, method))
}

/// Every file that may be written.
pub fn possible_names(methods: &[Method]) -> Vec<String> {
    let ids = CATALOGUE.iter().map(|row| row.id).chain([RAW]);
    let scenes = ids.flat_map(|id| methods.iter().map(move |method| scene_name(id, method.name())));
    [MARKDOWN, REPORT].map(str::to_owned).into_iter().chain(plots::names()).chain(scenes).collect()
}

/// Writes everything; gives the JSON report.
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
