//! Lights [KHR_lights_punctual].
//!
//! Their strengths are physical: a directional light's illuminance in lux, and of a light at a place
//! the intensity in candela, which gives the illuminance I/d² at the distance d. A picture has no unit
//! of brightness, so all are divided by one number: the illuminance that the strongest component of
//! any light has where the objects are nearest to it.
//!
//! Objects are nearest to a light at the distance D from it to the ball around them, but not less
//! than half the ball's radius: a lamp within a room would otherwise outshine every other. There its
//! strength is I/D², and at the distance d it is min(1, D²/d²) of that.
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, FRAC_PI_4, LN_2};

use glam::{DMat4, DVec3};
use serde::Deserialize;

use super::json::{Document, Number};
use super::nodes::Attached;
use super::part::{Part, Reference};
use crate::limits::{LARGEST_SHININESS, MOST_LIGHTS};
use crate::mesh::indexed::Mesh;
use crate::mesh::limits::FARTHEST;
use crate::mesh::warning::{Notices, quoted};
use crate::picture::{Light, LightSource, LightSpace};
use crate::{Attenuation, Colour};

/// The extension's object of the document.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Extensions {
    #[serde(rename = "KHR_lights_punctual")]
    punctual: Punctual,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Punctual {
    lights: Vec<Part>,
}

/// The extension's object of a node.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
pub struct OfNode {
    /// The light's number.
    pub light: Reference,
}

/// A light as the file states it.
#[derive(Debug, Default, Deserialize)]
#[serde(default, expecting = "an object")]
struct Stated {
    #[serde(rename = "type")]
    kind: String,
    color: Option<[Number; 3]>,
    intensity: Option<Number>,
    range: Option<Number>,
    spot: Cone,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase", expecting = "an object")]
struct Cone {
    inner_cone_angle: Option<Number>,
    outer_cone_angle: Option<Number>,
}

/// The lights of a document, each with its node's place in the tree, in the order of nodes; the
/// strongest component of all is 1.
///
/// What is no light is left out with a note, as are those beyond [`MOST_LIGHTS`].
pub fn lights(
    document: &Document,
    attached: &[Attached],
    mesh: &Mesh,
    notices: &mut Notices,
) -> Vec<(Light, usize)> {
    let stated = document.extensions.read::<Extensions>().unwrap_or_else(|wrong| {
        notices.add("lights", None, || format!("its lights are left out: {wrong}"));
        None
    });
    let stated = stated.unwrap_or_default().punctual.lights;
    let ball = Ball::around(mesh);
    let mut lights: Vec<(Light, usize)> = Vec::new();
    for Attached { number, place, node } in attached {
        let Some(part) = stated.get(*number) else {
            notices.add("no such light", None, || {
                format!("light {number} is named, but there are only {}", stated.len())
            });
            continue;
        };
        let light =
            part.read::<Stated>().and_then(|light| light.unwrap_or_default().at(place, &ball));
        match light {
            Ok((light, range)) => {
                note_range(*number, range, notices);
                lights.push((light, *node));
            }
            Err(wrong) => {
                notices.add("light", None, || format!("light {number} is left out: {wrong}"));
            }
        }
    }
    if lights.len() > MOST_LIGHTS {
        notices.add("most lights", None, || {
            format!("it has {} lights; the first {MOST_LIGHTS} are shown", lights.len())
        });
        lights.truncate(MOST_LIGHTS);
    }
    divide(&mut lights, notices);
    lights
}

fn note_range(number: usize, range: Option<Number>, notices: &mut Notices) {
    if let Some(Number(range)) = range {
        notices.add("range of light", None, || {
            format!("light {number} ends at the distance {range:?}; it is shown beyond, as it becomes weaker")
        });
    }
}

/// Divides the colours by the largest component of all.
fn divide(lights: &mut [(Light, usize)], notices: &mut Notices) {
    let strongest = lights.iter().flat_map(|(light, _)| light.colour).fold(0.0, f64::max);
    if strongest == 0.0 || strongest == 1.0 {
        return;
    }
    for (light, _) in lights {
        light.colour = light.colour.map(|x| x / strongest);
    }
    notices.add("strength", None, || {
        format!(
            "its lights have physical strengths; they are divided by {strongest:?} lux, so that the strongest is 1 where objects are nearest to it"
        )
    });
}

/// A ball around all that is drawn.
struct Ball {
    middle: DVec3,
    radius: f64,
}

impl Ball {
    fn around(mesh: &Mesh) -> Ball {
        let corners = mesh.triangles.iter().flatten().map(|&k| mesh.positions[k as usize]);
        let bounds =
            corners.map(|p| [p, p]).reduce(|[low, high], [p, _]| [low.min(p), high.max(p)]);
        let [low, high] = bounds.unwrap_or_default();
        Ball { middle: (low + high) / 2.0, radius: (high - low).length() / 2.0 }
    }

    /// The distance D, where a light at a place counts as nearest.
    fn nearest(&self, position: DVec3) -> f64 {
        ((position - self.middle).length() - self.radius).max(self.radius / 2.0)
    }
}

impl Stated {
    /// The light at a node, with its own strength, and its range if it has one; or what is wrong
    /// with it.
    fn at(&self, place: &DMat4, ball: &Ball) -> Result<(Light, Option<Number>), String> {
        let backwards = place.transform_vector3(DVec3::Z);
        let position = place.transform_point3(DVec3::ZERO);
        let is_placed = backwards.is_finite()
            && backwards != DVec3::ZERO
            && position.to_array().iter().all(|x| x.abs() <= FARTHEST);
        if !is_placed {
            return Err("its node does not say where it is".into());
        }
        let distance = ball.nearest(position);
        let share = (distance * distance).recip();
        let attenuation = Some(Attenuation { constant: 0.0, linear: 0.0, quadratic: share });
        let (source, share) = match &*self.kind {
            "directional" => (LightSource::Directional { direction: backwards }, 1.0),
            "point" => (LightSource::Point { position, attenuation }, share),
            "spot" => {
                let (axis, exponent) = (-backwards, self.spot.exponent());
                (LightSource::Spot { position, axis, exponent, attenuation }, share)
            }
            other => return Err(format!("there is no type {}", quoted(other.as_bytes()))),
        };
        let light = Light { source, space: LightSpace::World, colour: self.colour(share)? };
        Ok((light, self.range.filter(|_| share != 1.0)))
    }

    /// The light's colour times its strength and this share of it.
    fn colour(&self, share: f64) -> Result<Colour, String> {
        let Number(intensity) = self.intensity.unwrap_or(Number(1.0));
        let stated = self.color.unwrap_or([Number(1.0); 3]);
        let colour = stated.map(|Number(x)| x * intensity * share);
        if colour.iter().all(|x| (0.0..=f64::MAX).contains(x)) {
            Ok(colour)
        } else {
            Err("its colour and intensity are not 0 or more".into())
        }
    }
}

impl Cone {
    /// The exponent p of the spot [Warn] that is half as strong at the same angle from the axis.
    ///
    /// The file's light is 1 within the inner angle i and 0 outside the outer angle o, and between
    /// them, at the angle θ, x² with x = (cos θ - cos o)/(cos i - cos o) [KHR_lights_punctual,
    /// "Inner and Outer Cone Angles"]. It is half at
    ///
    /// x² = 1/2, or cos θ = cos o + √½ (cos i - cos o),
    ///
    /// and Warn's there where cosᵖ θ = 1/2, or p = -ln 2/ln cos θ.
    fn exponent(&self) -> u32 {
        let angle = |stated: Option<Number>, otherwise| stated.map_or(otherwise, |Number(x)| x);
        let outer = angle(self.outer_cone_angle, FRAC_PI_4).clamp(0.0, FRAC_PI_2);
        let inner = angle(self.inner_cone_angle, 0.0).clamp(0.0, outer);
        let (inner, outer) = (libm::cos(inner), libm::cos(outer));
        let half = outer + FRAC_1_SQRT_2 * (inner - outer);
        let exponent = -LN_2 / libm::log(half);
        // The spot of no width has the exponent infinity, with either sign.
        let exponent = if half < 1.0 { exponent } else { f64::INFINITY };
        // It is within the range of u32.
        (exponent + 0.5).floor().clamp(1.0, f64::from(LARGEST_SHININESS)) as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exponent(inner: f64, outer: f64) -> u32 {
        let [inner_cone_angle, outer_cone_angle] = [Some(Number(inner)), Some(Number(outer))];
        Cone { inner_cone_angle, outer_cone_angle }.exponent()
    }

    #[test]
    fn spots_are_as_wide_as_cones() {
        // cos θ = .7071 + .7071 · .2929 = .9142, and ln 2/.0897 = 7.7.
        assert_eq!(Cone::default().exponent(), 8);
        // Where both angles are 60 degrees, cos θ = 1/2.
        assert_eq!(exponent(FRAC_PI_2 * 2.0 / 3.0, FRAC_PI_2 * 2.0 / 3.0), 1);
        assert!(exponent(0.0, 0.1) > exponent(0.0, 0.2));
        assert_eq!(
            (exponent(0.0, 0.0), exponent(9.0, -9.0)),
            (LARGEST_SHININESS, LARGEST_SHININESS)
        );
        assert_eq!(exponent(FRAC_PI_2, FRAC_PI_2), 1);
    }
}
