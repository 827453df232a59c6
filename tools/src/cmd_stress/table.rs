//! The results of the catalogue as text.
use std::fmt::Write;
use std::path::Path;

use specula_experiments::stress::limits::Reason;
use specula_experiments::stress::{Cell, Requirement, RowVerdict, Worst, row_requirements};

use super::results::{RowResult, Stress};
use super::scene_files::scene_of;
use crate::table;

/// The text that `stress` prints.
pub fn text(stress: &Stress, folder: &Path) -> String {
    let titles = [
        "row",
        "",
        "pixels",
        "of bound",
        "holds",
        "limit: LSB that came of the most; worst LSB where there is no limit",
    ];
    let rows: Vec<[String; 6]> =
        [titles.map(str::to_owned)].into_iter().chain(stress.rows.iter().map(line)).collect();
    let faults: String = stress.rows.iter().flat_map(faults).collect();
    format!(
        "{}\n{faults}{}\nWhat is asked of each method, and why it may be off, is in report.md.\n\
         seed {}; scenes, plots and report in {}\n",
        table::shown(&rows),
        summary(stress),
        stress.seed,
        folder.display()
    )
}

/// The number of cells with each verdict.
fn summary(stress: &Stress) -> String {
    let cells = || stress.rows.iter().flat_map(|row| &row.cells);
    let number =
        |verdict: RowVerdict| cells().filter(|cell| cell.verdict() == Some(verdict)).count();
    let [hold, limit, fault] =
        [RowVerdict::Holds, RowVerdict::Limit, RowVerdict::Fault].map(number);
    let faults =
        if fault == 0 { "none is at fault".to_owned() } else { format!("{fault} ARE AT FAULT") };
    format!(
        "Of {} methods in rows {hold} hold, {limit} are at a documented limit, {faults}.",
        cells().count()
    )
}

fn line(row: &RowResult) -> [String; 6] {
    let pixels: u64 = row.cells.iter().map(|cell| cell.pixels).sum();
    let share = row.cells.iter().filter_map(share_of_bound).fold(0.0, f64::max);
    [
        row.id.to_owned(),
        row.verdict().map_or("refused", RowVerdict::name).to_owned(),
        pixels.to_string(),
        if share > 0.0 { format!("{share:.2}") } else { String::new() },
        holding(row),
        limits(row),
    ]
}

/// The share of the proven bound that the measured quantisation error reaches.
fn share_of_bound(cell: &Cell) -> Option<f64> {
    let shares = cell
        .asked
        .iter()
        .filter(|asked| asked.is_bounded_quantisation())
        .filter_map(|asked| Some(asked.came / asked.most?));
    shares.reduce(f64::max)
}

fn holding(row: &RowResult) -> String {
    let holding = row.cells.iter().filter(|cell| cell.verdict() == Some(RowVerdict::Holds));
    let methods: Vec<&str> = holding.map(|cell| cell.method.unwrap_or("host")).collect();
    if methods.len() == row.cells.len() && methods.len() > 1 {
        "all".to_owned()
    } else {
        methods.join(" ")
    }
}

/// The methods at their limits, each with its figures.
fn limits(row: &RowResult) -> String {
    let at = |cell: &Cell| {
        let figures: Vec<String> =
            of_verdict(cell, RowVerdict::Limit).map(Requirement::figure).collect();
        (!figures.is_empty())
            .then(|| format!("{} {}", cell.method.unwrap_or("host"), figures.join(", ")))
    };
    row.cells.iter().filter_map(at).collect::<Vec<_>>().join("; ")
}

fn of_verdict(cell: &Cell, verdict: RowVerdict) -> impl Iterator<Item = &Requirement> {
    cell.asked.iter().filter(move |asked| asked.verdict() == verdict)
}

fn faults(row: &RowResult) -> impl Iterator<Item = String> + '_ {
    row.cells.iter().flat_map(move |cell| {
        let scene = scene_of(cell).map_or(String::new(), |scene| format!("; see {scene}"));
        of_verdict(cell, RowVerdict::Fault)
            .map(move |asked| format!("row {}, {}: {}{scene}\n", row.id, asked.core, fault(asked)))
    })
}

fn fault(asked: &Requirement) -> String {
    let place = asked
        .place
        .map_or(String::new(), |place| format!(", span {} pixel {}", place.span, place.pixel));
    let detail = asked.detail.as_ref().map_or(String::new(), |detail| format!(" ({detail})"));
    format!("{}: {}{detail}{place}", asked.what, came_of_most(asked))
}

fn came_of_most(asked: &Requirement) -> String {
    let number =
        |value: f64| if value.fract() == 0.0 { format!("{value}") } else { format!("{value:.3}") };
    match asked.most {
        Some(most) => format!("{} came, {} may", number(asked.came), number(most)),
        None => format!("{} came, nothing bounds it", number(asked.came)),
    }
}

/// The text of `report.md`.
pub fn markdown(stress: &Stress) -> String {
    let mut text = format!(
        "# Stress\n\nSeed {}, {} random spans in each row. {}\n\nA method holds in a row if all that is asked of it happens and no \
         pixel is more than 1 LSB from exact shading; it is at its limit if it is farther off for a reason listed below, by no more \
         than that allows; anything else is a fault. Each line is of all cores of a method together, and its figures are those of the \
         core that comes nearest to what may come.\n\n![f32](drift_f32.svg)\n\n![short formats](drift_fixed.svg)\n\n\
         ![chosen formats](drift_chosen.svg)\n\n",
        stress.seed,
        stress.spans,
        summary(stress)
    );
    let titles = [
        "row",
        "input",
        "asked besides what is asked everywhere",
        "came to",
        "of bound",
        "holds",
        "limit",
    ];
    let rows: Vec<[String; 7]> = stress.rows.iter().map(overview).collect();
    text.push_str(&table::markdown(titles, &rows));
    text.push_str("\n## Limits\n\n");
    let reasons: Vec<[String; 2]> =
        Reason::ALL.map(|reason| [reason.name(), reason.text()].map(str::to_owned)).into();
    text.push_str(&table::markdown(["reason", "by how much"], &reasons));
    stress.rows.iter().for_each(|row| text.push_str(&section(row)));
    text
}

fn overview(row: &RowResult) -> [String; 7] {
    let [id, verdict, _, share, holds, limits] = line(row);
    let cells: Vec<&Cell> = row.cells.iter().collect();
    [id, row.input.to_owned(), row_requirements(&cells), verdict, share, holds, limits]
}

/// What was asked of each method in a row, and the result.
fn section(row: &RowResult) -> String {
    let mut text = format!("\n## Row {}\n\n{}\n\n", row.id, row.input);
    let titles = ["method", "asked", "cores", "may come", "came", "verdict", "why", "core"];
    let lines: Vec<[String; 8]> = row
        .cells
        .iter()
        .flat_map(|cell| cell.asked.iter().map(move |asked| asked_line(cell, asked)))
        .collect();
    text.push_str(&table::markdown(titles, &lines));
    for cell in &row.cells {
        let notes = notes(cell);
        if !notes.is_empty() {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "\n- {}: {}", cell.method.unwrap_or("host"), notes.join("; "));
        }
    }
    text
}

fn asked_line(cell: &Cell, asked: &Requirement) -> [String; 8] {
    let reasons: Vec<&str> = asked.reasons.iter().map(|reason| reason.name()).collect();
    let number =
        |value: f64| if value.fract() == 0.0 { format!("{value}") } else { format!("{value:.3}") };
    [
        cell.method.unwrap_or("host").to_owned(),
        asked.what.clone(),
        asked.cores.to_string(),
        asked.most.map_or("no limit".to_owned(), number),
        number(asked.came),
        asked.verdict().name().to_owned(),
        reasons.join(", "),
        asked.core.clone(),
    ]
}

/// Notes about a cell: its worst core, its scene, and what was not built.
fn notes(cell: &Cell) -> Vec<String> {
    let worst = cell.worst.as_ref().map(|Worst { core, total, method, quantisation, bound }| {
        let bound = bound.map_or("no bound".to_owned(), |bound| format!("bound {bound:.2}"));
        format!("worst {core}, {total:.2} LSB: {method:.2} of the method, {quantisation:.2} of quantisation ({bound})")
    });
    let scene = scene_of(cell).map(|scene| format!("[{scene}]({scene})"));
    let reported = (cell.reported > 0).then(|| {
        format!("{} patterns break a fact that hosts keep, which the bench reported", cell.reported)
    });
    let refused = cell.refused.iter().map(|reason| format!("not built: {reason}"));
    worst.into_iter().chain(scene).chain(reported).chain(refused).collect()
}
