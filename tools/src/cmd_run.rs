//! `specula run`: everything from a scene to checked hardware.
mod artifacts;

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use specula_datapath::Design;
use specula_experiments::tradeoff::predicted_mhz;
use specula_experiments::{ablation, bound_shares};
use specula_spec::SceneCore;
use specula_testbench::trace::Choice;
use specula_testbench::{Bench, BenchError, EngineKind, Outcome};

use crate::arguments::{
    CoreArguments, NameArguments, OutputArguments, SceneArguments, engine_parser, parse_choice,
};
use crate::clock::Clock;
use crate::device::Fitted;
use crate::disagreement::Disagreement;
use crate::error::ToolError;
use crate::job::Job;
use crate::output::{Destination, Interrupts, REPORT, Staging};
use crate::report::{self, Report};
use crate::run::{DEFAULT_ENGINE, Run, simulate};
use crate::sequence::{self, Partial, ShadedSequence, Simulation};
use crate::stream_top::{StreamOutcome, StreamedFrame, Top};
use crate::target_arguments::CLOCK_HELP;
use crate::trace_file::TraceFormat;
use crate::verdict::Verdict;
use crate::waveform;
use artifacts::{Artifact, artifacts};

const EXAMPLE: &str = "\
Writes DIR/NAME.v, simulated.png, expected.png, exact.png, error.png, trace.vcd or trace.fst, \
trace.gtkw, worst.svg (the worst pixel's path through the core), spec.toml (the core's definition, \
for `--core` and `generate --spec`), report.md, report.json and report.html (one file with everything \
in it). DIR is replaced as a whole once everything is written; files in it that Specula did not write \
stay. Of a scene that moves, frames that are done wait in DIR.partial: a run that was interrupted goes \
on from there when it is started again.

With `--top axis` the frame's packets go through the core's stream top, and every pixel that comes out of it is compared, with its marks and its position; `--stalls` pauses both streams at random. The fast engine and rust-hdl run the core behind a model of the stream top; Icarus and Verilator run the whole block's Verilog besides.

Exit status: 0 if every pixel agrees and no quantisation error is above its proven bound, 1 if not,
2 if the run could not be made.

Examples:
  specula run teapot --size 320x240 --method hybrid --trace span=100
  specula run teapot --top axis --stalls 7";

/// Arguments of `run`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE, mut_arg("clock", |clock| clock.help(CLOCK_HELP)))]
pub struct Arguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    output: OutputArguments,
    #[command(flatten)]
    name: NameArguments,
    /// Shade the scene with the core in this run's folder, or in this spec.toml; it is refused if
    /// it lacks something that the scene needs
    #[arg(long, value_name = "DIR", conflicts_with_all = ["method", "specialise", "formats", "bound", "max_error", "max_quantisation", "target"])]
    core: Option<PathBuf>,
    #[command(flatten)]
    wanted: CoreArguments,
    /// Engine that simulates the core
    #[arg(long, default_value = DEFAULT_ENGINE.name(), value_parser = engine_parser())]
    engine: EngineKind,
    /// What is simulated
    #[arg(long, value_name = "TOP", default_value = "core")]
    top: Top,
    /// Random pauses by this seed: of the core between pixels, of a stream top on both sides
    #[arg(long, value_name = "SEED", value_parser = clap::value_parser!(u32).range(1..))]
    stalls: Option<u32>,
    /// Clocks in the waveform: worst (200 around the largest error), none, span=N, cycles=A..B or
    /// all. If the core disagrees with its models or an error is above its bound, worst and none
    /// give 200 around that
    #[arg(long, value_name = "CLOCKS", default_value = "worst", value_parser = parse_choice)]
    trace: Choice,
    /// Format of the waveform's file
    #[arg(long, value_name = "FORMAT", default_value = "vcd")]
    trace_format: TraceFormat,
    /// Print report.json instead of the summary
    #[arg(long)]
    json: bool,
}

/// Runs the scene, writes all files, and prints the summary or the report.
pub fn execute(
    arguments: &Arguments,
    stdout: &mut dyn Write,
    interrupts: &Interrupts,
) -> Result<Verdict, ToolError> {
    let begin = Instant::now();
    let job = arguments.job()?;
    let folder = arguments.output.folder(arguments.name.name.as_ref().unwrap_or(&job.scene.name));
    let files = artifacts::names(&job.module(), job.frames());
    let destination = Destination::check(&folder, &files, interrupts)?;
    let design = specula_hdl::elaborate(job.spec(), &job.module()).map_err(BenchError::from)?;
    let fitted = arguments.wanted.made_for.fitted(job.spec(), &design)?;
    let staging = destination.stage()?;
    let shaded = arguments.shaded_sequence(&job, &design, (&destination, &staging))?;
    let (sequence, partial) = shaded.unzip();
    let job = match &sequence {
        Some(sequence) => job.in_frame(sequence.shown)?,
        None => job,
    };
    let bench = Bench::of_design(&job.scene.frame, job.spec(), design);
    waveform::check(&arguments.trace, &bench)?;
    let (bench, streamed) = arguments.entering(&job, bench)?;
    let outcome = simulate(&bench, arguments.engine)?;
    let stream = streamed
        .map(|streamed| streamed.outcome(&job, &bench, &outcome, arguments.engine))
        .transpose()?;

    let run = Run { sequence, ..run_of(arguments, &job, &bench, fitted, (&outcome, stream))? };
    let text = write(arguments, begin, (&destination, staging), &run)?;
    partial.into_iter().for_each(Partial::remove);
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(verdict(run.disagreement.as_ref()))
}

impl Arguments {
    /// The scene and the core that shades it.
    fn job(&self) -> Result<Job, ToolError> {
        match &self.core {
            None => Job::of_scene(&self.scene, &self.wanted, &self.name),
            Some(core) => Job::with_core(&self.scene, core, &self.name),
        }
    }

    /// Every frame, shaded and written, if the scene moves.
    fn shaded_sequence(
        &self,
        job: &Job,
        design: &Design,
        output: (&Destination, &Staging),
    ) -> Result<Option<(ShadedSequence, Partial)>, ToolError> {
        let Some(sequence) = &job.scene.sequence else { return Ok(None) };
        let bubbles = self.stalls.filter(|_| self.top == Top::Core);
        let simulation = Simulation { engine: self.engine, bubbles };
        sequence::shade((job, sequence), design, simulation, output).map(Some)
    }

    /// The bench with the clocks in which pixels go in, and the frame in the stream top that tells
    /// them, if there is one.
    fn entering<'a>(
        &self,
        job: &Job,
        bench: Bench<'a>,
    ) -> Result<(Bench<'a>, Option<StreamedFrame>), ToolError> {
        Ok(match (self.top, self.stalls) {
            (Top::Core, None) => (bench, None),
            (Top::Core, Some(seed)) => (bench.with_bubbles(seed.into()), None),
            (Top::Axis, stalls) => {
                let streamed = StreamedFrame::new(job, &bench.design, stalls.unwrap_or(0))?;
                (streamed.bench(bench), Some(streamed))
            }
        })
    }

    /// The clock at which frames are counted.
    fn clock(&self, bench: &Bench) -> Clock {
        let predicted = predicted_mhz(bench.spec, &bench.design);
        Clock::of(predicted, self.wanted.made_for.given_for_any_device())
    }
}

/// The results of a run, including what disagrees.
fn run_of<'a>(
    arguments: &Arguments,
    job: &'a Job,
    bench: &'a Bench<'a>,
    fitted: Option<Fitted>,
    (outcome, stream): (&'a Outcome, Option<StreamOutcome>),
) -> Result<Run<'a>, ToolError> {
    let is_general = bench.spec.specialisation.is_general();
    let disagreement = Disagreement::of(outcome, bench, stream.as_ref());
    let trace = waveform::choice(&arguments.trace, disagreement.as_ref());
    let frames = job.scene.deciding_frames(bench.spec)?;
    Ok(Run {
        job,
        module: job.module(),
        bench,
        engine: arguments.engine,
        trace_format: arguments.trace_format,
        disagreement,
        clock: arguments.clock(bench),
        fitted,
        bound_shares: bound_shares(bench.spec, &frames[..], bench.design.error_bound()),
        savings: if is_general { None } else { ablation(&job.scene, bench.spec, None).ok() },
        outcome,
        stalls: arguments.stalls,
        sequence: None,
        stream,
        window: bench.window(&trace, outcome),
        trace,
    })
}

/// Writes all files and returns what is to be printed.
fn write(
    arguments: &Arguments,
    begin: Instant,
    (destination, staging): (&Destination, Staging),
    run: &Run,
) -> Result<String, ToolError> {
    let artifacts = artifacts(&run.module);
    let artifacts: Vec<Artifact> =
        artifacts.into_iter().filter(|artifact| (artifact.is_of)(run)).collect();
    let frames = run.sequence.as_ref().map_or(0, |sequence| sequence.frames);
    let files = artifacts.iter().map(|artifact| artifact.name.clone());
    let files = files.chain((0..frames).map(sequence::picture_name)).collect();
    let report = Report::new(run, begin, files);
    for artifact in &artifacts {
        artifact.write(&report, &staging)?;
    }
    let json = fs::read_to_string(staging.file(REPORT)).map_err(staging.failed(REPORT))?;
    staging.publish()?;
    Ok(if arguments.json { json } else { report::summary(&report, &destination.shown) })
}

/// The verdict; disagreements are reported on standard error.
fn verdict(disagreement: Option<&Disagreement>) -> Verdict {
    let Some(disagreement) = disagreement else { return Verdict::Done };
    let mut stderr = io::stderr().lock();
    for line in disagreement.lines() {
        // The report and the exit status say the same, so a closed standard error is no reason to
        // stop.
        let _ = writeln!(stderr, "disagreement: {line}");
    }
    Verdict::Disagrees
}

#[cfg(test)]
mod tests;
