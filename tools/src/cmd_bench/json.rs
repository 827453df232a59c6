//! A measurement as JSON.
use serde::Serialize;
use specula_experiments::benchmark::{EngineResult, Mode, Skipped};

use super::measured::Measured;

/// What `bench --json` prints.
#[derive(Serialize)]
struct Report<'a> {
    /// Version of Specula.
    version: &'static str,
    scene: &'a str,
    method: &'static str,
    width: u32,
    height: u32,
    spans: usize,
    /// Clocks for one frame.
    cycles: u64,
    machine: MachineFacts<'a>,
    design: DesignFacts,
    rounds: usize,
    rows: Vec<RowFacts>,
    skipped: Vec<SkippedFacts<'a>>,
}

#[derive(Serialize)]
struct MachineFacts<'a> {
    cpu_model: &'a str,
    /// The instruction set that the columnar engine uses.
    instruction_set: &'static str,
    cores: usize,
    /// Largest number of threads in any row.
    threads: usize,
    /// Names and versions of the external tools.
    tools: &'a [String],
}

#[derive(Serialize)]
struct DesignFacts {
    signals: usize,
    multipliers: usize,
    adders: usize,
    multiplexers: usize,
    registers: usize,
    register_bits: u64,
    latency: u32,
}

#[derive(Serialize)]
struct RowFacts {
    engine: &'static str,
    mode: &'static str,
    variant: Option<&'static str>,
    threads: usize,
    /// Median of the rounds.
    cycles_per_second: f64,
    /// Ratio of this median to that of Verilator with its outputs alone.
    ratio_to_verilator: Option<f64>,
    build_seconds: f64,
    /// Cycles of each run.
    cycles: u64,
    /// Cycles per second in each round.
    rounds: Vec<f64>,
}

#[derive(Serialize)]
struct SkippedFacts<'a> {
    engine: &'static str,
    mode: Option<&'static str>,
    reason: &'a str,
}

/// The measurement as JSON text.
pub fn text(measured: &Measured) -> serde_json::Result<String> {
    let mut text = serde_json::to_string_pretty(&report(measured))?;
    text.push('\n');
    Ok(text)
}

fn report<'a>(measured: &'a Measured) -> Report<'a> {
    let Measured { scene, bench, budget, measurement } = measured;
    Report {
        version: env!("CARGO_PKG_VERSION"),
        scene,
        method: bench.spec.method().name(),
        width: bench.frame.width,
        height: bench.frame.height,
        spans: bench.frame.spans.len(),
        cycles: measurement.clocks_of_a_frame,
        machine: machine(measured),
        design: design(measured),
        rounds: budget.rounds,
        rows: measurement.rows.iter().map(|row| row_facts(measured, row)).collect(),
        skipped: measurement.skipped.iter().map(skipped).collect(),
    }
}

fn machine<'a>(measured: &'a Measured) -> MachineFacts<'a> {
    let machine = &measured.measurement.machine;
    MachineFacts {
        cpu_model: &machine.cpu,
        instruction_set: machine.instruction_set,
        cores: machine.cores,
        threads: measured.measurement.rows.iter().map(|row| row.config.threads).max().unwrap_or(1),
        tools: &machine.tools,
    }
}

fn design(measured: &Measured) -> DesignFacts {
    let design = &measured.bench.design;
    let size = design.size();
    DesignFacts {
        signals: design.nodes.len(),
        multipliers: size.multipliers,
        adders: size.adders,
        multiplexers: size.multiplexers,
        registers: design.nodes.iter().filter(|node| node.registered()).count(),
        register_bits: size.register_bits,
        latency: design.latency(),
    }
}

fn row_facts(measured: &Measured, row: &EngineResult) -> RowFacts {
    RowFacts {
        engine: row.config.engine.program(),
        mode: row.config.mode.name(),
        variant: row.config.variant,
        threads: row.config.threads,
        cycles_per_second: row.rate(),
        ratio_to_verilator: measured.measurement.ratio_to_verilator(row),
        build_seconds: row.build_seconds,
        cycles: row.clocks,
        rounds: row.rates.clone(),
    }
}

fn skipped(skipped: &Skipped) -> SkippedFacts<'_> {
    SkippedFacts {
        engine: skipped.engine.program(),
        mode: skipped.mode.map(Mode::name),
        reason: &skipped.reason,
    }
}
