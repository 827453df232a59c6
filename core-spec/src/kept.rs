//! What a core must still take when its scene changes: what stays an input.
use glam::DVec3;
use serde::Deserialize;
use specula_scene::Needs;
use specula_scene::frame::{DirectionalLight, EYE, Frame, Span};
use specula_scene::limits::{LARGEST_SHININESS, LONGEST_SPAN};
use specula_scene::needs::Interval;

use crate::core_input::{CoreInput, InputRole};
use crate::error::{SpecError, within};

/// The widest angle between normals of a triangle for which their shortest mean is known, in degrees.
const WIDEST_ANGLE: f64 = 119.0;

/// Directions of a light that are looked at: rings around the eye's direction, and turns of each.
const RINGS: u32 = 16;
const TURNS: u32 = 64;

/// What may change without a new core.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Kept {
    things: Vec<KeptThing>,
    within: KeptWithin,
}

/// A part of a scene that may change.
#[derive(Clone, Debug, PartialEq)]
enum KeptThing {
    /// Directions and colours of lights.
    Lights,
    /// Colours and exponents.
    Materials,
    /// Where the scene is seen from.
    Camera,
    /// Shapes and their places.
    Objects,
    /// One input of the core, by its name.
    Input(String),
}

/// Within what it may change: the table `[core.kept]`.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct KeptWithin {
    /// Exponents n of materials, smallest and largest.
    pub shininess: Option<[u32; 2]>,
    /// Largest angle in degrees from a directional light to the eye.
    pub light_angle: Option<f64>,
    /// Longest span in pixels.
    pub longest_span: Option<u32>,
    /// Largest angle in degrees between the normals of a triangle's vertices.
    pub widest_angle: Option<f64>,
}

impl Kept {
    /// What a `[core]` table's `keep` names, within what its `kept` says.
    ///
    /// # Errors
    /// [`SpecError::OutOfRange`] for a limit that cannot be.
    pub(crate) fn new(keep: &[String], within: KeptWithin) -> Result<Kept, SpecError> {
        within.check()?;
        Ok(Kept { things: keep.iter().map(|name| KeptThing::named(name)).collect(), within })
    }

    /// Whether an input must take all that its port can, since something that it depends on may
    /// change.
    pub(crate) fn frees(&self, input: &CoreInput) -> bool {
        self.things.iter().any(|thing| self.is_moved(input, thing))
    }

    /// Whether an input changes with a thing, other than within ranges that are known
    /// ([`Kept::examples`]).
    fn is_moved(&self, input: &CoreInput, thing: &KeptThing) -> bool {
        let (role, name) = (input.meaning.role, &input.port.name);
        match thing {
            KeptThing::Lights => match role {
                InputRole::Light => self.within.light_angle.is_none(),
                InputRole::Diffuse | InputRole::Specular => true,
                InputRole::Surface => input.is_of_a_light(),
                InputRole::Exponent | InputRole::Ambient => false,
            },
            KeptThing::Materials => !matches!(role, InputRole::Light | InputRole::Surface),
            // Lights that stay with the objects turn with the camera.
            KeptThing::Camera => matches!(role, InputRole::Surface | InputRole::Light),
            KeptThing::Objects => role == InputRole::Surface,
            KeptThing::Input(own) => own == name,
        }
    }

    /// Frames like this one under other lights: those between which all are that the core must take,
    /// where a largest angle to the eye is said. Directions are on a grid around the eye's whose rim
    /// is at that angle; every light has each in its turn. A core may refuse a light between two of
    /// them by a unit in the last place.
    pub(crate) fn examples(&self, frame: &Frame) -> Vec<Frame> {
        let angle = self.within.light_angle.filter(|_| self.keeps(&KeptThing::Lights));
        let (Some(angle), Some(span)) = (angle, frame.spans.first()) else { return vec![] };
        let directions = cap(angle);
        let triangle = frame.triangles[span.triangle].clone();
        let example = |first: usize| {
            let lights = frame.lights.iter().enumerate().map(|(light, own)| {
                // 7 has no factor in common with the number of directions around the eye.
                let direction = directions[(first + 7 * light) % directions.len()];
                DirectionalLight { direction, ..own.clone() }
            });
            Frame {
                lights: lights.collect(),
                local_lights: frame.local_lights.clone(),
                materials: frame.materials.clone(),
                triangles: vec![triangle.clone()],
                spans: vec![Span { triangle: 0, ..span.clone() }],
                ..*frame
            }
        };
        (0..directions.len()).map(example).collect()
    }

    /// The first named input that is none of a core's.
    pub(crate) fn stranger(&self, inputs: &[CoreInput]) -> Option<&str> {
        self.things.iter().find_map(|thing| match thing {
            KeptThing::Input(name) if inputs.iter().all(|input| input.port.name != *name) => {
                Some(name.as_str())
            }
            _ => None,
        })
    }

    /// The needs of all scenes that the core must take.
    pub(crate) fn relaxed(&self, needs: &Needs) -> Needs {
        let mut needs = needs.clone();
        if self.keeps(&KeptThing::Materials) {
            self.relax_materials(&mut needs);
        }
        if self.keeps(&KeptThing::Lights) || self.keeps(&KeptThing::Materials) {
            relax_colours(&mut needs);
        }
        if self.keeps(&KeptThing::Camera) || self.keeps(&KeptThing::Objects) {
            self.relax_surface(&mut needs);
        }
        needs
    }

    fn keeps(&self, thing: &KeptThing) -> bool {
        self.things.contains(thing)
    }

    /// Exponents may be any within the limits, or up to the scene's largest; so they need not be
    /// powers of two.
    fn relax_materials(&self, needs: &mut Needs) {
        let [smallest, largest] = self.within.shininess.unwrap_or([1, needs.largest_shininess]);
        needs.smallest_shininess = needs.smallest_shininess.min(smallest);
        needs.largest_shininess = needs.largest_shininess.max(largest);
        let range = needs.smallest_shininess..=needs.largest_shininess;
        needs.uneven_shininess =
            needs.uneven_shininess.or(range.into_iter().find(|n| !n.is_power_of_two()));
    }

    /// Spans may be as long as is said, or as the picture is wide, and triangles as bent as is said,
    /// or as those of the scene.
    fn relax_surface(&self, needs: &mut Needs) {
        let longest = self.within.longest_span.unwrap_or(needs.picture_width);
        needs.longest_span = needs.longest_span.max(longest);
        if let Some(angle) = self.within.widest_angle {
            needs.widest_angle = needs.widest_angle.max(angle);
            needs.shortest_normal = needs.shortest_normal.min(shortest_normal(angle));
        }
        needs.flat = false;
        needs.consistent_normals_differ = true;
        let all = Interval { low: -1.0, high: 1.0 };
        needs.ranges.normal = [all; 3];
        needs.ranges.normal_dot_eye = all;
    }

    /// What may change, for people to read; empty if nothing may.
    pub(crate) fn in_words(&self) -> Vec<String> {
        self.things.iter().map(|thing| thing.in_words(&self.within)).collect()
    }
}

/// Colours of lights and materials may be any up to full scale, or to the scene's brightest.
fn relax_colours(needs: &mut Needs) {
    let brightest = needs.brightest_coefficient.max(1.0);
    needs.brightest_coefficient = brightest;
    needs.contributions.ambient = [brightest; 3];
    needs.contributions.diffuse = [brightest; 3];
    needs.contributions.specular = [brightest; 3];
    needs.contributions.grey = false;
}

/// Unit vectors up to an angle in degrees from the eye's direction.
fn cap(angle: f64) -> Vec<DVec3> {
    let at = |(ring, turn): (u32, u32)| {
        let from_eye = (angle * f64::from(ring) / f64::from(RINGS)).to_radians();
        let around = (360.0 * f64::from(turn) / f64::from(TURNS)).to_radians();
        let across = DVec3::new(libm::cos(around), libm::sin(around), 0.0);
        across * libm::sin(from_eye) + EYE * libm::cos(from_eye)
    };
    (0..=RINGS).flat_map(|ring| (0..TURNS).map(move |turn| (ring, turn))).map(at).collect()
}

/// The shortest mean of three unit vectors that are no more than `degrees` apart.
///
/// It is shortest where all three are that far apart, A: there it is the cosine of the radius R of
/// the circle through them, and sin R = 2/√3 sin(A/2).
fn shortest_normal(degrees: f64) -> f64 {
    let sine = 2.0 / 3f64.sqrt() * libm::sin(degrees.to_radians() / 2.0);
    (1.0 - sine * sine).max(0.0).sqrt()
}

impl KeptThing {
    fn named(name: &str) -> KeptThing {
        match name {
            "lights" => KeptThing::Lights,
            "materials" => KeptThing::Materials,
            "camera" => KeptThing::Camera,
            "objects" => KeptThing::Objects,
            input => KeptThing::Input(input.to_owned()),
        }
    }

    fn in_words(&self, within: &KeptWithin) -> String {
        let limit = |limit: Option<String>| limit.map(|words| format!(", {words}"));
        let (what, limit) =
            match self {
                KeptThing::Lights => (
                    "directions and colours of its lights".to_owned(),
                    limit(within.light_angle.map(|angle| {
                        format!("directional ones up to {angle} degrees from the eye")
                    })),
                ),
                KeptThing::Materials => (
                    "colours and exponents of its materials".to_owned(),
                    limit(within.shininess.map(|[low, high]| format!("n from {low} to {high}"))),
                ),
                KeptThing::Camera => ("the place that it is seen from".to_owned(), None),
                KeptThing::Objects => {
                    (
                        "its objects".to_owned(),
                        limit(within.widest_angle.map(|angle| {
                            format!("normals of a triangle up to {angle} degrees apart")
                        })),
                    )
                }
                KeptThing::Input(name) => (format!("its input `{name}`"), None),
            };
        what + &limit.unwrap_or_default()
    }
}

impl KeptWithin {
    fn check(&self) -> Result<(), SpecError> {
        if let Some([low, high]) = self.shininess {
            within("kept.shininess", low.into(), 1.0, high.into())?;
            within("kept.shininess", high.into(), 1.0, LARGEST_SHININESS.into())?;
        }
        if let Some(angle) = self.light_angle {
            within("kept.light_angle", angle, 0.0, 180.0)?;
        }
        if let Some(longest) = self.longest_span {
            within("kept.longest_span", longest.into(), 1.0, LONGEST_SPAN.into())?;
        }
        self.widest_angle
            .map_or(Ok(()), |angle| within("kept.widest_angle", angle, 0.0, WIDEST_ANGLE))
    }
}
