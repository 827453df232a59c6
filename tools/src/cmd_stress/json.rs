//! What came of the catalogue, for programs.
use serde::Serialize;
use specula_experiments::stress::limits::Reason;
use specula_experiments::stress::{Cell, Verdict};

use super::files::scene_of;
use super::{RowResult, Stress};
use crate::output::PROGRAM;

#[derive(Serialize)]
struct Report<'a> {
    /// Always `specula`: a later run recognises by it that the listed files are its own.
    program: &'static str,
    version: &'static str,
    seed: u64,
    /// Random ones of each row.
    spans: u32,
    /// How many methods in rows come to what.
    hold: usize,
    at_limit: usize,
    at_fault: usize,
    /// What the limits are.
    limits: Vec<Limit>,
    rows: Vec<Row<'a>>,
    files: &'a [String],
}

#[derive(Serialize)]
struct Row<'a> {
    row: &'a str,
    input: &'a str,
    verdict: Option<Verdict>,
    methods: Vec<OfMethod<'a>>,
}

/// A reason for which a method may be off, and by how much.
#[derive(Serialize)]
struct Limit {
    reason: Reason,
    text: &'static str,
}

#[derive(Serialize)]
struct OfMethod<'a> {
    verdict: Option<Verdict>,
    #[serde(flatten)]
    cell: &'a Cell,
    /// File that `run` takes.
    scene: Option<String>,
}

/// The report as text.
pub fn text(stress: &Stress, files: &[String]) -> serde_json::Result<String> {
    let rows: Vec<Row> = stress.rows.iter().map(row).collect();
    let cells = || stress.rows.iter().flat_map(|row| &row.cells);
    let number = |verdict: Verdict| cells().filter(|cell| cell.verdict() == Some(verdict)).count();
    let [hold, at_limit, at_fault] = [Verdict::Holds, Verdict::Limit, Verdict::Fault].map(number);
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
        .map(|cell| OfMethod { verdict: cell.verdict(), cell, scene: scene_of(cell) })
        .collect();
    Row { row: row.id, input: row.input, verdict: row.verdict(), methods }
}
