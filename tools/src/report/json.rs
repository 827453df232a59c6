//! The report for programs.
use serde::Serialize;
use specula_experiments::{Savings, Share};
use specula_hdl::design::Size;
use specula_scene::CoreSpec;
use specula_testbench::{Errors, Violation, WorstQuantisation};

use crate::device::Fitted;
use crate::disagreement::{BeyondBound, CHANNELS, Disagreement};
use crate::output::PROGRAM;
use crate::report::facts::{self, Fact};
use crate::run::{Run, Written};

/// `report.json`. Errors are in LSBs of the 8-bit output.
#[derive(Serialize)]
struct Report<'a> {
    /// Specula: whoever replaces the folder sees by it whose files are listed.
    program: &'static str,
    version: &'static str,
    scene: &'a str,
    /// Of the Verilog.
    module: &'a str,
    /// Makes the same Verilog.
    command: &'a str,
    method: &'static str,
    engine: &'static str,
    width: u32,
    height: u32,
    spans: usize,
    pixels: u64,
    agrees: bool,
    mismatches: u64,
    wrong_clocks: usize,
    /// The first fact that did not hold.
    violation: Option<ViolatedFact<'a>>,
    first_mismatch: Option<FirstMismatch>,
    /// The largest quantisation error that is above its bound.
    beyond_bound: Option<BrokenBound>,
    cycles: u64,
    latency: u32,
    cycles_per_pixel: f64,
    /// Assumed or given, and not proven.
    clock_mhz: f64,
    /// At that clock, set-up counted.
    frames_per_second: f64,
    /// What the core takes of the device, if one was named.
    #[serde(flatten)]
    fitted: Option<Fitted>,
    /// From the beginning on until everything but the reports was written.
    wall_seconds: f64,
    simulation_seconds: f64,
    error: &'a Errors,
    /// Of the core's codes from its method rounded in f64, in codes.
    largest_code_difference: u8,
    /// On the quantisation error; none if no finite one can be proven.
    bound_lsb: Option<f64>,
    /// How many times the largest measured quantisation error it is.
    bound_ratio: Option<f64>,
    /// By how much it would be smaller if a place rounded far finer, the largest first.
    bound_shares: &'a [Share],
    worst_pixel: Option<WorstPixel>,
    /// Facts that the core rests on: where signals must lie, and where they did.
    facts: Vec<Fact>,
    /// The clocks in the waveform, from the first to the one behind the last.
    trace: Option<[u64; 2]>,
    size: Size,
    /// What is saved against the general core, need by need; none if this is one.
    savings: Option<&'a Savings>,
    spec: &'a CoreSpec,
    files: &'a [String],
}

#[derive(Serialize)]
struct ViolatedFact<'a> {
    fact: &'a str,
    signal: &'a str,
    cycle: u64,
    value: f64,
    /// Every digit of the value and of its limits.
    in_words: String,
}

#[derive(Serialize)]
struct FirstMismatch {
    x: u32,
    y: u32,
    cycle: u64,
    simulated: [u8; 3],
    expected: [u8; 3],
}

#[derive(Serialize)]
struct BrokenBound {
    /// Pixels with an error above the bound.
    pixels: u64,
    x: u32,
    y: u32,
    cycle: u64,
    channel: &'static str,
    simulated: u8,
    expected: u8,
    /// In exact arithmetic.
    method: f64,
    error_lsb: f64,
    bound_lsb: f64,
}

#[derive(Serialize)]
struct WorstPixel {
    x: u32,
    y: u32,
    cycle: Option<u64>,
    error_lsb: f64,
}

/// The report as text.
pub fn json(run: &Run, written: &Written) -> serde_json::Result<String> {
    let mut text = serde_json::to_string_pretty(&report(run, written))?;
    text.push('\n');
    Ok(text)
}

fn report<'a>(run: &'a Run<'a>, written: &'a Written) -> Report<'a> {
    let (outcome, bench) = (run.outcome, run.bench);
    let comparison = &outcome.comparison;
    let bound = bench.design.error_bound();
    Report {
        program: PROGRAM,
        version: env!("CARGO_PKG_VERSION"),
        scene: run.name(),
        module: &run.module,
        command: &run.task.origin.command,
        method: bench.spec.method().name(),
        engine: run.engine.name(),
        width: bench.frame.width,
        height: bench.frame.height,
        spans: bench.frame.spans.len(),
        pixels: outcome.pixels,
        agrees: outcome.agrees(),
        mismatches: comparison.mismatches,
        wrong_clocks: outcome.wrong_clocks.len(),
        violation: outcome.violation.as_ref().map(violated_fact),
        first_mismatch: run.disagreement.as_ref().and_then(first_mismatch),
        beyond_bound: run
            .disagreement
            .as_ref()
            .and_then(|disagreement| disagreement.beyond_bound)
            .map(broken_bound),
        cycles: outcome.cycles,
        latency: bench.design.latency(),
        cycles_per_pixel: run.cycles_per_pixel(),
        clock_mhz: run.clock.mhz,
        frames_per_second: run.frames_per_second(),
        fitted: run.fitted,
        wall_seconds: written.wall.as_secs_f64(),
        simulation_seconds: outcome.simulation_seconds,
        error: &comparison.errors,
        largest_code_difference: comparison.largest_code_difference,
        bound_lsb: bound.is_finite().then_some(bound),
        bound_ratio: run.bound_ratio(),
        bound_shares: &run.bound_shares,
        worst_pixel: comparison.worst_pixel.map(|worst| WorstPixel {
            x: worst.x,
            y: worst.y,
            cycle: outcome.worst_cycle,
            error_lsb: worst.error_lsb,
        }),
        facts: facts::facts(&bench.design, outcome),
        trace: written.window.as_ref().map(|window| [window.start, window.end]),
        size: bench.design.size(),
        savings: run.savings.as_ref(),
        spec: bench.spec,
        files: &written.files,
    }
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
