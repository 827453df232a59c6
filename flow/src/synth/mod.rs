//! Synthesis and place-and-route of a core, by programs that need no vendor's licence: Yosys and
//! nextpnr.
//!
//! A core has more ports than a device has pins, so it stands in a harness of three pins. Cells are
//! those of the core alone. nextpnr's result depends on the seed of its placer, so it runs with
//! several, and the median is what a core reaches. What Yosys has made of the core is also a
//! [`Netlist`] that a simulator runs.
mod cells;
mod harness;
mod logic;
mod models;
mod netlist;
pub(crate) mod path;
pub(crate) mod place;
mod target;
pub(crate) mod yosys;

use rayon::prelude::*;
use serde::Serialize;
use specula_datapath::Design;
use specula_sim::{SimError, temporary_directory};

pub use cells::Cells;
pub use logic::Logic;
pub use netlist::Netlist;
pub use path::{CriticalPath, Step};
pub use place::Placed;
pub use target::SynthTarget;

/// Why a core was not synthesised, placed and routed.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SynthError {
    /// A program is absent or failed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Tool(#[from] SimError),
    /// The core cannot be placed or routed.
    #[error("the core cannot be placed on the {device}:\n{output}")]
    #[diagnostic(
        code(specula::synth::placement),
        help(
            "a core that needs more cells than the device has takes a larger target, another \
             method, or narrower formats (`--bound`, `--max-error`)"
        )
    )]
    NotPlaced {
        /// The device.
        device: &'static str,
        /// What nextpnr printed.
        output: String,
    },
    /// Yosys comes without models of the device's cells.
    #[error("Yosys has no models of the cells of `{target}`, which a simulation needs:\n{output}")]
    #[diagnostic(
        code(specula::synth::models),
        help("they come with Yosys: install the whole of it, or leave out `--simulate`")
    )]
    NoModels {
        /// The target.
        target: &'static str,
        /// What Yosys printed.
        output: String,
    },
    /// nextpnr's report is not what this version of Specula knows.
    #[error("the report of `{program}` cannot be read: {problem}")]
    #[diagnostic(
        code(specula::synth::report),
        help(
            "Specula knows the reports of nextpnr 0.4 to 0.11: please report this with its version"
        )
    )]
    Report {
        /// The program.
        program: &'static str,
        /// What is wrong with the report.
        problem: String,
    },
}

/// What a device makes of a core.
#[derive(Clone, Debug, Serialize)]
pub struct Synthesis {
    /// Name of the target.
    pub target: &'static str,
    /// The device, with speed grade and package.
    pub device: &'static str,
    /// The programs, with their versions.
    pub programs: Vec<String>,
    /// Cells of the core, without those of the harness.
    pub cells: Cells,
    /// Frequency that place-and-route was asked for, in MHz.
    pub asked_mhz: u32,
    /// What came of each seed of the placer, in the order of seeds.
    pub seeds: Vec<Placed>,
    /// The core in cells of the device.
    #[serde(skip)]
    pub netlist: Netlist,
}

impl Synthesis {
    /// What came of the seed whose frequency is the median; the lower one of the two in the middle.
    pub fn median(&self) -> Option<&Placed> {
        let mut sorted: Vec<&Placed> = self.seeds.iter().collect();
        sorted.sort_by(|a, b| a.reached_mhz.total_cmp(&b.reached_mhz));
        sorted.get(sorted.len().saturating_sub(1) / 2).copied()
    }
}

/// The cells that Yosys makes of a design for a target.
///
/// # Errors
/// [`SynthError::Tool`] if Yosys is not installed or fails.
pub fn synthesised(design: &Design, target: &SynthTarget) -> Result<Cells, SynthError> {
    let (yosys, directory) = (yosys::program()?, temporary_directory()?);
    Ok(yosys::run(&yosys, directory.path(), design, target)?.0)
}

/// The cells that Yosys makes of each design for a target, and what it takes in logic alone; as many
/// at a time as there are processors. `watch` is told of each that is done.
///
/// # Errors
/// [`SynthError::Tool`] if Yosys is not installed or fails.
pub fn synthesised_both_ways(
    designs: &[Design],
    target: &SynthTarget,
    watch: &(dyn Fn() + Sync),
) -> Result<Vec<(Cells, Logic)>, SynthError> {
    let both = |design: &Design| {
        let both = (synthesised(design, target)?, Logic::of(design)?);
        watch();
        Ok(both)
    };
    designs.par_iter().map(both).collect()
}

/// The synthesiser that is used, with its version.
///
/// # Errors
/// [`SynthError::Tool`] if Yosys is not installed.
pub fn synthesiser() -> Result<String, SynthError> {
    Ok(yosys::program()?.version_line()?)
}

/// Synthesises a design for a target, places and routes it with the seeds 1 to `seeds` for
/// `asked_mhz`, as many at a time as there are processors, and tells `watch` how many are done.
///
/// # Errors
/// [`SynthError::Tool`] if a program is not installed or Yosys fails, [`SynthError::NotPlaced`] if
/// nextpnr does, as with more cells than the device has, and [`SynthError::Report`] if its report
/// cannot be read.
pub fn synthesise_and_place(
    design: &Design,
    target: &SynthTarget,
    (asked_mhz, seeds): (u32, u32),
    watch: &(dyn Fn() + Sync),
) -> Result<Synthesis, SynthError> {
    let [synthesiser, placer] = [yosys::program()?, target.placer()?];
    let directory = temporary_directory()?;
    let (cells, netlist) = yosys::run(&synthesiser, directory.path(), design, target)?;
    let job = place::Job { placer: &placer, directory: directory.path(), target, asked_mhz };
    let placed = (1..=seeds).into_par_iter().map(|seed| {
        let placed = job.run(design, seed);
        watch();
        placed
    });
    let seeds = placed.collect::<Result<Vec<Placed>, SynthError>>()?;
    let programs = vec![synthesiser.version_line()?, placer.version_line()?];
    let SynthTarget { name, device, .. } = *target;
    Ok(Synthesis { target: name, device, programs, cells, asked_mhz, seeds, netlist })
}
