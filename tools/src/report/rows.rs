//! Rows that the report for people and the printed summary share.
use specula_testbench::ErrorFigures;

use super::Report;
use crate::made_for::MadeFor;

/// How fast the core is: rows of name and value.
pub fn speed(report: &Report) -> [[String; 2]; 4] {
    [
        ("cycles", report.cycles.to_string()),
        ("cycles per pixel", format!("{:.4}", report.cycles_per_pixel)),
        ("latency", format!("{} clocks", report.latency)),
        ("frames per second", report.run.frames_per_second_in_words()),
    ]
    .map(|(name, value)| [name.to_owned(), value])
}

/// What came of all frames, and the one that the report is about, if the scene moves.
pub fn sequence(report: &Report) -> Vec<[String; 2]> {
    let Some(sequence) = report.sequence else { return vec![] };
    [
        ("sequence", sequence.in_words()),
        ("pixels of all frames", sequence.pixels.to_string()),
        ("mismatches in all frames", sequence.mismatches.to_string()),
        ("cycles of all frames", sequence.cycles.to_string()),
        ("frame", sequence.shown_in_words()),
    ]
    .map(|(name, value)| [name.to_owned(), value])
    .into()
}

/// What came of the stream top, if it was simulated, and random pauses, if there were any.
pub fn stream(report: &Report) -> impl Iterator<Item = [String; 2]> {
    let pauses = |seed| format!("at random, by seed {seed}");
    let pauses = report.stalls.map(|seed| ["pauses".to_owned(), pauses(seed)]);
    let stream = report.stream.map(|stream| ["stream top".to_owned(), stream.in_words()]);
    pauses.into_iter().chain(stream)
}

/// What projection the picture has, if its camera is a perspective one.
pub fn camera(report: &Report) -> Option<[String; 2]> {
    let interpolation = report.interpolation?;
    Some(["camera".to_owned(), interpolation.in_words().to_owned()])
}

/// The device and the share of it that the core takes, if the user named a device.
pub fn device(report: &Report) -> Option<[String; 2]> {
    report.fitted.as_ref().map(|fitted| ["device".to_owned(), fitted.in_words()])
}

/// The core's formats, with the reason why it is not faithful, where it was to be.
pub fn formats(report: &Report) -> Option<[String; 2]> {
    Some(["formats".to_owned(), report.not_faithful.clone()?])
}

/// The target and the clock that the core was made for, and the predicted clock, if it has any.
pub fn made_for(report: &Report) -> Option<[String; 2]> {
    let made_for = MadeFor::of(report.spec, &report.run.bench.design)?;
    Some(["made for".to_owned(), made_for.in_words()])
}

/// Error figures: largest, root mean square and mean in LSBs, and the PSNR in dB.
pub fn figures(figures: &ErrorFigures) -> [String; 4] {
    let lsb = |x: f64| format!("{x:.3}");
    let psnr = figures.psnr_db.map_or("no error".to_owned(), |db| format!("{db:.2}"));
    [lsb(figures.max_lsb), lsb(figures.rms_lsb), lsb(figures.mean_lsb), psnr]
}
