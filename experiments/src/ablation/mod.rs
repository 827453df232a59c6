//! The savings of a core for one scene, need by need. Each is measured by an ablation, that is, by
//! elaborating the core without knowing the need.
//!
//! There are two kinds of knowledge about a scene: premises, from which options and formats are
//! chosen before any input is looked at ([`needs`]), and the values of inputs over the frame
//! ([`inputs`]).
mod core;
mod general;
mod inputs;
mod keeping;
mod needs;
mod premise;
mod size_delta;

use serde::Serialize;
use specula_datapath::Design;
use specula_scene::LoadedScene;
use specula_spec::CoreSpec;
use specula_testbench::BenchError;

use crate::formats::SequenceError;
use core::Ablation;
use general::General;
use size_delta::Built;

pub use general::Baseline;
pub use keeping::{KeepCost, KeepError, keep_costs};
pub use size_delta::{CellDelta, SizeDelta, Synthesis};

/// A need of a scene, and what knowing it saves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Saving {
    /// The knowledge about the scene.
    pub need: &'static str,
    /// What was left out or narrowed.
    pub left_out: String,
    /// The additional hardware of a core that does not know the need.
    pub saves: SizeDelta,
    /// Why nothing is lost.
    pub safe: &'static str,
}

/// A core for one scene against the general one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Savings {
    /// The savings need by need. They overlap, so their sum is not the whole.
    pub needs: Vec<Saving>,
    /// The savings of all needs together, compared with two general cores: first the one for any
    /// scene, then the one for a renderer.
    pub together: Vec<AgainstGeneral>,
}

/// What the core saves against a general one.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct AgainstGeneral {
    /// The general core that it is compared with.
    pub baseline: Baseline,
    /// A table's text about what that core is built for.
    pub built_for: String,
    /// Number of lights that it has pipelines for.
    pub lights: usize,
    /// Length of its longest span in pixels.
    pub longest_span: u32,
    /// Its largest exponent.
    pub largest_shininess: u32,
    /// The premises that it needs to know all the same, since no core could be built without them.
    pub known: Vec<&'static str>,
    /// The difference in size.
    pub saves: SizeDelta,
}

/// The savings of the core of `spec`, which is to shade a scene; also in cells if `synthesis` is
/// given. Needs that save nothing are left out.
///
/// # Errors
/// [`BenchError::TooWide`] if the core has a signal that is too wide, [`BenchError::Simulation`] if
/// it cannot be synthesised; the scene's if a frame of its sequence cannot be drawn.
pub fn ablation(
    scene: &LoadedScene,
    spec: &CoreSpec,
    synthesis: Option<Synthesis>,
) -> Result<Savings, SequenceError> {
    let special = specula_hdl::elaborate(spec, "core").map_err(BenchError::from)?;
    let (premise_ablations, input_ablations) =
        rayon::join(|| needs::premise_ablations(scene, spec), || inputs::input_ablations(spec));
    let (premise_ablations, generals) = premise_ablations?;
    let needs: Vec<Ablation> = premise_ablations.into_iter().chain(input_ablations?).collect();
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
