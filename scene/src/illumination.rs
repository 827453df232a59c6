//! Directions to lights and eye at a point, for the host's set-up [Hast et al., eq. 35, 38; methods
//! C15, C18].
use glam::DVec3;

use crate::frame::{EYE, Frame, LocalLight};

/// A light as seen from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Illumination {
    /// L, a unit vector towards the light.
    pub direction: DVec3,
    /// The share of it that its direction leaves, 0 to 1: 1 except for a spot, which has Warn's factor
    /// max(-L·axis, 0)^p.
    pub share: f64,
    /// What distance leaves of it, 0 to 1: 1 for a light that does not become weaker.
    pub attenuation: f64,
}

impl Frame {
    /// The unit vector from `position` to the eye; `None` for an eye there.
    pub fn view_from(&self, position: DVec3) -> Option<DVec3> {
        self.eye.map_or(Some(EYE), |eye| (eye - position).try_normalize())
    }

    /// Every light as seen from `position`, those at infinity first; `None` for a light there.
    pub fn lights_from(&self, position: DVec3) -> impl Iterator<Item = Option<Illumination>> {
        let at_infinity = self.lights.iter().map(|light| {
            Some(Illumination { direction: light.direction, share: 1.0, attenuation: 1.0 })
        });
        at_infinity.chain(self.local_lights.iter().map(move |light| from_a_place(light, position)))
    }
}

fn from_a_place(light: &LocalLight, position: DVec3) -> Option<Illumination> {
    let way = light.position - position;
    let direction = way.try_normalize()?;
    let factor = |axis: DVec3, exponent: u32| {
        libm::pow((-direction.dot(axis)).clamp(0.0, 1.0), f64::from(exponent))
    };
    let share = light.spot.as_ref().map_or(1.0, |spot| factor(spot.axis, spot.exponent));
    let attenuation = light.attenuation.map_or(1.0, |attenuation| attenuation.at(way.length()));
    Some(Illumination { direction, share, attenuation })
}
