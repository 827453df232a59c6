//! Circuits placed and routed, and when signals arrive in them.
use std::collections::BTreeMap;

use serde::Deserialize;
use specula_sim::{SimError, Tool, temporary_directory};

use super::circuit::MODULE;
use crate::synth::path::ReportedPath;
use crate::synth::place::{Frequency, Job};
use crate::synth::{SynthError, SynthTarget, yosys};

/// The programs, and what they are asked for.
pub struct Laboratory<'a> {
    target: &'a SynthTarget,
    synthesiser: Tool,
    placer: Tool,
    /// Seeds of the placer: 1 to this.
    seeds: u32,
    /// Frequency that the placer is asked for, in MHz. More than any circuit reaches, so that every
    /// path counts.
    asked_mhz: u32,
}

impl<'a> Laboratory<'a> {
    /// The programs for a target.
    pub fn new(target: &'a SynthTarget, seeds: u32) -> Result<Laboratory<'a>, SynthError> {
        let [synthesiser, placer] = [yosys::program()?, target.placer()?];
        Ok(Laboratory { target, synthesiser, placer, seeds, asked_mhz: 500 })
    }

    /// The programs with their versions.
    pub fn programs(&self) -> Result<[String; 2], SimError> {
        Ok([self.synthesiser.version_line()?, self.placer.version_line()?])
    }

    /// The error that a report lacks what the circuit has.
    pub fn absent(&self) -> SynthError {
        let problem = "it lacks the paths of the circuit that was measured".to_owned();
        SynthError::Report { program: self.placer.command, problem }
    }

    /// When signals arrive in a circuit, for each seed.
    pub fn route(&self, circuit: &str) -> Result<Vec<Arrivals>, SynthError> {
        let directory = temporary_directory()?;
        let path = directory.path();
        yosys::run_circuit(&self.synthesiser, path, (MODULE, circuit), self.target)?;
        let Laboratory { target, placer, asked_mhz, .. } = self;
        let job = Job { placer, directory: path, target, asked_mhz: *asked_mhz };
        let arrivals = |seed| {
            let text = job.report(seed, &["--detailed-timing-report"])?;
            Arrivals::read(&text).map_err(|problem| job.unknown(problem))
        };
        (1..=self.seeds).map(arrivals).collect()
    }
}

/// When signals arrive where a clock takes them over.
pub struct Arrivals {
    all: Vec<Arrival>,
    /// Mean delay of the cells on the slowest path, in nanoseconds.
    pub logic: Option<f64>,
}

/// The slowest path that ends in an input of a clocked cell.
struct Arrival {
    /// The cell that drives the input.
    driver: String,
    /// The clocked cell.
    cell: String,
    /// From the clock before to the clock, in nanoseconds. Set-up is included in that of the slowest
    /// path alone.
    nanoseconds: f64,
}

impl Arrivals {
    /// What nextpnr's report says, as far as it is from clock to clock.
    pub fn read(text: &str) -> Result<Arrivals, String> {
        let report: Report = serde_json::from_str(text).map_err(|error| error.to_string())?;
        let Report { detailed_net_timings, critical_paths, fmax } = report;
        let reached = fmax.values().map(|clock| clock.achieved).min_by(f64::total_cmp);
        let period = 1e3 / reached.ok_or("it tells no clock's frequency")?;
        let slowest = critical_paths.iter().find(|path| path.is_clocked());
        let slowest = slowest.ok_or("it tells no path from clock to clock")?;
        let mut all: Vec<Arrival> = detailed_net_timings.into_iter().flat_map(of_net).collect();
        // Nets are told without the set-up of their ends, the slowest path with it.
        all.extend(slowest.last_net().map(|[driver, cell]| Arrival {
            driver: driver.to_owned(),
            cell: cell.to_owned(),
            nanoseconds: slowest.nanoseconds(),
        }));
        let arrivals = Arrivals { all, logic: slowest.mean_logic() };
        let last = arrivals.slowest(|_, _| true).unwrap_or(0.0);
        if (last - period).abs() > 0.01 * period {
            return Err(format!("its slowest path takes {last} ns, and a clock {period} ns"));
        }
        Ok(arrivals)
    }

    /// The slowest path of those whose driver and end `counts`, by the beginnings of their names.
    pub fn slowest(&self, counts: impl Fn(&str, &str) -> bool) -> Option<f64> {
        let counted = self.all.iter().filter(|arrival| counts(&arrival.driver, &arrival.cell));
        counted.map(|arrival| arrival.nanoseconds).max_by(f64::total_cmp)
    }
}

#[derive(Deserialize)]
struct Report {
    detailed_net_timings: Vec<Net>,
    critical_paths: Vec<ReportedPath>,
    fmax: BTreeMap<String, Frequency>,
}

/// A net with the paths that end in it.
#[derive(Deserialize)]
struct Net {
    driver: String,
    event: String,
    endpoints: Vec<End>,
}

#[derive(Deserialize)]
struct End {
    cell: String,
    event: String,
    delay: Delay,
}

/// Newer versions of nextpnr tell the shortest and the longest delay.
#[derive(Deserialize)]
#[serde(untagged)]
enum Delay {
    Longest(f64),
    Both([f64; 2]),
}

fn of_net(net: Net) -> impl Iterator<Item = Arrival> {
    let Net { driver, event, endpoints } = net;
    let is_edge = |event: &str| event.contains("edge ");
    let clocked = is_edge(&event);
    let ends = endpoints.into_iter().filter(move |end| clocked && is_edge(&end.event));
    ends.map(move |End { cell, delay, .. }| {
        let (Delay::Longest(nanoseconds) | Delay::Both([_, nanoseconds])) = delay;
        Arrival { driver: driver.clone(), cell, nanoseconds }
    })
}
