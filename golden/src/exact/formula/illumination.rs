//! Directions to lights and eye at one point.
use glam::DVec3;
use specula_scene::frame::EYE;
use specula_scene::{Attenuation, Frame, LocalLight, Span};

use super::normalisation::unit;
use super::point_light;
use super::quadratic::Quadratic;

/// A light as seen from one point.
pub struct Illumination {
    /// L, a unit vector.
    pub direction: DVec3,
    /// The share of it that arrives, 0 to 1: Warn's spot factor times what distance leaves.
    pub share: f64,
}

/// The direction from a pixel of a span to the eye, a unit vector; `None` for an eye at that very
/// point [methods C18].
pub fn view(frame: &Frame, span: &Span, weights: [f64; 3]) -> Option<DVec3> {
    view_from(frame, frame.position_at(span, weights))
}

/// The direction to the eye as [`view`] gives it, from a `position` in view space.
pub fn view_from(frame: &Frame, position: DVec3) -> Option<DVec3> {
    match frame.eye {
        Some(eye) => unit(eye - position),
        None => Some(EYE),
    }
}

/// Every light as seen from a pixel of a span, those at infinity first; `None` for a light at that
/// very point (extremes row 39).
pub fn lights(
    frame: &Frame,
    span: &Span,
    weights: [f64; 3],
) -> impl Iterator<Item = Option<Illumination>> {
    lights_from(frame, frame.position_at(span, weights))
}

/// The lights as [`lights`] gives them, from a `position` in view space.
pub fn lights_from(frame: &Frame, position: DVec3) -> impl Iterator<Item = Option<Illumination>> {
    (0..frame.lights.len() + frame.local_lights.len())
        .map(move |index| light(frame, index, position))
}

/// Light number `index`, counted as by [`lights`], as seen from `position`.
pub fn light(frame: &Frame, index: usize, position: DVec3) -> Option<Illumination> {
    match index.checked_sub(frame.lights.len()) {
        Some(local) => from_a_place(&frame.local_lights[local], position),
        None => Some(Illumination { direction: frame.lights[index].direction, share: 1.0 }),
    }
}

/// L = (F - P)/|F - P| and, for a spot, max(-L·axis, 0)^p [Hast et al., eq. 35 and after;
/// methods C15].
fn from_a_place(light: &LocalLight, position: DVec3) -> Option<Illumination> {
    let direction = point_light::direction(light.position, position)?;
    let share = light
        .spot
        .as_ref()
        .map_or(1.0, |spot| point_light::spot(-spot.axis, direction, spot.exponent));
    Some(Illumination { direction, share: share * attenuation(light, position) })
}

/// What distance leaves of a light at `position`; 1 where it does not become weaker.
pub fn attenuation(light: &LocalLight, position: DVec3) -> f64 {
    light.attenuation.map_or(1.0, |Attenuation { constant, linear, quadratic }| {
        point_light::attenuation(
            [constant, linear, quadratic],
            (light.position - position).length(),
        )
    })
}

/// What distance leaves of a light along a span, t = 0 to 1: a quadratic through what it leaves at both
/// ends and half-way, which may go beyond 0 to 1.
pub fn attenuation_along(frame: &Frame, span: &Span, light: &LocalLight) -> Quadratic {
    let at = |weights| attenuation(light, frame.position_at(span, weights));
    Quadratic::through([span.start, span.middle(), span.end].map(at))
}
