//! The report of the rows: as a printed table, as `report.md` and as `report.json`.
use std::fmt::Write;
use std::path::Path;

use serde::Serialize;
use specula_experiments::figure9::Balls;
use specula_testbench::EngineKind;

use super::names::{FORMULAS, NAME, SIMULATED};
use super::shaded::{Line, Shaded};
use crate::output::PROGRAM;
use crate::table;

/// The text of `report.json`.
#[derive(Serialize)]
struct Report<'a> {
    /// Always `specula`: by it a later run recognises that the listed files are its own.
    program: &'static str,
    version: &'static str,
    figure: &'static str,
    engine: &'static str,
    /// Radius of a ball in pixels.
    radius: u32,
    agrees: bool,
    rows: Vec<&'a Line>,
    files: &'a [String],
}

/// Titles of the columns.
const COLUMNS: [&str; 9] = [
    "row",
    "formula",
    "method",
    "mismatches",
    "largest error",
    "rms",
    "proven bound",
    "latency",
    "multipliers",
];

fn lines(rows: &[Shaded]) -> Vec<[String; 9]> {
    rows.iter().map(|row| row.line.cells()).collect()
}

/// The text that is printed.
pub fn summary(rows: &[Shaded], files: &[String], folder: &Path) -> String {
    let table: Vec<[String; 9]> =
        [COLUMNS.map(str::to_owned)].into_iter().chain(lines(rows)).collect();
    let mut text = table::shown(&table);
    // Writing to a String cannot fail.
    let _ = writeln!(text, "\nfiles in {}", folder.display());
    files.iter().for_each(|file| text.push_str(&format!("  {file}\n")));
    text
}

/// The text of `report.md`, which is docs/figure9.md at the report's size. `exact` is the figure in
/// f64.
pub fn markdown(rows: &[Shaded], balls: Balls, exact: &[f64]) -> String {
    let verdict = if rows.iter().all(|row| row.line.agrees) {
        "Every pixel of every row agrees with the bit-true model, each in its clock."
    } else {
        "**Not every row agrees with its model.**"
    };
    let (radius, sum) = (balls.radius, exact.iter().sum::<f64>());
    let table = table::markdown(COLUMNS, &lines(rows));
    format!(
        "{TITLE}\n![figure 9]({SIMULATED})\n\n{SUBJECT}\n\
         - five balls of radius m = {radius} pixels and radius 1, their centres one radius apart, \
         of which the first from the left that\n  covers a pixel is seen there;\n{SCENE}\n\
         Here every pixel is a span of its own, with the ball's normal at both ends. In f64 the \
         twelve formulas add up to\n{sum:.4} over all pixels of the figure, which `{FORMULAS}` \
         shows rounded to 8 bits.\n\n{FINDINGS}\n## How near it comes\n\n{verdict} Errors are in \
         LSBs of the 8-bit output,\nagainst the appendix's formula in f64; half an LSB is the \
         rounding to 8 bits. Formats are the defaults.\n\n{table}"
    )
}

const TITLE: &str = "# Lyon's figure 9, from hardware

`specula reproduce figure9` shades the figure of the report (Lyon, TR 43, figure 9 and appendix) with a
core for each of its twelve rows, and writes this page.
";

const SUBJECT: &str = "## What it shows

The report's words: *shiny black balls as rendered by the MATLAB test program, with five shininess
values n in each row, and a row for each of twelve techniques*. The program (`specular.m`) has
";

const SCENE: &str = "- two lights at infinity, L = (1, 1, -1)/√3, right, high and behind, and (1, -1, 1)/√3, right, low
  and in front; the eye in the direction (0, 0, 1);
- a diffuse reflectance of 35 of 255, no ambient light, a highlight of 400 (n/256)^¼, which
  saturates, and a white background;
- the normal of every pixel from the ball itself: nothing is interpolated or normalised, only shapes
  of highlights are compared;
- rows one and a half radii apart, the first at the bottom. The program writes a pixel of a ball into
  all rows before it goes on to the pixel above, so that the upper part of a row lies over the lower
  part of the next.
";

const FINDINGS: &str = "What the report says of it can be seen: at n = 1 row 1 stops abruptly; for n above 4 all rows are
alike but row 10, which loses the glancing highlight because h g2(h·h) stays short; k = 0 (row 2)
drops too fast, k = 1 (rows 3 and 9) is crisper than k = 2 (rows 4 and 8); Blinn's rows 5 to 12 have
rounder glancing highlights than rows 1 to 4; row 12 never ends.
";

/// The text of `report.json`.
pub fn json(
    rows: &[Shaded],
    balls: Balls,
    engine: EngineKind,
    files: &[String],
) -> serde_json::Result<String> {
    let report = Report {
        program: PROGRAM,
        version: env!("CARGO_PKG_VERSION"),
        figure: NAME,
        engine: engine.name(),
        radius: balls.radius,
        agrees: rows.iter().all(|row| row.line.agrees),
        rows: rows.iter().map(|row| &row.line).collect(),
        files,
    };
    Ok(serde_json::to_string_pretty(&report)? + "\n")
}
