//! `specula stress --climb`: the search for broken bounds.
use std::fs;
use std::io::{self, Write};
use std::time::Instant;

use serde::Serialize;
use specula_experiments::climb::{MAX_REPORTED, MethodReport, Search, climb};
use specula_spec::Method;

use crate::error::ToolError;
use crate::output::{Destination, PROGRAM, REPORT, Staging};
use crate::progress;
use crate::table;
use crate::verdict::Verdict;

#[derive(Serialize)]
struct Report<'a> {
    /// Always `specula`: by it a later run recognises that the listed files are its own.
    program: &'static str,
    version: &'static str,
    seed: u64,
    /// Number of scenes that were tried.
    scenes: u64,
    holds: bool,
    methods: Vec<MethodFacts<'a>>,
    files: &'a [String],
}

#[derive(Serialize)]
struct MethodFacts<'a> {
    #[serde(flatten)]
    report: &'a MethodReport,
    /// Scene files for `run`: the one with the largest ratio, and those that show a fault.
    scene_files: Vec<String>,
}

/// Climbs, writes the scenes and the report, and prints the table or the report.
pub fn execute(
    search: &Search,
    destination: &Destination,
    json: bool,
    stdout: &mut dyn Write,
) -> Result<Verdict, ToolError> {
    let begin = Instant::now();
    let bar = progress::steps();
    bar.set_length(search.scenes);
    bar.set_message("scenes");
    let methods = climb(search, &|| bar.inc(1));
    bar.finish_and_clear();
    let seconds = begin.elapsed().as_secs_f64();
    let report = write(destination, search.seed, &methods)?;
    let text = if json { report } else { text(search.seed, &methods, seconds, destination) };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(if methods.iter().all(MethodReport::holds) { Verdict::Done } else { Verdict::Disagrees })
}

/// Every file that may be written.
pub fn possible_names(methods: &[Method]) -> Vec<String> {
    let scenes = methods.iter().flat_map(|method| {
        let wrong = (0..2 * MAX_REPORTED).map(|number| wrong_name(method.name(), number));
        [highest_name(method.name())].into_iter().chain(wrong)
    });
    [REPORT.to_owned()].into_iter().chain(scenes).collect()
}

fn highest_name(method: &str) -> String {
    format!("highest_{method}.toml")
}

fn wrong_name(method: &str, number: usize) -> String {
    format!("wrong_{method}_{}.toml", number + 1)
}

/// Names and texts of a method's scene files.
fn scenes(report: &MethodReport) -> Vec<(String, &str)> {
    let highest =
        report.largest.iter().map(|peak| (highest_name(report.method), peak.scene.as_str()));
    let wrong = report
        .wrong
        .iter()
        .enumerate()
        .map(|(number, peak)| (wrong_name(report.method, number), peak.scene.as_str()));
    highest.chain(wrong).collect()
}

/// Writes all files and returns the JSON report.
fn write(
    destination: &Destination,
    seed: u64,
    methods: &[MethodReport],
) -> Result<String, ToolError> {
    let staging = destination.stage()?;
    let mut files = vec![REPORT.to_owned()];
    for (name, scene) in methods.iter().flat_map(scenes) {
        fs::write(staging.file(&name), scene).map_err(staging.failed(&name))?;
        files.push(name);
    }
    let report = json(seed, methods, &files).map_err(|error| unwritten(&staging, error))?;
    fs::write(staging.file(REPORT), &report).map_err(staging.failed(REPORT))?;
    staging.publish()?;
    Ok(report)
}

fn unwritten(staging: &Staging, error: serde_json::Error) -> ToolError {
    staging.failed(REPORT)(io::Error::other(error)).into()
}

fn json(seed: u64, methods: &[MethodReport], files: &[String]) -> serde_json::Result<String> {
    let of_method = |report| MethodFacts {
        report,
        scene_files: scenes(report).into_iter().map(|(name, _)| name).collect(),
    };
    let report = Report {
        program: PROGRAM,
        version: env!("CARGO_PKG_VERSION"),
        seed,
        scenes: methods.iter().map(|method| method.scenes).sum(),
        holds: methods.iter().all(MethodReport::holds),
        methods: methods.iter().map(of_method).collect(),
        files,
    };
    Ok(serde_json::to_string_pretty(&report)? + "\n")
}

/// The text that is printed.
fn text(seed: u64, methods: &[MethodReport], seconds: f64, destination: &Destination) -> String {
    let titles = [
        "method",
        "scenes",
        "no core",
        "no bound",
        "largest ratio",
        "measured",
        "bound",
        "first broken after",
    ];
    let rows: Vec<[String; 8]> =
        [titles.map(str::to_owned)].into_iter().chain(methods.iter().map(line)).collect();
    let wrong: String = methods.iter().flat_map(complaints).collect();
    let scenes: u64 = methods.iter().map(|method| method.scenes).sum();
    let rate = scenes as f64 / seconds.max(f64::MIN_POSITIVE);
    let end = match wrong.as_str() {
        "" => "No bound is broken.",
        _ => "Bounds are broken, or something else is wrong.",
    };
    let folder = destination.shown.display();
    format!(
        "{}\n{wrong}{end}\nseed {seed}; {scenes} scenes, {rate:.0} a second; scenes and report in {folder}\n",
        table::shown(&rows)
    )
}

fn line(report: &MethodReport) -> [String; 8] {
    let figure =
        |number: Option<f64>| number.map_or(String::new(), |number| format!("{number:.4}"));
    let largest = report.largest.as_ref();
    [
        report.method.to_owned(),
        report.scenes.to_string(),
        report.refused.to_string(),
        report.without_bound.to_string(),
        figure(largest.map(|peak| peak.ratio)),
        figure(largest.map(|peak| peak.quantisation_lsb)),
        figure(largest.map(|peak| peak.bound_lsb)),
        report.first_broken_after.map_or(String::new(), |scenes| scenes.to_string()),
    ]
}

fn complaints(report: &MethodReport) -> impl Iterator<Item = String> + '_ {
    report.wrong.iter().enumerate().map(|(number, peak)| {
        let what = match &peak.fault {
            Some(fault) => fault.clone(),
            None => format!(
                "an error of {:.4} LSB, beyond the proven bound of {:.4}",
                peak.quantisation_lsb, peak.bound_lsb
            ),
        };
        format!("{}: {what}; see {}\n", report.method, wrong_name(report.method, number))
    })
}
