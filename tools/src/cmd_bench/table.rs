//! A measurement as a table.
use specula_experiments::benchmark::{EngineResult, Skipped};

use super::measured::Measured;
use crate::table;

/// The text that `bench` prints.
pub fn text(measured: &Measured) -> String {
    let titles =
        ["engine", "mode", "variant", "threads", " Mcycles/s", " ns/cycle", "  ratio", "  build s"]
            .map(str::to_owned);
    let rows = measured.measurement.rows.iter().map(|row| cells(measured, row));
    let rows: Vec<[String; 8]> = [titles].into_iter().chain(rows).collect();
    let skipped: String = measured.measurement.skipped.iter().map(skipped).collect();
    format!("{}\n{}{skipped}", table::shown(&facts(measured)), table::shown(&rows))
}

fn facts(measured: &Measured) -> Vec<[String; 2]> {
    let Measured { scene, bench, budget, measurement } = measured;
    let (design, machine) = (&bench.design, &measurement.machine);
    let size = design.size();
    let cores = if machine.cores == 1 { "core" } else { "cores" };
    let rows = [
        (
            "scene",
            format!(
                "{scene}, {} x {}, {} spans",
                bench.frame.width,
                bench.frame.height,
                bench.frame.spans.len()
            ),
        ),
        ("method", bench.spec.method().name().to_owned()),
        (
            "design",
            format!(
                "{} signals, {} multipliers, {} adders, latency {}",
                design.nodes.len(),
                size.multipliers,
                size.adders,
                design.latency()
            ),
        ),
        (
            "machine",
            format!("{}, {} {cores}, {}", machine.cpu, machine.cores, machine.instruction_set),
        ),
        ("tools", machine.tools.join("; ")),
        (
            "rounds",
            format!("{}, interleaved; ratios of medians to Verilator's outputs", budget.rounds),
        ),
    ];
    rows.map(|(name, value)| [name.to_owned(), value]).to_vec()
}

fn cells(measured: &Measured, row: &EngineResult) -> [String; 8] {
    let rate = row.rate();
    [
        row.config.engine.program().to_owned(),
        row.config.mode.name().to_owned(),
        row.config.variant.unwrap_or("").to_owned(),
        format!("{:>7}", row.config.threads),
        format!("{:>10.4}", rate / 1e6),
        format!("{:>9.2}", 1e9 / rate),
        measured
            .measurement
            .ratio_to_verilator(row)
            .map_or(String::new(), |ratio| format!("{ratio:>7.3}")),
        format!("{:>9.4}", row.build_seconds),
    ]
}

fn skipped(skipped: &Skipped) -> String {
    let mode = skipped.mode.map_or(String::new(), |mode| format!(" {}", mode.name()));
    format!("without {}{mode}: {}\n", skipped.engine.program(), skipped.reason)
}
