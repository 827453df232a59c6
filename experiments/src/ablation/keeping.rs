//! What it costs to keep things variable.
use rayon::prelude::*;
use serde::Serialize;
use specula_datapath::Design;
use specula_scene::LoadedScene;
use specula_spec::{CoreError, Method, SceneCore};
use specula_testbench::BenchError;

use super::size_delta::{Built, SizeDelta};
use crate::formats::{DefaultCore, Products, default_core};

/// What can be kept.
const THINGS: [&str; 4] = ["lights", "materials", "camera", "objects"];

/// What it costs to keep a thing.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct KeepCost {
    /// The thing, as `keep` of `[core]` has it.
    pub thing: &'static str,
    /// The additional hardware of a core that keeps it, against one that keeps nothing.
    pub costs: SizeDelta,
}

/// Why it is not known what something costs.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum KeepError {
    /// There is no such core for the scene.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Core(#[from] CoreError),
    /// The core cannot be built.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Bench(#[from] BenchError),
}

/// What each thing costs by itself, each core in the formats that it is given by default. A thing
/// that no core can keep, since the method cannot serve whatever may come, is left out.
///
/// # Errors
/// [`KeepError`] if there is no core that keeps nothing.
pub fn keep_costs(
    scene: &LoadedScene,
    method: Method,
    products: &Products,
) -> Result<Vec<KeepCost>, KeepError> {
    let keeping = |keep: &[&str]| keeping(scene, keep, method, products);
    let fixed = keeping(&[])?;
    let kept: Vec<Option<Design>> = THINGS.par_iter().map(|thing| keeping(&[thing]).ok()).collect();
    let built =
        |design| -> Result<Built, KeepError> { Ok(Built::all(&[design], None)?.swap_remove(0)) };
    let fixed = built(&fixed)?;
    let all = THINGS.into_iter().zip(&kept);
    all.filter_map(|(thing, design)| Some((thing, design.as_ref()?)))
        .map(|(thing, design)| {
            Ok(KeepCost { thing, costs: SizeDelta::between(&built(design)?, &fixed) })
        })
        .collect()
}

fn keeping(
    scene: &LoadedScene,
    keep: &[&str],
    method: Method,
    products: &Products,
) -> Result<Design, KeepError> {
    let core = scene.core_keeping(keep, Some(method))?;
    let frames = scene.deciding_frames(&core).map_err(CoreError::from)?;
    let named = scene.named_formats(method)?;
    let DefaultCore { spec, .. } = default_core(core, &frames[..], &named, products.clone())?;
    Ok(specula_hdl::elaborate(&spec, "core").map_err(BenchError::from)?)
}
