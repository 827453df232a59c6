//! Directions to lights and eye at a point, for the host's set-up [Hast et al., eq. 35, 38; methods
//! C15, C18].
use glam::DVec3;
use smallvec::SmallVec;

use crate::frame::{EYE, Frame, LocalLight};
use crate::spec::MOST_LIGHTS;

/// A light as seen from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Illumination {
    /// L, a unit vector towards the light.
    pub direction: DVec3,
    /// The share of it that arrives, 0 to 1: 1 except for a spot, which has Warn's factor
    /// max(-L·axis, 0)^p.
    pub share: f64,
}

/// A point of a surface, and the light that reaches it.
pub(crate) struct LitPoint {
    /// N, a unit vector; 0 where the surface has none.
    pub normal: DVec3,
    /// V, a unit vector towards the eye; `None` for an eye at that very point.
    pub view: Option<DVec3>,
    /// Every light, those at infinity first; `None` for a light at that very point (extremes row
    /// 39).
    pub lights: SmallVec<[Option<Illumination>; MOST_LIGHTS]>,
}

impl LitPoint {
    /// A point of a frame.
    pub fn new(frame: &Frame, normal: DVec3, position: DVec3) -> LitPoint {
        LitPoint {
            normal,
            view: frame.view_from(position),
            lights: frame.lights_from(position).collect(),
        }
    }

    /// Lambert's max(N·L, 0) of light number `index`, times the light's share.
    pub fn diffuse(&self, index: usize) -> f64 {
        self.lights[index]
            .map_or(0.0, |light| light.share * self.normal.dot(light.direction).max(0.0))
    }

    /// max(R·L, 0)^n with R = 2(N·V)N - V [lecture, eq. 2.1] of light number `index`, times the
    /// light's share; 0 where there is no normal to reflect about.
    pub fn highlight(&self, index: usize, n: u32) -> f64 {
        let (Some(light), Some(view)) = (self.lights[index], self.view) else { return 0.0 };
        if self.normal == DVec3::ZERO {
            return 0.0;
        }
        let reflection = 2.0 * self.normal.dot(view) * self.normal - view;
        light.share * libm::pow(reflection.dot(light.direction).clamp(0.0, 1.0), f64::from(n))
    }
}

impl Frame {
    /// The unit vector from `position` to the eye; `None` for an eye there.
    pub fn view_from(&self, position: DVec3) -> Option<DVec3> {
        self.eye.map_or(Some(EYE), |eye| (eye - position).try_normalize())
    }

    /// Every light as seen from `position`, those at infinity first; `None` for a light there.
    pub fn lights_from(&self, position: DVec3) -> impl Iterator<Item = Option<Illumination>> {
        let at_infinity = self
            .lights
            .iter()
            .map(|light| Some(Illumination { direction: light.direction, share: 1.0 }));
        at_infinity.chain(self.local_lights.iter().map(move |light| from_a_place(light, position)))
    }
}

fn from_a_place(light: &LocalLight, position: DVec3) -> Option<Illumination> {
    let direction = (light.position - position).try_normalize()?;
    let factor = |axis: DVec3, exponent: u32| {
        libm::pow((-direction.dot(axis)).clamp(0.0, 1.0), f64::from(exponent))
    };
    let share = light.spot.as_ref().map_or(1.0, |spot| factor(spot.axis, spot.exponent));
    Some(Illumination { direction, share })
}
