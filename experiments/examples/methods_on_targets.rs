//! Prints the table of `docs/targets.md`: every method's core for a scene on every target, as `specula
//! synth` makes it, counted by Yosys beside what is estimated, and the clock that one run of nextpnr
//! reaches beside the predicted one.
//!
//!     cargo run --release -p specula-experiments --example methods_on_targets -- teapot [WORD]...
//!
//! Words choose methods and targets by their names, and `general` cores in place of those that are
//! made for the scene alone; `unplaced` leaves nextpnr out.
use std::process::ExitCode;

use specula_datapath::resources::Resources;
use specula_datapath::target::Target;
use specula_datapath::timing::Timing;
use specula_experiments::formats::{DefaultCore, Products, default_core};
use specula_flow::synth::{SynthTarget, Synthesis, synthesise_and_place, synthesised};
use specula_scene::LoadedScene;
use specula_spec::{CoreSpec, Method, SceneCore, TargetClock};

/// Targets that have delays.
const TARGETS: [&str; 4] = ["ecp5", "ice40up", "ice40hx", "xilinx7"];

/// What a core is made for.
#[derive(Clone, Copy)]
enum Purpose {
    /// The scene alone.
    Scene,
    /// Every input variable.
    General,
}

/// How far a core is taken.
#[derive(Clone, Copy)]
enum Extent {
    /// Synthesised, to count its cells.
    Counted,
    /// Placed and routed too.
    Placed,
}

/// The error of a row.
type Failure = Box<dyn std::error::Error>;

fn main() -> ExitCode {
    let mut words = std::env::args().skip(1);
    let scene = words.next().and_then(|name| specula_scene::load(&name, None).ok());
    let Some(scene) = scene else {
        eprintln!("usage: methods_on_targets SCENE [METHOD|TARGET|general|unplaced]...");
        return ExitCode::from(2);
    };
    let words: Vec<String> = words.collect();
    let is_named = |name: &str| words.iter().any(|word| word == name);
    let methods = named(Method::ALL.to_vec(), |method| is_named(method.name()));
    let targets = named(TARGETS.to_vec(), |target| is_named(target));
    let purpose = if is_named("general") { Purpose::General } else { Purpose::Scene };
    let extent = if is_named("unplaced") { Extent::Counted } else { Extent::Placed };
    println!(
        "| method | target | LUTs | estimated | flip-flops | counted | blocks | RAM | MHz | predicted |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|");
    for &method in &methods {
        for target in &targets {
            match row(&scene, method, target, (purpose, extent)) {
                Ok(row) => println!("| {} | `{target}` | {} |", method.name(), row.join(" | ")),
                Err(error) => eprintln!("{} on {target}: {error}", method.name()),
            }
        }
    }
    ExitCode::SUCCESS
}

/// Those that are named, or all if none is.
fn named<T: Copy>(all: Vec<T>, is_named: impl Fn(&T) -> bool) -> Vec<T> {
    let chosen: Vec<T> = all.iter().copied().filter(|one| is_named(one)).collect();
    if chosen.is_empty() { all } else { chosen }
}

/// The figures of a method's core on a target, at its highest clock.
fn row(
    scene: &LoadedScene,
    method: Method,
    target: &str,
    (purpose, extent): (Purpose, Extent),
) -> Result<Vec<String>, Failure> {
    let spec = scene.core_spec(Some(method))?;
    let spec = match purpose {
        Purpose::Scene => spec,
        Purpose::General => spec.general(),
    };
    let products = Products::Of(Box::new(Target::named(target).ok_or("there is no such target")?));
    let named = scene.named_formats(method)?;
    let DefaultCore { spec, .. } = default_core(spec, &scene.frame, &named, products)?;
    let at = |clock_mhz| CoreSpec {
        target: Some(TargetClock { name: target.to_owned(), clock_mhz }),
        ..spec.clone()
    };
    let clock_mhz = specula_hdl::highest_clock(&at(1.0))?;
    let design = specula_hdl::elaborate(&at(clock_mhz), "core")?;
    let table = TargetClock { name: target.to_owned(), clock_mhz }.target()?;
    let estimated = Resources::of(&design, &table);
    let predicted = Timing::of(&design, &table).map_or(0.0, |timing| timing.mhz());
    let synth = SynthTarget::ALL.into_iter().find(|synth| synth.name == target);
    let (made, reached) = match (&synth, extent) {
        (None, _) => (None, None),
        (Some(synth), Extent::Counted) => (Some(synthesised(&design, synth)?), None),
        (Some(synth), Extent::Placed) => {
            match synthesise_and_place(&design, synth, (clock_mhz as u32, 1), &|| ()) {
                Ok(synthesis) => (Some(synthesis.cells), median(&synthesis)),
                Err(error) => {
                    eprintln!("{} on {target}: {error}", method.name());
                    (Some(synthesised(&design, synth)?), None)
                }
            }
        }
    };
    let made = |of: fn(&specula_flow::synth::Cells) -> u64| {
        made.as_ref().map_or("–".to_owned(), |cells| of(cells).to_string())
    };
    Ok(vec![
        made(|cells| cells.luts),
        estimated.luts.to_string(),
        made(|cells| cells.flip_flops),
        estimated.flip_flops.to_string(),
        made(|cells| cells.blocks),
        made(|cells| cells.memories),
        reached.map_or("–".to_owned(), |mhz| format!("{mhz:.0}")),
        format!("{predicted:.0}"),
    ])
}

/// The clock that the only seed reaches, in MHz.
fn median(synthesis: &Synthesis) -> Option<f64> {
    synthesis.median().map(|placed| placed.reached_mhz)
}
