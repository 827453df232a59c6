//! What came of the catalogue, for programs.
use serde::Serialize;
use specula_testbench::stress::Cell;

use super::files::scene_of;
use super::{RowResult, Stress};
use crate::output::PROGRAM;

#[derive(Serialize)]
struct Report<'a> {
    /// Specula: whoever replaces the folder sees by it whose files are listed.
    program: &'static str,
    version: &'static str,
    seed: u64,
    /// Random ones of each row.
    spans: u32,
    holds: bool,
    rows: Vec<Row<'a>>,
    files: &'a [String],
}

#[derive(Serialize)]
struct Row<'a> {
    row: &'a str,
    input: &'a str,
    wanted: &'a str,
    holds: bool,
    methods: Vec<OfMethod<'a>>,
}

#[derive(Serialize)]
struct OfMethod<'a> {
    #[serde(flatten)]
    cell: &'a Cell,
    /// File that `run` takes.
    scene: Option<String>,
}

/// The report as text.
pub fn text(stress: &Stress, files: &[String]) -> serde_json::Result<String> {
    let rows: Vec<Row> = stress.rows.iter().map(row).collect();
    let holds = rows.iter().all(|row| row.holds);
    let (version, seed, spans) = (env!("CARGO_PKG_VERSION"), stress.seed, stress.spans);
    let mut text = serde_json::to_string_pretty(&Report { program: PROGRAM, version, seed, spans, holds, rows, files })?;
    text.push('\n');
    Ok(text)
}

fn row(row: &RowResult) -> Row<'_> {
    let methods = row.cells.iter().map(|cell| OfMethod { cell, scene: scene_of(cell) }).collect();
    Row { row: row.id, input: row.input, wanted: row.wanted, holds: row.holds(), methods }
}
