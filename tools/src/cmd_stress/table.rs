//! What came of the catalogue, for people.
use std::fmt::Write;
use std::path::Path;

use specula_testbench::stress::{Cell, Fault};

use super::files::scene_of;
use super::{RowResult, Stress};
use crate::table;

/// Errors of a method in exact arithmetic above this are told, in LSBs: it is the wrong method there.
const BAD: f64 = 1.0;

/// What `stress` prints.
pub fn text(stress: &Stress, folder: &Path) -> String {
    let titles = ["row", "", "pixels", "worst LSB", "of bound", "worst core; methods that are bad there"].map(str::to_owned);
    let rows: Vec<[String; 6]> = [titles].into_iter().chain(stress.rows.iter().map(line)).collect();
    let faults: String = stress.rows.iter().flat_map(faults).collect();
    let failed = stress.rows.iter().filter(|row| !row.holds()).count();
    let end = match failed {
        0 => "What is wanted happens in every row.".to_owned(),
        _ => format!("What is wanted does not happen in {failed} rows."),
    };
    format!("{}\n{faults}{end}\nseed {}; scenes, plots and report in {}\n", table::shown(&rows), stress.seed, folder.display())
}

fn line(row: &RowResult) -> [String; 6] {
    let pixels: u64 = row.cells.iter().map(|cell| cell.pixels).sum();
    let worst = worst(row);
    let share = row.cells.iter().map(|cell| cell.share_of_bound).fold(0.0, f64::max);
    [
        row.id.to_owned(),
        (if row.holds() { "holds" } else { "FAILS" }).to_owned(),
        pixels.to_string(),
        worst.map_or(String::new(), |worst| format!("{:.2}", worst.total)),
        if share > 0.0 { format!("{share:.2}") } else { String::new() },
        remark(row),
    ]
}

fn worst(row: &RowResult) -> Option<&specula_testbench::stress::Worst> {
    row.cells.iter().filter_map(|cell| cell.worst.as_ref()).max_by(|a, b| a.total.total_cmp(&b.total))
}

/// The core with the largest error, and methods that are bad by themselves.
fn remark(row: &RowResult) -> String {
    let bad = |cell: &Cell| {
        let method = cell.worst.as_ref().filter(|worst| worst.method > BAD)?.method;
        Some(format!("{} {method:.0}", cell.method?))
    };
    let bad: Vec<String> = row.cells.iter().filter_map(bad).collect();
    let core = worst(row).map_or(String::new(), |worst| worst.core.clone());
    if bad.is_empty() { core } else { format!("{core}; bad: {}", bad.join(", ")) }
}

fn faults(row: &RowResult) -> impl Iterator<Item = String> + '_ {
    row.cells.iter().filter_map(|cell| {
        let fault = cell.fault.as_ref()?;
        let core = cell.faulty.as_deref().unwrap_or("host");
        let scene = scene_of(cell).map_or(String::new(), |scene| format!("; see {scene}"));
        Some(format!("row {}, {core}: {}{scene}\n", row.id, place(fault)))
    })
}

fn place(fault: &Fault) -> String {
    format!("{}, span {} pixel {}", fault.what, fault.span, fault.pixel)
}

/// The report.
pub fn markdown(stress: &Stress) -> String {
    let mut text = format!(
        "# Stress\n\nSeed {}, {} random spans in each row. Everywhere it is wanted that pixels are the bit-true model's, each in its clock, \
         that stated facts hold, and that no error of quantisation is beyond its proven bound. *Bad* is a method whose error in exact \
         arithmetic is above {BAD} LSB there, in the core with its largest total error.\n\n![f32](drift_f32.svg)\n\n\
         ![short formats](drift_fixed.svg)\n\n![chosen formats](drift_chosen.svg)\n\n",
        stress.seed, stress.spans
    );
    let titles =
        ["row", "input", "wanted", "happened", "worst LSB", "of bound", "worst core and bad methods", "first bad pixel, scenes"];
    let rows: Vec<[String; 8]> = stress.rows.iter().map(markdown_line).collect();
    text.push_str(&table::markdown(titles, &rows));
    text.push_str("\n## Not built\n\n");
    for row in &stress.rows {
        for cell in row.cells.iter().filter(|cell| !cell.refused.is_empty() || cell.reported > 0) {
            let mut reasons = cell.refused.clone();
            if cell.reported > 0 {
                reasons.push(format!("{} patterns break a fact that hosts keep, which the bench reported", cell.reported));
            }
            // Writing to a String cannot fail.
            let _ = writeln!(text, "- row {}, {}: {}", row.id, cell.method.unwrap_or("host"), reasons.join("; "));
        }
    }
    text
}

fn markdown_line(row: &RowResult) -> [String; 8] {
    let [id, happened, _, worst, share, remark] = line(row);
    let faults: Vec<String> = row.cells.iter().filter_map(|cell| cell.fault.as_ref()).map(place).collect();
    let scenes: Vec<String> =
        row.cells.iter().filter_map(|cell| Some(format!("[{}]({})", cell.method?, scene_of(cell)?))).collect();
    let last = faults.into_iter().chain([scenes.join(" ")]).collect::<Vec<_>>().join("; ");
    [id, row.input.to_owned(), row.wanted.to_owned(), happened, worst, share, remark, last]
}
