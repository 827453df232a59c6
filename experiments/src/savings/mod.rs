//! What a core for one scene saves, need by need: each is measured by elaborating the core without
//! knowing it.
//!
//! What is known of a scene comes in two kinds: facts from which options and formats are chosen
//! before any input is looked at ([`needs`]), and what inputs are given over the frame
//! ([`inputs`]).
mod general;
mod inputs;
mod needs;
mod spared;

use serde::Serialize;
use specula_hdl::Design;
use specula_scene::{CoreSpec, LoadedScene};

use general::General;
use spared::Built;
use specula_testbench::BenchError;

pub use general::Baseline;
pub use spared::{Spared, SparedCells, Synthesis};

/// A need of a scene, and what knowing it saves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Saving {
    /// What is known of the scene.
    pub need: &'static str,
    /// What was left out or narrowed.
    pub left_out: String,
    /// What the core would have more without knowing.
    pub saves: Spared,
    /// Why nothing is lost.
    pub safe: &'static str,
}

/// A core for one scene against the general one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Savings {
    /// Need by need. They overlap, so they do not add up to the whole.
    pub needs: Vec<Saving>,
    /// Of all of them together, against general cores: first the one that knows nothing of the
    /// scene, then the one that a renderer would be built with.
    pub together: Vec<AgainstGeneral>,
}

/// What the core saves against a general one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct AgainstGeneral {
    /// Which.
    pub baseline: Baseline,
    /// What such a core is built for, in the words of a table.
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
    pub saves: Spared,
}

/// What the core of `spec` saves that is to shade a scene, with cells if `synthesis` makes them. A
/// need that saves nothing has no line.
///
/// # Errors
/// [`BenchError::TooWide`] if the core has too wide a signal, [`BenchError::Simulation`] if it
/// cannot be synthesised.
pub fn savings(
    scene: &LoadedScene,
    spec: &CoreSpec,
    synthesis: Option<Synthesis>,
) -> Result<Savings, BenchError> {
    let special = specula_hdl::elaborate(spec, "core")?;
    let (of_facts, of_inputs) =
        rayon::join(|| needs::ignorant(scene, spec), || inputs::of_inputs(spec));
    let (of_facts, generals) = of_facts?;
    let needs: Vec<Ignorant> = of_facts.into_iter().chain(of_inputs?).collect();
    let of_generals = generals.iter().map(|general| &general.design);
    let designs: Vec<&Design> = [&special]
        .into_iter()
        .chain(of_generals)
        .chain(needs.iter().map(|need| &need.design))
        .collect();
    let built = Built::all(&designs, synthesis)?;
    let (special, (of_generals, of_needs)) = (&built[0], built[1..].split_at(generals.len()));
    let saving = |(without, core): (&Ignorant, &Built)| Saving {
        need: without.need,
        left_out: without.left_out.clone(),
        saves: Spared::between(core, special),
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
        saves: Spared::between(built, special),
    };
    Ok(Savings { needs, together: generals.iter().zip(of_generals).map(against).collect() })
}

/// The core without knowing one need.
struct Ignorant {
    need: &'static str,
    left_out: String,
    safe: &'static str,
    design: Design,
}
