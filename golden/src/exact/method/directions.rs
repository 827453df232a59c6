//! Directions to lights and eye along a span of `phong`: true ones, or wrapped ones [Hast, Barrera
//! and Bengtsson, eq. 35 to 38; methods C15 to C18].
use glam::DVec3;
use specula_scene::{Frame, LocalLight, Span, Wrap};
use specula_spec::phong::Places;

use crate::exact::formula::illumination::{self, Illumination};
use crate::exact::formula::point_light;

/// Barycentric weights at a pixel of a span.
pub(super) type Weights = fn(&Frame, &Span, u32) -> [f64; 3];

/// Directions to lights and eye along one span.
pub(super) struct Directions<'a> {
    frame: &'a Frame,
    span: &'a Span,
    /// Where pixels are.
    weights: Weights,
    /// The wraps; `None` if directions are true.
    wraps: Option<Wraps>,
}

struct Wraps {
    eye: Option<Wrap>,
    /// The wrap of each light at a place.
    lights: Vec<Wrap>,
}

impl<'a> Directions<'a> {
    /// The directions of a span whose pixels are at these `weights`.
    pub fn new(
        frame: &'a Frame,
        span: &'a Span,
        places: Places,
        weights: Weights,
    ) -> Directions<'a> {
        let wraps = || Wraps {
            eye: frame.eye.map(|eye| Wrap::to_eye(frame, span, eye)),
            lights: frame
                .local_lights
                .iter()
                .map(|light| Wrap::to_light(frame, span, light))
                .collect(),
        };
        Directions { frame, span, weights, wraps: (places == Places::Wrapped).then(wraps) }
    }

    /// Barycentric weights at pixel `i`.
    pub fn at(&self, i: u32) -> [f64; 3] {
        (self.weights)(self.frame, self.span, i)
    }

    /// The direction from pixel `i` to the eye; `None` for an eye at that very point.
    pub fn view(&self, i: u32) -> Option<DVec3> {
        match self.wraps.as_ref().and_then(|wraps| wraps.eye.as_ref()) {
            Some(wrap) => has_direction(wrap)
                .then(|| point_light::wrapped(wrap.axis, wrap.chord(self.span.parameter(i)))),
            None => illumination::view(self.frame, self.span, self.at(i)),
        }
    }

    /// Every light as seen from pixel `i`, those at infinity first; `None` for a light at that very
    /// point or, wrapped around a spot's axis, 90 degrees or more from the axis.
    pub fn lights(&self, i: u32) -> impl Iterator<Item = Option<Illumination>> {
        let position = self.frame.position_at(self.span, self.at(i));
        let t = self.span.parameter(i);
        let at_infinity = self.frame.lights.len();
        (0..at_infinity + self.frame.local_lights.len()).map(move |index| {
            match (&self.wraps, index.checked_sub(at_infinity)) {
                (Some(wraps), Some(local)) => {
                    wrapped(&self.frame.local_lights[local], &wraps.lights[local], t)
                }
                _ => illumination::light(self.frame, index, position),
            }
        })
    }
}

/// L' and the spot's max(S·L', 0)^p [eq. 36, 37].
fn wrapped(light: &LocalLight, wrap: &Wrap, t: f64) -> Option<Illumination> {
    let to_light = wrap.chord(t);
    let share = match &light.spot {
        Some(spot) if to_light.dot(wrap.axis) > 0.0 => {
            point_light::wrapped_cosine(wrap.axis, to_light)
                .max(0.0)
                .powi(spot.exponent.cast_signed())
        }
        Some(_) => return None,
        None => 1.0,
    };
    has_direction(wrap)
        .then(|| Illumination { direction: point_light::wrapped(wrap.axis, to_light), share })
}

fn has_direction(wrap: &Wrap) -> bool {
    wrap.axis != DVec3::ZERO
}
