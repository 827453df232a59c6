//! Premises: what may be known of a scene before any of its inputs is.
use specula_scene::Needs;
use specula_scene::limits::{LARGEST_SHININESS, LONGEST_SPAN};
use specula_scene::needs::LocalKind;

/// A fact about a scene that may be known before any of its inputs is.
pub(super) struct Premise {
    pub need: &'static str,
    pub safe: &'static str,
    /// Widens needs to those of scenes for which the premise is unknown.
    pub relax: fn(&mut Needs),
    /// The knowledge as a table's text.
    pub known: fn(&Needs) -> String,
}

/// The lights of a general core, unless the scene has more of them.
const USUAL_LIGHTS: usize = 4;

/// The lights of a general core for a scene.
fn general_lights(needs: &Needs) -> usize {
    needs.lights.max(USUAL_LIGHTS)
}

/// Names of the premises that a renderer's core is built with.
pub(super) const LIGHTS: &str = "number of lights";
pub(super) const LIGHTS_AT_INFINITY: &str = "lights at infinity";
pub(super) const EYE_AT_INFINITY: &str = "eye at infinity";

/// Every premise on which [`LoadedScene::core_for`] rests.
pub(super) const PREMISES: [Premise; 11] = [
    Premise {
        need: LIGHTS,
        safe: "the scene has no more lights",
        // Lights at places come last, so more lights at infinity would take their names.
        relax: |needs| {
            if needs.local_lights.is_empty() {
                needs.lights = general_lights(needs);
            }
        },
        known: |needs| {
            let all = general_lights(needs);
            format!("{} of {all} pipelines for lights", all - needs.lights)
        },
    },
    Premise {
        need: LIGHTS_AT_INFINITY,
        safe: "the direction to such a light is the same everywhere",
        relax: |needs| {
            let at_infinity = needs.lights - needs.local_lights.len();
            needs.local_lights.splice(0..0, vec![LocalKind::Point; at_infinity]);
            needs.attenuated_lights.iter_mut().for_each(|light| *light += at_infinity);
        },
        known: |needs| {
            format!(
                "directions to the places of {} lights",
                needs.lights - needs.local_lights.len()
            )
        },
    },
    Premise {
        need: EYE_AT_INFINITY,
        safe: "the direction to the eye is the same everywhere",
        relax: |needs| needs.local_eye = true,
        known: |_| "directions to the place of the eye".to_owned(),
    },
    Premise {
        need: "one material",
        safe: "colours and exponents are the same in every span of this frame",
        relax: |needs| needs.materials = needs.materials.max(2),
        known: |_| "delay registers of colours and exponents".to_owned(),
    },
    Premise {
        need: "longest span",
        safe: "no span of this frame is longer",
        relax: |needs| needs.longest_span = LONGEST_SPAN,
        known: |needs| format!("spans of {} pixels, not {LONGEST_SPAN}", needs.longest_span),
    },
    Premise {
        need: "angle between the normals of a span",
        safe: "no span of this frame has a wider one",
        relax: |needs| (needs.widest_angle, needs.shortest_normal) = (180.0, 0.0),
        known: |needs| format!("{:.1} degrees, not 180", needs.widest_angle),
    },
    Premise {
        need: "angle between normals and faces",
        safe: "no triangle of this frame has a wider one",
        relax: |needs| needs.least_cone_cosine = -1.0,
        known: |needs| {
            format!(
                "{:.1} degrees, not 180",
                needs.least_cone_cosine.clamp(-1.0, 1.0).acos().to_degrees()
            )
        },
    },
    Premise {
        need: "distance to places",
        safe: "no span of this frame comes nearer to one",
        relax: |needs| {
            if needs.has_places() {
                (needs.shortest_way, needs.shortest_unit_way) = (0.0, 0.0);
                needs.shortest_halfway = 0.0;
            }
        },
        known: |needs| {
            format!(
                "vectors to places of {:.3} of the longer end's length at least",
                needs.shortest_way
            )
        },
    },
    Premise {
        need: "largest exponent",
        safe: "no material of this frame has a larger one",
        relax: |needs| needs.largest_shininess = LARGEST_SHININESS,
        known: |needs| format!("n = {}, not {LARGEST_SHININESS}", needs.largest_shininess),
    },
    Premise {
        need: "exponents are powers of two",
        safe: "squaring reaches every exponent of this frame",
        relax: |needs| needs.uneven_shininess = Some(UNEVEN),
        known: |_| "exponents between them".to_owned(),
    },
    Premise {
        need: "flat normals",
        safe: "the normal is the same, and of unit length, all over each triangle",
        relax: |needs| needs.flat = false,
        known: |_| "making interpolated normals unit vectors".to_owned(),
    },
];

/// An exponent that repeated squaring does not reach.
const UNEVEN: u32 = 3;
