//! The results of the catalogue as JSON.
use serde::Serialize;
use specula_experiments::stress::limits::Reason;
use specula_experiments::stress::{Cell, RowVerdict};

use super::results::{RowResult, Stress};
use super::scene_files::scene_of;
use crate::output::PROGRAM;

#[derive(Serialize)]
struct Report<'a> {
    /// Always `specula`: by it a later run recognises that the listed files are its own.
    program: &'static str,
    version: &'static str,
    seed: u64,
    /// Number of random spans in each row.
    spans: u32,
    /// Number of cells, that is, of methods in rows, with each verdict.
    hold: usize,
    at_limit: usize,
    at_fault: usize,
    /// Explanations of the limits.
    limits: Vec<Limit>,
    rows: Vec<Row<'a>>,
    files: &'a [String],
}

#[derive(Serialize)]
struct Row<'a> {
    row: &'a str,
    input: &'a str,
    verdict: Option<RowVerdict>,
    methods: Vec<MethodFacts<'a>>,
}

/// A reason why a method may be inexact, and by how much.
#[derive(Serialize)]
struct Limit {
    reason: Reason,
    text: &'static str,
}

#[derive(Serialize)]
struct MethodFacts<'a> {
    verdict: Option<RowVerdict>,
    #[serde(flatten)]
    cell: &'a Cell,
    /// Scene file for `run`.
    scene: Option<String>,
}

/// The report as JSON text.
pub fn text(stress: &Stress, files: &[String]) -> serde_json::Result<String> {
    let rows: Vec<Row> = stress.rows.iter().map(row).collect();
    let cells = || stress.rows.iter().flat_map(|row| &row.cells);
    let number =
        |verdict: RowVerdict| cells().filter(|cell| cell.verdict() == Some(verdict)).count();
    let [hold, at_limit, at_fault] =
        [RowVerdict::Holds, RowVerdict::Limit, RowVerdict::Fault].map(number);
    let limits = Reason::ALL.map(|reason| Limit { reason, text: reason.text() }).into();
    let (version, seed, spans) = (env!("CARGO_PKG_VERSION"), stress.seed, stress.spans);
    let mut text = serde_json::to_string_pretty(&Report {
        program: PROGRAM,
        version,
        seed,
        spans,
        hold,
        at_limit,
        at_fault,
        limits,
        rows,
        files,
    })?;
    text.push('\n');
    Ok(text)
}

fn row(row: &RowResult) -> Row<'_> {
    let methods = row
        .cells
        .iter()
        .map(|cell| MethodFacts { verdict: cell.verdict(), cell, scene: scene_of(cell) })
        .collect();
    Row { row: row.id, input: row.input, verdict: row.verdict(), methods }
}
