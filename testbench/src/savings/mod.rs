//! What a core for one scene saves, need by need: each is measured by elaborating the core without knowing it.
//!
//! What is known of a scene comes in two kinds: facts from which options and formats are chosen before any input is looked at ([`needs`]), and what inputs
//! are given over the frame ([`inputs`]).
mod inputs;
mod needs;
mod spared;

use serde::Serialize;
use specula_hdl::Design;
use specula_scene::{CoreSpec, LoadedScene};

use crate::BenchError;
use spared::Built;

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
    /// Of all of them together: against the core that knows nothing of the scene but what [`Savings::known`] names.
    pub together: Spared,
    /// What that core has to know all the same, since none could be built without.
    pub known: Vec<&'static str>,
}

/// What the core of `spec` saves that is to shade a scene, with cells if `synthesis` makes them. A need that saves nothing has no line.
///
/// # Errors
/// [`BenchError::TooWide`] if the core has too wide a signal, [`BenchError::Simulation`] if it cannot be synthesised.
pub fn savings(scene: &LoadedScene, spec: &CoreSpec, synthesis: Option<Synthesis>) -> Result<Savings, BenchError> {
    let special = specula_hdl::elaborate(spec, "core")?;
    let (of_facts, of_inputs) = rayon::join(|| needs::ignorant(scene, spec), || inputs::of_inputs(spec));
    let (of_facts, nothing) = of_facts?;
    let needs: Vec<Ignorant> = of_facts.into_iter().chain(of_inputs?).collect();
    let designs: Vec<&Design> = [&special, &nothing.design].into_iter().chain(needs.iter().map(|need| &need.design)).collect();
    let built = Built::all(&designs, synthesis)?;
    let (special, ignorant, of_needs) = (&built[0], &built[1], &built[2..]);
    let saving = |(without, core): (&Ignorant, &Built)| Saving {
        need: without.need,
        left_out: without.left_out.clone(),
        saves: Spared::between(core, special),
        safe: without.safe,
    };
    let needs = needs.iter().zip(of_needs).map(saving).filter(|saving| !saving.saves.is_nothing()).collect();
    Ok(Savings { needs, together: Spared::between(ignorant, special), known: nothing.known })
}

/// The core without knowing one need.
struct Ignorant {
    need: &'static str,
    left_out: String,
    safe: &'static str,
    design: Design,
}
