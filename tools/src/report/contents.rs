//! The contents of a run's report, from which every rendering is made.
use std::time::Instant;

use serde::{Serialize, Serializer};
use specula_datapath::design::Size;
use specula_experiments::{BoundShare, Savings};
use specula_scene::perspective::Interpolation;
use specula_spec::CoreSpec;
use specula_testbench::{Errors, MovedInput, Violation, WorstQuantisation};

use super::facts::{self, Fact};
use crate::device::Fitted;
use crate::disagreement::{BeyondBound, CHANNELS, Disagreement};
use crate::made_for::{MadeFor, Prediction};
use crate::output::PROGRAM;
use crate::ports::{Port, ports};
use crate::run::Run;
use crate::sequence::ShadedSequence;
use crate::stream_top::StreamOutcome;
use crate::verilog::bound;

/// Everything that is reported about a run. It serialises as `report.json`; errors are in LSBs of
/// the 8-bit output.
#[derive(Serialize)]
pub struct Report<'a> {
    /// The run, from which the reports for people also show the design.
    #[serde(skip)]
    pub run: &'a Run<'a>,
    /// Always `specula`: by it a later run recognises that the listed files are its own.
    program: &'static str,
    pub version: &'static str,
    pub scene: &'a str,
    /// Name of the Verilog module.
    pub module: &'a str,
    /// The command that makes the same Verilog.
    pub command: &'a str,
    pub method: &'static str,
    pub engine: &'static str,
    pub width: u32,
    pub height: u32,
    pub spans: usize,
    /// How weights go along spans, where the camera is a perspective one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interpolation: Option<Interpolation>,
    pub pixels: u64,
    pub agrees: bool,
    pub mismatches: u64,
    pub wrong_clocks: usize,
    /// The first fact that did not hold.
    pub violation: Option<ViolatedFact<'a>>,
    /// The first input that holds for a frame and did not stand still, in words.
    pub moved_input: Option<String>,
    pub first_mismatch: Option<FirstMismatch>,
    /// The largest quantisation error that is above its bound.
    pub beyond_bound: Option<BrokenBound>,
    /// The seed of random pauses; `None` without pauses.
    pub stalls: Option<u32>,
    /// What came of the core's stream top; `None` if the core was simulated alone.
    pub stream: Option<&'a StreamOutcome>,
    /// All frames, if the scene moves; everything else is about the one that is shown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sequence: Option<&'a ShadedSequence>,
    pub cycles: u64,
    pub latency: u32,
    pub cycles_per_pixel: f64,
    /// The clock in MHz, assumed or given by the user, and not proven.
    pub clock_mhz: f64,
    /// Frames per second at that clock, including set-up.
    pub frames_per_second: f64,
    /// The target and the clock that the core was made for, and the clock that the target's delays
    /// predict; `None` of a core for any device.
    pub made_for: Option<Prediction>,
    /// The share of the device that the core takes, if the user named a device.
    #[serde(flatten)]
    pub fitted: Option<Fitted>,
    /// When the run began. It serialises as the seconds from then until the report is written.
    #[serde(rename = "wall_seconds", serialize_with = "seconds_since")]
    pub begin: Instant,
    pub simulation_seconds: f64,
    pub error: &'a Errors,
    /// Largest difference between the core's code and the rounded value of its method in f64, in
    /// codes.
    pub largest_code_difference: u8,
    /// Proven bound of the quantisation error; `None` if there is no finite one.
    pub bound_lsb: Option<f64>,
    /// The core's formats and why it is not faithful by proof, where it was to be; `None` where it
    /// is, or formats were asked for.
    pub not_faithful: Option<String>,
    /// The bound divided by the largest measured quantisation error.
    pub bound_ratio: Option<f64>,
    /// By how much the bound would shrink if one narrowing point rounded far more finely, the
    /// largest first.
    pub bound_shares: &'a [BoundShare],
    pub worst_pixel: Option<WorstPixel>,
    /// Facts that the core rests on: the limits of signals, and the values seen.
    pub facts: Vec<Fact>,
    /// The clocks in the waveform: the first one, and the one behind the last.
    pub trace: Option<[u64; 2]>,
    pub size: Size,
    /// The core's ports, in the order of the Verilog.
    pub ports: Vec<Port>,
    /// What each need saves against the general core; `None` if this is a general core.
    pub savings: Option<&'a Savings>,
    pub spec: &'a CoreSpec,
    /// Every file of the run's folder, in the order in which people want to see them.
    pub files: Vec<String>,
}

/// A stated fact that did not hold.
#[derive(Serialize)]
pub struct ViolatedFact<'a> {
    fact: &'a str,
    signal: &'a str,
    cycle: u64,
    value: f64,
    /// Text with every digit of the value and of its limits.
    in_words: String,
}

/// The first pixel that differs from the model's.
#[derive(Serialize)]
pub struct FirstMismatch {
    x: u32,
    y: u32,
    cycle: u64,
    simulated: [u8; 3],
    expected: [u8; 3],
}

/// The largest quantisation error above the bound.
#[derive(Serialize)]
pub struct BrokenBound {
    /// Pixels with an error above the bound.
    pixels: u64,
    x: u32,
    y: u32,
    cycle: u64,
    channel: &'static str,
    simulated: u8,
    expected: u8,
    /// The method's value in exact arithmetic.
    method: f64,
    error_lsb: f64,
    bound_lsb: f64,
}

/// The pixel with the largest total error.
#[derive(Serialize)]
pub struct WorstPixel {
    pub x: u32,
    pub y: u32,
    pub cycle: Option<u64>,
    pub error_lsb: f64,
}

impl<'a> Report<'a> {
    /// The report of a run that began at `begin` and whose folder has `files`.
    pub fn new(run: &'a Run<'a>, begin: Instant, files: Vec<String>) -> Report<'a> {
        let (outcome, bench) = (run.outcome, run.bench);
        let comparison = &outcome.comparison;
        let bound = bench.design.error_bound();
        Report {
            run,
            program: PROGRAM,
            version: env!("CARGO_PKG_VERSION"),
            scene: run.name(),
            module: &run.module,
            command: &run.job.origin.command,
            method: bench.spec.method().name(),
            engine: run.engine.name(),
            width: bench.frame.width,
            height: bench.frame.height,
            spans: bench.frame.spans.len(),
            interpolation: bench.frame.interpolation(),
            pixels: outcome.pixels,
            agrees: run.disagreement.is_none(),
            mismatches: comparison.mismatches,
            wrong_clocks: outcome.wrong_clocks.len(),
            violation: outcome.violation.as_ref().map(violated_fact),
            moved_input: outcome.moved_input.as_ref().map(MovedInput::in_words),
            first_mismatch: run.disagreement.as_ref().and_then(first_mismatch),
            beyond_bound: run
                .disagreement
                .as_ref()
                .and_then(|disagreement| disagreement.beyond_bound)
                .map(broken_bound),
            stalls: run.stalls,
            stream: run.stream.as_ref(),
            sequence: run.sequence.as_ref(),
            cycles: outcome.cycles,
            latency: bench.design.latency(),
            cycles_per_pixel: run.cycles_per_pixel(),
            clock_mhz: run.clock.mhz,
            frames_per_second: run.frames_per_second(),
            made_for: MadeFor::of(bench.spec, &bench.design).map(|made_for| made_for.prediction()),
            fitted: run.fitted.clone(),
            begin,
            simulation_seconds: outcome.simulation_seconds,
            error: &comparison.errors,
            largest_code_difference: comparison.largest_code_difference,
            bound_lsb: bound.is_finite().then_some(bound),
            not_faithful: run.job.not_faithful.as_ref().map(ToString::to_string),
            bound_ratio: run.bound_ratio(),
            bound_shares: &run.bound_shares,
            worst_pixel: comparison.worst_pixel.map(|worst| WorstPixel {
                x: worst.x,
                y: worst.y,
                cycle: outcome.worst_cycle,
                error_lsb: worst.error_lsb,
            }),
            facts: facts::facts(&bench.design, outcome),
            trace: run.window.as_ref().map(|window| [window.start, window.end]),
            size: bench.design.size(),
            ports: ports(bench.spec, &bench.design),
            savings: run.savings.as_ref(),
            spec: bench.spec,
            files,
        }
    }

    /// The text of `report.json`.
    ///
    /// # Errors
    /// Errors of [`serde_json`], which a report does not cause.
    pub fn json(&self) -> serde_json::Result<String> {
        Ok(serde_json::to_string_pretty(self)? + "\n")
    }

    /// Seconds since the run began.
    pub fn wall_seconds(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }

    /// The proven bound of the quantisation error as text.
    pub fn bound_in_words(&self) -> String {
        bound(self.run.bench.design.error_bound())
    }

    /// The pixel with the largest total error, and the clock in which it leaves.
    pub fn worst(&self) -> Option<(&WorstPixel, u64)> {
        self.worst_pixel.as_ref().and_then(|worst| Some((worst, worst.cycle?)))
    }
}

fn seconds_since<S: Serializer>(begin: &Instant, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_f64(begin.elapsed().as_secs_f64())
}

fn violated_fact(violation: &Violation) -> ViolatedFact<'_> {
    let Violation { fact, signal, clock, .. } = violation;
    ViolatedFact {
        fact,
        signal,
        cycle: *clock,
        value: violation.value(),
        in_words: violation.in_words(),
    }
}

fn broken_bound(BeyondBound { worst, clock, bound_lsb, pixels }: BeyondBound) -> BrokenBound {
    let WorstQuantisation { x, y, channel, simulated, expected, method, error_lsb, .. } = worst;
    BrokenBound {
        pixels,
        x,
        y,
        cycle: clock,
        channel: CHANNELS[channel],
        simulated,
        expected,
        method,
        error_lsb,
        bound_lsb,
    }
}

fn first_mismatch(disagreement: &Disagreement) -> Option<FirstMismatch> {
    let (m, cycle) = disagreement.first_mismatch.as_ref()?;
    Some(FirstMismatch {
        x: m.x,
        y: m.y,
        cycle: *cycle,
        simulated: m.simulated,
        expected: m.expected,
    })
}
