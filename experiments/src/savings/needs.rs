//! Cores that do not know some of a scene's needs.
use rayon::prelude::*;
use specula_datapath::builder::BuildError;
use specula_scene::needs::LocalKind;
use specula_scene::spec::{InputPort, LARGEST_SHININESS, LONGEST_SPAN, MOST_LIGHTS};
use specula_scene::{CoreSpec, LoadedScene, Needs, SceneError};

use super::Ignorant;
use super::general::{Baseline, General};

/// What may be known of a scene before any of its inputs is.
pub(super) struct Fact {
    pub need: &'static str,
    safe: &'static str,
    /// The needs of scenes of which it is not known.
    pub forget: fn(&mut Needs),
    /// What is known, in the words of a table.
    known: fn(&Needs) -> String,
}

/// Names of the facts that a renderer's core is built with.
pub(super) const LIGHTS: &str = "number of lights";
pub(super) const LIGHTS_AT_INFINITY: &str = "lights at infinity";
pub(super) const EYE_AT_INFINITY: &str = "eye at infinity";

/// Every fact on which [`LoadedScene::core_for`] rests.
const FACTS: [Fact; 10] = [
    Fact {
        need: LIGHTS,
        safe: "the scene has no more lights",
        // Lights at places are the last ones, so more lights at infinity would have their names.
        forget: |needs| {
            needs.lights = if needs.local_lights.is_empty() { MOST_LIGHTS } else { needs.lights }
        },
        known: |needs| {
            format!("{} of {MOST_LIGHTS} pipelines for lights", MOST_LIGHTS - needs.lights)
        },
    },
    Fact {
        need: LIGHTS_AT_INFINITY,
        safe: "the direction to such a light is the same everywhere",
        forget: |needs| {
            let at_infinity = needs.lights - needs.local_lights.len();
            needs.local_lights.splice(0..0, vec![LocalKind::Point; at_infinity]);
        },
        known: |needs| {
            format!(
                "directions to the places of {} lights",
                needs.lights - needs.local_lights.len()
            )
        },
    },
    Fact {
        need: EYE_AT_INFINITY,
        safe: "the direction to the eye is the same everywhere",
        forget: |needs| needs.local_eye = true,
        known: |_| "directions to the place of the eye".to_owned(),
    },
    Fact {
        need: "longest span",
        safe: "no span of this frame is longer",
        forget: |needs| needs.longest_span = LONGEST_SPAN,
        known: |needs| format!("spans of {} pixels, not {LONGEST_SPAN}", needs.longest_span),
    },
    Fact {
        need: "angle between the normals of a span",
        safe: "no span of this frame has a wider one",
        forget: |needs| (needs.widest_angle, needs.shortest_normal) = (180.0, 0.0),
        known: |needs| format!("{:.1} degrees, not 180", needs.widest_angle),
    },
    Fact {
        need: "angle between normals and faces",
        safe: "no triangle of this frame has a wider one",
        forget: |needs| needs.least_cone_cosine = -1.0,
        known: |needs| {
            format!(
                "{:.1} degrees, not 180",
                needs.least_cone_cosine.clamp(-1.0, 1.0).acos().to_degrees()
            )
        },
    },
    Fact {
        need: "distance to places",
        safe: "no span of this frame comes nearer to one",
        forget: |needs| {
            if !needs.directions_are_constant() {
                (needs.shortest_way, needs.shortest_unit_way) = (0.0, 0.0);
            }
        },
        known: |needs| {
            format!(
                "vectors to places of {:.3} of the longer end's length at least",
                needs.shortest_way
            )
        },
    },
    Fact {
        need: "largest exponent",
        safe: "no material of this frame has a larger one",
        forget: |needs| needs.largest_shininess = LARGEST_SHININESS,
        known: |needs| format!("n = {}, not {LARGEST_SHININESS}", needs.largest_shininess),
    },
    Fact {
        need: "exponents are powers of two",
        safe: "squaring reaches every exponent of this frame",
        forget: |needs| needs.uneven_shininess = Some(UNEVEN),
        known: |_| "exponents between them".to_owned(),
    },
    Fact {
        need: "flat normals",
        safe: "the normal is the same, and of unit length, all over each triangle",
        forget: |needs| needs.flat = false,
        known: |_| "making interpolated normals unit vectors".to_owned(),
    },
];

/// An exponent that squaring does not reach.
const UNEVEN: u32 = 3;

/// The cores for scenes of which one fact is not known, where that makes another core and it can be
/// built; and the general cores.
///
/// # Errors
/// [`BuildError`] if not even the scene's own general core can be built.
pub fn ignorant(
    scene: &LoadedScene,
    spec: &CoreSpec,
) -> Result<(Vec<Ignorant>, Vec<General>), BuildError> {
    let chosen = Chosen::new(scene, spec);
    let one = || FACTS.par_iter().filter_map(|fact| chosen.ignorant(fact)).collect();
    let general = || {
        Baseline::ALL.par_iter().map(|&baseline| chosen.general(baseline)).collect::<Result<_, _>>()
    };
    let (needs, generals) = rayon::join(one, general);
    Ok((needs, generals?))
}

/// A core, and how it was chosen.
struct Chosen<'a> {
    scene: &'a LoadedScene,
    spec: &'a CoreSpec,
    /// The core for the scene alone.
    special: CoreSpec,
    needs: Needs,
    /// What is chosen for the needs, before any format is narrowed.
    general: Result<CoreSpec, SceneError>,
}

impl Chosen<'_> {
    fn new<'a>(scene: &'a LoadedScene, spec: &'a CoreSpec) -> Chosen<'a> {
        let needs = Needs::of(&scene.frame);
        let general = scene.core_for(&needs, Some(spec.method()));
        Chosen { scene, spec, special: spec.specialised(&scene.frame), needs, general }
    }

    fn ignorant(&self, fact: &Fact) -> Option<Ignorant> {
        let general = self.without(&[fact]).filter(|core| *core != self.spec.general())?;
        let core = self.knowing_inputs(general);
        let design = specula_hdl::elaborate(&core, "core").ok()?;
        let left_out = [(fact.known)(&self.needs), differences(self.spec, &core)].concat();
        Some(Ignorant { need: fact.need, left_out, safe: fact.safe, design })
    }

    /// The general core that forgets every fact as a baseline has it, or as many as one can be
    /// built without.
    fn general(&self, baseline: Baseline) -> Result<General, BuildError> {
        let (mut core, mut forgotten, mut known) = (self.spec.general(), vec![], vec![]);
        let mut design = specula_hdl::elaborate(&core, "core")?;
        for fact in FACTS.iter().filter(|fact| !baseline.knows(fact.need)) {
            forgotten.push(fact);
            let ignorant =
                self.for_needs(&baseline.forget(&self.needs, &self.scene.frame, &forgotten));
            // Many facts make no other core, and that is built already.
            if ignorant.as_ref() == Some(&core) {
                continue;
            }
            let built = ignorant.and_then(|ignorant| {
                Some((specula_hdl::elaborate(&ignorant, "core").ok()?, ignorant))
            });
            match built {
                Some(ignorant) => (design, core) = ignorant,
                None => {
                    forgotten.pop();
                    known.push(fact.need);
                }
            }
        }
        let needs = baseline.forget(&self.needs, &self.scene.frame, &forgotten);
        Ok(General { baseline, needs, design, known })
    }

    /// The core with what is known of its inputs: over the frame, or, if it has other lights than
    /// the frame, of those inputs that the scene's core has too.
    fn knowing_inputs(&self, core: CoreSpec) -> CoreSpec {
        let places = |core: &CoreSpec| (core.lights, core.local_lights.clone(), core.local_eye);
        if places(&core) == places(self.spec) {
            return core.specialised_as(&self.special, &self.scene.frame);
        }
        let (own, theirs) = (core.inputs(), self.spec.general().inputs());
        let port =
            |ports: &[InputPort], name: &str| ports.iter().find(|port| port.name == name).cloned();
        let known =
            |name: &str| port(&own, name).is_some_and(|own| Some(own) == port(&theirs, name));
        CoreSpec { specialisation: self.spec.specialisation.only(known), ..core }
    }

    /// The general core for scenes of which these facts are not known; none where it cannot be
    /// described.
    fn without(&self, facts: &[&Fact]) -> Option<CoreSpec> {
        self.for_needs(&Baseline::Nothing.forget(&self.needs, &self.scene.frame, facts))
    }

    /// The general core for such needs; none where it cannot be described.
    fn for_needs(&self, needs: &Needs) -> Option<CoreSpec> {
        let to = self.scene.core_for(needs, Some(self.spec.method())).ok()?;
        self.spec.changed(self.general.as_ref().ok()?, &to).ok()
    }
}

/// What else the core for the scene has less, for the end of a line: options that are others, and
/// formats that are narrower.
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
