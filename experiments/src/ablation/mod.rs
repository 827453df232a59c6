//! What a core for one scene saves, need by need: each saving is measured by an ablation, which
//! elaborates the core without knowing the need.
//!
//! What is known of a scene comes in two kinds: premises from which options and formats are chosen
//! before any input is looked at ([`needs`]), and what inputs are given over the frame
//! ([`inputs`]).
mod general;
mod inputs;
mod needs;
mod premise;
mod size_delta;

use serde::Serialize;
use specula_datapath::Design;
use specula_scene::LoadedScene;
use specula_spec::CoreSpec;

use general::General;
use size_delta::Built;
use specula_testbench::BenchError;

pub use general::Baseline;
pub use size_delta::{CellDelta, SizeDelta, Synthesis};

/// A need of a scene, and what knowing it saves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Saving {
    /// What is known of the scene.
    pub need: &'static str,
    /// What was left out or narrowed.
    pub left_out: String,
    /// What the core would have more without knowing.
    pub saves: SizeDelta,
    /// Why nothing is lost.
    pub safe: &'static str,
}

/// A core for one scene against the general one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Savings {
    /// The savings need by need. They overlap, so they do not add up to the whole.
    pub needs: Vec<Saving>,
    /// The savings of all needs together, against general cores: first the one that knows nothing
    /// of the scene, then the one that a renderer would be built with.
    pub together: Vec<AgainstGeneral>,
}

/// What the core saves against a general one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct AgainstGeneral {
    /// The general core that it is compared with.
    pub baseline: Baseline,
    /// What such a core is built for, as a table's text.
    pub built_for: String,
    /// Lights that it has pipelines for.
    pub lights: usize,
    /// Pixels of its longest span.
    pub longest_span: u32,
    /// Its largest exponent.
    pub largest_shininess: u32,
    /// What it knows of the scene all the same, since none could be built without.
    pub known: Vec<&'static str>,
    /// What is saved.
    pub saves: SizeDelta,
}

/// What the core of `spec`, which is to shade a scene, saves by its needs; in cells too if
/// `synthesis` makes them. A need that saves nothing is left out.
///
/// # Errors
/// [`BenchError::TooWide`] if the core has too wide a signal, [`BenchError::Simulation`] if it
/// cannot be synthesised.
pub fn ablation(
    scene: &LoadedScene,
    spec: &CoreSpec,
    synthesis: Option<Synthesis>,
) -> Result<Savings, BenchError> {
    let special = specula_hdl::elaborate(spec, "core")?;
    let (of_premises, of_inputs) =
        rayon::join(|| needs::of_premises(scene, spec), || inputs::of_inputs(spec));
    let (of_premises, generals) = of_premises?;
    let needs: Vec<Ablation> = of_premises.into_iter().chain(of_inputs?).collect();
    let of_generals = generals.iter().map(|general| &general.design);
    let designs: Vec<&Design> = [&special]
        .into_iter()
        .chain(of_generals)
        .chain(needs.iter().map(|need| &need.design))
        .collect();
    let built = Built::all(&designs, synthesis)?;
    let (special, (of_generals, of_needs)) = (&built[0], built[1..].split_at(generals.len()));
    let saving = |(without, core): (&Ablation, &Built)| Saving {
        need: without.need,
        left_out: without.left_out.clone(),
        saves: SizeDelta::between(core, special),
        safe: without.safe,
    };
    let needs = needs
        .iter()
        .zip(of_needs)
        .map(saving)
        .filter(|saving| !saving.saves.is_nothing())
        .collect();
    let against = |(general, built): (&General, &Built)| AgainstGeneral {
        baseline: general.baseline,
        built_for: general.built_for(),
        lights: general.needs.lights,
        longest_span: general.needs.longest_span,
        largest_shininess: general.needs.largest_shininess,
        known: general.known.clone(),
        saves: SizeDelta::between(built, special),
    };
    Ok(Savings { needs, together: generals.iter().zip(of_generals).map(against).collect() })
}

/// The core elaborated without knowing one need.
struct Ablation {
    need: &'static str,
    left_out: String,
    safe: &'static str,
    design: Design,
}
