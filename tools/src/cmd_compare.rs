//! `specula compare`: error against run time and size, for methods × formats.
mod csv;
mod files;
mod json;
mod markdown;
mod plots;
mod result;
mod tables;
mod text;

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use indicatif::ProgressBar;
use specula_experiments::benchmark::Machine;
use specula_experiments::tradeoff::{
    Configuration, Formats, Journal, Planned, interpolation_errors, plan, software, sweep,
};
use specula_scene::LoadedScene;
use specula_spec::{CoreSpec, Method};
use specula_testbench::BenchError;

use crate::arguments::{SceneArguments, method_parser, selected_methods};
use crate::error::ToolError;
use crate::output::{Destination, Interrupts, JOURNAL, OutputError};
use crate::progress;
use crate::target_arguments::{CLOCK_HELP, TargetArguments};
use crate::verdict::Verdict;
use result::{Clocks, Compared, sorted};

const EXAMPLE: &str = "\
Simulates the core of each method with each of the formats on every pixel, and measures the papers' \
own loops in software. Writes DIR/report.md, report.html, report.json, cores.csv, software.csv, \
plots of error against run time and size as SVG and PNG, and results.jsonl, from which an \
interrupted sweep continues.

Exit status: 0 if every pixel of every core agrees with the bit-true model and no quantisation error \
is above its proven bound, 1 if not, 2 if the comparison could not be made.

Example: specula compare teapot --methods lyon,phong,gouraud --formats -4,-2,default --clock 150";

/// Arguments of `compare`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE, mut_arg("clock", |clock| clock.help(CLOCK_HELP)))]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Methods to compare [default: all of them]
    #[arg(long, value_name = "METHODS", value_delimiter = ',', value_parser = method_parser())]
    methods: Vec<Method>,
    /// Formats of each: default (those in which `run` makes the core), numbers of fraction bits more
    /// or fewer at every place where values are rounded, narrow (-4), or wide (+2)
    #[arg(
        long,
        value_name = "FORMATS",
        value_delimiter = ',',
        allow_hyphen_values = true,
        default_value = DEFAULT_FORMATS
    )]
    formats: Vec<Formats>,
    #[command(flatten)]
    made_for: TargetArguments,
    /// Measure everything again, including what results.jsonl has from an earlier or interrupted
    /// sweep
    #[arg(long)]
    fresh: bool,
    /// Print report.json instead of the tables
    #[arg(long)]
    json: bool,
    /// Folder to write [default: out/compare/NAME, by the scene's name]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
}

/// These range from clearly visible errors to errors that an 8-bit picture no longer shows.
const DEFAULT_FORMATS: &str = "-8,-6,-4,-2,default,+2";

/// Compares, writes all files, and prints the tables or the report.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let scene = arguments.scene.load_frame()?;
    let folder =
        arguments.output.clone().unwrap_or_else(|| PathBuf::from("out/compare").join(&scene.name));
    let destination = Destination::check(&folder, &files::names(), interrupts)?;
    let clocks = Clocks::of(&arguments.made_for)?;
    let made = |spec| fitting(&arguments.made_for, spec).map_err(|error| error.to_string());
    let planned = plan(&scene, &configurations(arguments), &made);
    refuse_nothing(&planned)?;
    let journal = open_journal(arguments, &destination, &scene)?;
    let compared = compare((arguments, clocks), &scene, planned, &journal)?;
    let report = files::write(&destination, &compared, &journal)?;
    let text = if arguments.json { report } else { text::text(&compared, &destination.shown) };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(if compared.agrees() { Verdict::Done } else { Verdict::Disagrees })
}

/// Opens the journal with the results that are known already, and warns about damaged lines.
fn open_journal(
    arguments: &Arguments,
    destination: &Destination,
    scene: &LoadedScene,
) -> Result<Journal, ToolError> {
    fs::create_dir_all(&destination.shown).map_err(OutputError::system(&destination.shown))?;
    let path = destination.shown.join(JOURNAL);
    if arguments.fresh && path.exists() {
        fs::remove_file(&path).map_err(OutputError::system(&path))?;
    }
    let (journal, damaged) = Journal::open(&path, scene)?;
    let mut stderr = io::stderr().lock();
    for line in damaged {
        // A closed standard error is no reason to stop.
        let _ = writeln!(
            stderr,
            "{}, line {}: {}; what it held is measured again",
            path.display(),
            line.line,
            line.reason
        );
    }
    Ok(journal)
}

/// A core made for the target that is asked for, if it fits the device.
fn fitting(made_for: &TargetArguments, spec: CoreSpec) -> Result<CoreSpec, ToolError> {
    let spec = made_for.made_for(spec)?;
    if made_for.device.is_some() {
        let design = specula_hdl::elaborate(&spec, "core").map_err(BenchError::from)?;
        made_for.fitted(&spec, &design)?;
    }
    Ok(spec)
}

/// Refuses a scene that no method can shade: there is nothing to compare, and nothing is written.
fn refuse_nothing(planned: &[Planned]) -> Result<(), ToolError> {
    let refusal = |planned: &Planned| {
        Some(format!("{}: {}", planned.configuration, planned.spec.as_ref().err()?))
    };
    let reasons: Vec<String> = planned.iter().filter_map(refusal).collect();
    if reasons.len() < planned.len() {
        Ok(())
    } else {
        Err(ToolError::NothingToCompare { reasons: reasons.join("\n") })
    }
}

fn compare(
    (arguments, clocks): (&Arguments, Clocks),
    scene: &LoadedScene,
    planned: Vec<Planned>,
    journal: &Journal,
) -> Result<Compared, ToolError> {
    let extent = software::TimingExtent::default();
    let bar = progress::steps();
    bar.set_length((planned.len() + extent.rounds + 1) as u64);
    let rows =
        sweep(scene, planned, journal, &|configuration| step(&bar, &configuration.to_string()))?;
    let software = software::measure(&scene.frame, extent, &mut || step(&bar, "software"));
    bar.finish_and_clear();
    let given = arguments.made_for.given_for_any_device();
    let (cores, refusals) = sorted(rows, given);
    Ok(Compared {
        scene: scene.name.clone(),
        size: (scene.frame.width, scene.frame.height),
        clocks,
        interpolation: interpolation_errors(scene),
        machine: Machine::this(),
        cores,
        refusals,
        software,
    })
}

fn step(bar: &ProgressBar, what: &str) {
    bar.set_message(what.to_owned());
    bar.inc(1);
}

/// The configurations to measure, each once: methods in their usual order, formats from narrow to
/// wide.
fn configurations(arguments: &Arguments) -> Vec<Configuration> {
    let mut formats = arguments.formats.clone();
    formats.sort_unstable();
    formats.dedup();
    let of_method = |method| formats.iter().map(move |&formats| Configuration { method, formats });
    selected_methods(&arguments.methods).into_iter().flat_map(of_method).collect()
}
