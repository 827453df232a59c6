//! What `run` prints.
use std::fmt::Write;
use std::path::Path;

use specula_testbench::ErrorFigures;

use crate::header::bound;
use crate::run::{Run, Written};
use crate::table;

/// The summary of a run whose files are in `folder`.
pub fn summary(run: &Run, written: &Written, folder: &Path) -> String {
    let mut text = table::shown(&facts(run, written));
    // Writing to a String cannot fail.
    let _ = write!(text, "\n{}\nfiles in {}\n", table::shown(&errors(run)), folder.display());
    written.files.iter().for_each(|file| text.push_str(&format!("  {file}\n")));
    text
}

fn facts(run: &Run, written: &Written) -> Vec<[String; 2]> {
    let (outcome, frame) = (run.outcome, run.bench.frame);
    let seconds = format!(
        "{:.3} s, of which simulation {:.3} s",
        written.wall.as_secs_f64(),
        outcome.simulation_seconds
    );
    let worst = outcome.comparison.worst_pixel.zip(outcome.worst_cycle);
    let worst = worst.map(|(worst, cycle)| {
        format!("({}, {}), {:.2} LSB, leaves in cycle {cycle}", worst.x, worst.y, worst.error_lsb)
    });
    let trace = written
        .window
        .as_ref()
        .map(|window| format!("cycles {} to {}", window.start, window.end - 1));
    let rows = [
        ("scene", format!("{}, {} x {}", run.name(), frame.width, frame.height)),
        ("method", run.bench.spec.method().name().to_owned()),
        ("engine", run.engine.name().to_owned()),
        ("pixels", outcome.pixels.to_string()),
        ("mismatches", outcome.comparison.mismatches.to_string()),
        ("cycles", outcome.cycles.to_string()),
        ("cycles per pixel", format!("{:.4}", run.cycles_per_pixel())),
        ("latency", format!("{} clocks", run.bench.design.latency())),
        ("frames per second", run.frames_per_second_in_words()),
        ("worst pixel", worst.unwrap_or_else(|| "none".to_owned())),
        ("waveform", trace.unwrap_or_else(|| "none".to_owned())),
        ("time", seconds),
    ];
    let device = run.fitted.map(|fitted| ("device", fitted.in_words()));
    rows.into_iter().chain(device).map(|(name, value)| [name.to_owned(), value]).collect()
}

fn errors(run: &Run) -> Vec<[String; 6]> {
    let errors = &run.outcome.comparison.errors;
    let titles =
        ["error in LSB", "largest", "rms", "mean", "PSNR dB", "proven bound"].map(str::to_owned);
    let bound = bound(run.bench.design.error_bound());
    vec![
        titles,
        figures("total", &errors.total, String::new()),
        figures("  of the method", &errors.method, String::new()),
        figures("  of quantisation", &errors.quantisation, bound),
    ]
}

fn figures(name: &str, figures: &ErrorFigures, bound: String) -> [String; 6] {
    let lsb = |x: f64| format!("{x:.3}");
    let psnr = figures.psnr_db.map_or("no error".to_owned(), |db| format!("{db:.2}"));
    [
        name.to_owned(),
        lsb(figures.max_lsb),
        lsb(figures.rms_lsb),
        lsb(figures.mean_lsb),
        psnr,
        bound,
    ]
}
