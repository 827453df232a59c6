//! The summary of a run, which `run` prints.
use std::fmt::Write;
use std::path::Path;

use specula_testbench::ErrorFigures;

use super::{Report, rows};
use crate::sequence::picture_name;
use crate::table;

/// The summary of a run whose files are in `folder`.
pub fn summary(report: &Report, folder: &Path) -> String {
    let mut text = table::shown(&facts(report));
    // Writing to a String cannot fail.
    let _ = write!(text, "\n{}\nfiles in {}\n", table::shown(&errors(report)), folder.display());
    let frames = report.sequence.map_or(0, |sequence| sequence.frames);
    let pictures: Vec<String> = (0..frames).map(picture_name).collect();
    let others = report.files.iter().filter(|file| !pictures.contains(file));
    others.for_each(|file| text.push_str(&format!("  {file}\n")));
    if let [first, .., last] = &pictures[..] {
        text.push_str(&format!("  {first} to {last}\n"));
    }
    text
}

fn facts(report: &Report) -> Vec<[String; 2]> {
    let (wall, simulation) = (report.wall_seconds(), report.simulation_seconds);
    let worst = report.worst().map(|(worst, cycle)| {
        format!("({}, {}), {:.2} LSB, leaves in cycle {cycle}", worst.x, worst.y, worst.error_lsb)
    });
    let trace = report.trace.map(|[first, end]| format!("cycles {first} to {}", end - 1));
    let none = || "none".to_owned();
    let named = |(name, value): (&str, String)| [name.to_owned(), value];
    let scene = ("scene", format!("{}, {} x {}", report.scene, report.width, report.height));
    let subject = [
        ("method", report.method.to_owned()),
        ("engine", report.engine.to_owned()),
        ("pixels", report.pixels.to_string()),
        ("mismatches", report.mismatches.to_string()),
    ];
    let rest = [
        ("worst pixel", worst.unwrap_or_else(none)),
        ("waveform", trace.unwrap_or_else(none)),
        ("time", format!("{wall:.3} s, of which simulation {simulation:.3} s")),
    ];
    let all = [named(scene)].into_iter().chain(rows::sequence(report));
    let rows = all.chain(subject.map(named)).chain(rows::speed(report)).chain(rest.map(named));
    rows.chain(rows::stream(report))
        .chain(rows::made_for(report))
        .chain(rows::device(report))
        .chain(rows::formats(report))
        .collect()
}

fn errors(report: &Report) -> Vec<[String; 6]> {
    let titles =
        ["error in LSB", "largest", "rms", "mean", "PSNR dB", "proven bound"].map(str::to_owned);
    let row = |name: &str, figures: &ErrorFigures, bound: String| {
        let [largest, rms, mean, psnr] = rows::figures(figures);
        [name.to_owned(), largest, rms, mean, psnr, bound]
    };
    vec![
        titles,
        row("total", &report.error.total, String::new()),
        row("  of the method", &report.error.method, String::new()),
        row("  of quantisation", &report.error.quantisation, report.bound_in_words()),
    ]
}
