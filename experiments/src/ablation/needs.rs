//! Ablations of premises: the core elaborated without one known premise.
use std::borrow::Cow;

use rayon::prelude::*;
use specula_datapath::builder::BuildError;
use specula_scene::{Frame, LoadedScene, Needs, SceneError};
use specula_spec::{CoreError, CoreSpec, InputPort, SceneCore};
use specula_testbench::BenchError;

use super::core::Ablation;
use super::general::{Baseline, General};
use super::premise::{PREMISES, Premise};
use crate::formats::SequenceError;

/// The ablations of those premises without which the core differs and can be built, and the general
/// cores.
///
/// # Errors
/// [`SequenceError`] if the scene's own general core cannot be built, or a frame of its sequence
/// cannot be drawn.
pub fn premise_ablations(
    scene: &LoadedScene,
    spec: &CoreSpec,
) -> Result<(Vec<Ablation>, Vec<General>), SequenceError> {
    let chosen = Chosen::new(scene, spec)?;
    let one = || PREMISES.par_iter().filter_map(|premise| chosen.ablation(premise)).collect();
    let general = || {
        Baseline::ALL.par_iter().map(|&baseline| chosen.general(baseline)).collect::<Result<_, _>>()
    };
    let (needs, generals) = rayon::join(one, general);
    Ok((needs, generals.map_err(BenchError::from)?))
}

/// A core, and how it was chosen.
struct Chosen<'a> {
    scene: &'a LoadedScene,
    /// Frames that stand for all that the scene has.
    frames: Cow<'a, [Frame]>,
    spec: &'a CoreSpec,
    /// The core for the scene alone.
    special: CoreSpec,
    needs: Needs,
    /// The choice for the needs, before any format is narrowed.
    general: Result<CoreSpec, CoreError>,
}

impl Chosen<'_> {
    fn new<'a>(scene: &'a LoadedScene, spec: &'a CoreSpec) -> Result<Chosen<'a>, SceneError> {
        let needs = scene.needs()?;
        let general = scene.core_for(&needs, Some(spec.method()));
        let frames = scene.deciding_frames(spec)?;
        let special = spec.specialised(&frames[..]);
        Ok(Chosen { scene, frames, spec, special, needs, general })
    }

    fn ablation(&self, premise: &Premise) -> Option<Ablation> {
        let general = self.without(&[premise]).filter(|core| *core != self.spec.general())?;
        let core = self.knowing_inputs(general);
        let design = specula_hdl::elaborate(&core, "core").ok()?;
        let left_out = [(premise.known)(&self.needs), differences(self.spec, &core)].concat();
        Some(Ablation { need: premise.need, left_out, safe: premise.safe, design })
    }

    /// The general core in which every premise is relaxed as the baseline says, or as many premises
    /// as possible if no core can be built without all of them.
    fn general(&self, baseline: Baseline) -> Result<General, BuildError> {
        let (mut core, mut relaxed, mut known) = (self.spec.general(), vec![], vec![]);
        let mut design = specula_hdl::elaborate(&core, "core")?;
        for premise in PREMISES.iter().filter(|premise| !baseline.knows(premise.need)) {
            relaxed.push(premise);
            let unconstrained =
                self.for_needs(&baseline.relax(&self.needs, &self.scene.frame, &relaxed));
            // Without many premises the core is the same, and that one is built already.
            if unconstrained.as_ref() == Some(&core) {
                continue;
            }
            let built = unconstrained.and_then(|unconstrained| {
                Some((specula_hdl::elaborate(&unconstrained, "core").ok()?, unconstrained))
            });
            match built {
                Some(built) => (design, core) = built,
                None => {
                    relaxed.pop();
                    known.push(premise.need);
                }
            }
        }
        let needs = baseline.relax(&self.needs, &self.scene.frame, &relaxed);
        Ok(General { baseline, needs, design, known })
    }

    /// The core with the knowledge of its inputs over the frame; or, if it has other lights than
    /// the frame, of those inputs that the scene's core also has.
    fn knowing_inputs(&self, core: CoreSpec) -> CoreSpec {
        let places = |core: &CoreSpec| {
            (
                core.parameters.lights,
                core.parameters.local_lights.clone(),
                core.parameters.local_eye,
            )
        };
        if places(&core) == places(self.spec) {
            return core.specialised_as(&self.special, &self.frames[..]);
        }
        let (own, theirs) = (core.inputs(), self.spec.general().inputs());
        let port =
            |ports: &[InputPort], name: &str| ports.iter().find(|port| port.name == name).cloned();
        // Whatever is known of its values is so for as long as it is held.
        let alike =
            |own: InputPort, theirs: InputPort| InputPort { hold: own.hold, ..theirs } == own;
        let known = |name: &str| {
            port(&own, name)
                .zip(port(&theirs, name))
                .is_some_and(|(own, theirs)| alike(own, theirs))
        };
        CoreSpec { specialisation: self.spec.specialisation.restricted(known), ..core }
    }

    /// The general core for scenes for which these premises are unknown; `None` if it cannot be
    /// described.
    fn without(&self, premises: &[&Premise]) -> Option<CoreSpec> {
        self.for_needs(&Baseline::Nothing.relax(&self.needs, &self.scene.frame, premises))
    }

    /// The general core for these needs; `None` if it cannot be described.
    fn for_needs(&self, needs: &Needs) -> Option<CoreSpec> {
        let to = self.scene.core_for(needs, Some(self.spec.method())).ok()?;
        self.spec.rebased(self.general.as_ref().ok()?, &to).ok()
    }
}

/// The end of a line about further differences of the core for the scene: other options and
/// narrower formats.
fn differences(spec: &CoreSpec, core: &CoreSpec) -> String {
    let theirs = core.method_options();
    let option = |(name, own): (&str, String)| {
        let (_, other) = theirs.iter().find(|(option, other)| *option == name && *other != own)?;
        Some(format!("; {name}: {own}, not {other}"))
    };
    let options: String = spec.method_options().into_iter().filter_map(option).collect();
    let (points, others) = (spec.narrowing_points(), core.narrowing_points());
    let width = |name: &str| {
        others.iter().find(|point| point.name == name).map(|point| point.format.width())
    };
    let narrower = points
        .iter()
        .filter(|point| width(point.name).is_some_and(|other| other > point.format.width()))
        .count();
    let formats = if narrower > 0 {
        format!("; narrower formats: {narrower} of {}", points.len())
    } else {
        String::new()
    };
    options + &formats
}
