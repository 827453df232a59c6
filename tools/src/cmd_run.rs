//! `specula run`: the whole path from a scene to checked hardware.
use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use specula_experiments::{savings, shares};
use specula_scene::SpecFile;
use specula_testbench::trace::Choice;
use specula_testbench::{Bench, EngineKind, Outcome};

use crate::arguments::{
    NameArguments, OutputArguments, SceneArguments, Wishes, engine_parser, parse_choice,
};
use crate::clock::ClockArguments;
use crate::device::{DeviceArguments, Fitted};
use crate::disagreement::Disagreement;
use crate::error::ToolError;
use crate::output::{Destination, Interrupts, REPORT, Staging};
use crate::report::MARKDOWN;
use crate::run::{DEFAULT_ENGINE, Run, Written, simulate};
use crate::task::Task;
use crate::trace_file::TraceFormat;
use crate::verdict::Verdict;
use crate::{html, picture, report, summary, verilog, waveform, worst};

const EXAMPLE: &str = "\
Writes DIR/NAME.v, simulated.png, expected.png, exact.png, error.png, trace.vcd or trace.fst, \
trace.gtkw, worst.svg (the worst pixel's way through the core), spec.toml (the core itself, for \
`--core` and `generate --spec`), report.md, report.json and report.html (one file with everything in \
it). DIR is replaced as a whole when everything is there; files in it that Specula did not write \
stay.

Exit status: 0 if every pixel agrees and no quantisation error is above its proven bound, 1 if not,
2 if the run could not be made.

Example: specula run teapot --size 320x240 --method hybrid --trace span=100";

/// Arguments of `run`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    output: OutputArguments,
    #[command(flatten)]
    name: NameArguments,
    /// Shade the scene with the core in this run's folder, or in this spec.toml; it is refused if
    /// it lacks what the scene needs
    #[arg(long, value_name = "DIR", conflicts_with_all = ["method", "specialise", "max_error"])]
    core: Option<PathBuf>,
    #[command(flatten)]
    wishes: Wishes,
    #[command(flatten)]
    device: DeviceArguments,
    #[command(flatten)]
    clock: ClockArguments,
    /// What simulates the core
    #[arg(long, default_value = DEFAULT_ENGINE.name(), value_parser = engine_parser())]
    engine: EngineKind,
    /// Clocks in the waveform: worst (200 around the largest error), none, span=N, cycles=A..B or
    /// all. If the core disagrees with its models or an error is above its bound, worst and none
    /// give 200 around that
    #[arg(long, value_name = "CLOCKS", default_value = "worst", value_parser = parse_choice)]
    trace: Choice,
    /// The waveform's file
    #[arg(long, value_name = "FORMAT", default_value = "vcd")]
    trace_format: TraceFormat,
    /// Print report.json instead of the summary
    #[arg(long)]
    json: bool,
}

const SIMULATED: &str = "simulated.png";
const EXPECTED: &str = "expected.png";
const EXACT: &str = "exact.png";
const ERROR: &str = "error.png";
/// Pictures of the frame: name, file and meaning.
const PICTURES: [[&str; 3]; 3] = [
    ["simulated", SIMULATED, "what the core gave"],
    ["expected", EXPECTED, "what the bit-true model gives"],
    ["exact", EXACT, "exact Phong shading"],
];

/// Runs the scene, writes everything, and prints the summary or the report.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let begin = Instant::now();
    let task = arguments.task()?;
    let folder = arguments.output.folder(arguments.name.name.as_ref().unwrap_or(&task.scene.name));
    let destination = Destination::check(&folder, &file_names(&task.module()), interrupts)?;
    let bench = Bench::new(&task.scene.frame, task.spec(), &task.module())?;
    let fitted = arguments.device.fitted(&bench.design)?;
    waveform::check(&arguments.trace, &bench)?;
    let outcome = simulate(&bench, arguments.engine)?;

    let run = run_of(arguments, &task, &bench, fitted, &outcome);
    let text = write(arguments, begin, &destination, &run)?;
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(verdict(run.disagreement.as_ref()))
}

impl Arguments {
    /// The scene, and the core that shades it.
    fn task(&self) -> Result<Task, ToolError> {
        match &self.core {
            None => Task::of_scene(&self.scene, &self.wishes, &self.name),
            Some(core) => Task::with_core(&self.scene, core, &self.name),
        }
    }
}

/// What came of a run, with what disagrees in it.
fn run_of<'a>(
    arguments: &Arguments,
    task: &'a Task,
    bench: &'a Bench<'a>,
    fitted: Option<Fitted>,
    outcome: &'a Outcome,
) -> Run<'a> {
    let is_general = bench.spec.specialisation.is_general();
    Run {
        task,
        module: task.module(),
        bench,
        engine: arguments.engine,
        trace_format: arguments.trace_format,
        disagreement: Disagreement::of(outcome, bench),
        clock: arguments.clock.clock(),
        fitted,
        bound_shares: shares(bench.spec, bench.frame, bench.design.error_bound()),
        savings: if is_general { None } else { savings(&task.scene, bench.spec, None).ok() },
        outcome,
    }
}

/// Writes everything, and gives what is to be printed.
fn write(
    arguments: &Arguments,
    begin: Instant,
    destination: &Destination,
    run: &Run,
) -> Result<String, ToolError> {
    let staging = destination.stage()?;
    let window = waveform::write(
        &staging,
        run,
        &waveform::choice(&arguments.trace, run.disagreement.as_ref()),
    )?;
    worst::write(&staging, run, window.as_ref())?;
    write_pictures(&staging, run)?;
    let written = Written { files: files(&run.module, &staging), window, wall: begin.elapsed() };
    let json = write_reports(&staging, run, &written)?;
    staging.publish()?;
    // Reports cannot say how long it takes to write them.
    let written = Written { wall: begin.elapsed(), ..written };
    Ok(if arguments.json { json } else { summary::summary(run, &written, &destination.shown) })
}

/// Every file that a run can write.
fn file_names(module: &str) -> Vec<String> {
    let pictures = [SIMULATED, EXPECTED, EXACT, ERROR];
    let names = pictures.into_iter().chain(optional_names()).chain([
        SpecFile::NAME,
        MARKDOWN,
        html::FILE,
        REPORT,
    ]);
    [verilog::file_name(module)].into_iter().chain(names.map(str::to_owned)).collect()
}

/// The waveform and what is made of it.
fn optional_names() -> impl Iterator<Item = &'static str> {
    TraceFormat::ALL
        .map(TraceFormat::file_name)
        .into_iter()
        .chain([waveform::SAVE_FILE, worst::PICTURE])
}

/// The files that this run writes, of which the waveform and what is made of it are there if they
/// are written at all.
fn files(module: &str, staging: &Staging) -> Vec<String> {
    let is_optional = |name: &str| optional_names().any(|optional| optional == name);
    file_names(module)
        .into_iter()
        .filter(|name| !is_optional(name) || staging.file(name).exists())
        .collect()
}

fn write_pictures(staging: &Staging, run: &Run) -> Result<(), ToolError> {
    let comparison = &run.outcome.comparison;
    let pictures = [
        (SIMULATED, &run.outcome.simulated),
        (EXPECTED, &comparison.expected),
        (EXACT, &comparison.exact),
    ];
    for (name, picture) in pictures {
        picture::write_image(&staging.file(name), picture).map_err(staging.failed(name))?;
    }
    let map = picture::heat_map(comparison);
    Ok(picture::write_drawing(&staging.file(ERROR), &map).map_err(staging.failed(ERROR))?)
}

/// Writes Verilog, spec and reports, and gives the JSON report.
fn write_reports(staging: &Staging, run: &Run, written: &Written) -> Result<String, ToolError> {
    let page =
        report::html(run, written, staging, &PICTURES).map_err(staging.failed(html::FILE))?;
    let source = verilog::text(&run.task.origin, run.bench.spec, &run.bench.design);
    let json = report::json(run, written)
        .map_err(|error| staging.failed(REPORT)(io::Error::other(error)))?;
    let verilog = verilog::file_name(&run.module);
    let texts = [
        (verilog.as_str(), &source),
        (SpecFile::NAME, &run.task.file.text()),
        (MARKDOWN, &report::markdown(run, written)),
        (html::FILE, &page),
        (REPORT, &json),
    ];
    for (name, text) in texts {
        fs::write(staging.file(name), text).map_err(staging.failed(name))?;
    }
    Ok(json)
}

/// The verdict; what disagrees is written to standard error.
fn verdict(disagreement: Option<&Disagreement>) -> Verdict {
    let Some(disagreement) = disagreement else { return Verdict::Done };
    let mut stderr = io::stderr().lock();
    for line in disagreement.lines() {
        // The report says the same, and the exit status tells.
        let _ = writeln!(stderr, "disagreement: {line}");
    }
    Verdict::Disagrees
}

#[cfg(test)]
mod tests;
