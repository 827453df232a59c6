//! Changes to unit vectors.
use glam::DVec3;
use specula_scene::Format;

use crate::stress::draw::{Draw, turned};

use super::super::random::of_any_size;

/// The vector, turned a little or more.
pub(super) fn turned_a_bit(vector: DVec3, draw: &mut Draw) -> DVec3 {
    let (angle, azimuth) = (of_any_size(draw, 1e-5, 1.0), draw.unit());
    vector.try_normalize().map_or(DVec3::Z, |axis| turned(axis, angle, azimuth))
}

/// The unit vector with a component near the middle between two values of `format`, where rounding is off by most; or between
/// those that round to 0.
pub(super) fn badly_rounded(vector: DVec3, format: Format, draw: &mut Draw) -> DVec3 {
    let (axis, ulp) = (draw.between(0, 2) as usize, format.ulp());
    let short_of_it = 0.5 - of_any_size(draw, 1e-6, 0.2);
    let steps = draw.one_of(&[0.0, 0.0, (vector[axis] / ulp).round()]);
    let wanted = ((steps + short_of_it * draw.one_of(&[1.0, -1.0])) * ulp).clamp(-1.0, 1.0);
    let mut others = vector;
    others[axis] = 0.0;
    let across = others.try_normalize().unwrap_or_else(|| {
        let mut next = DVec3::ZERO;
        next[(axis + 1) % 3] = 1.0;
        next
    });
    let mut result = across * (1.0 - wanted * wanted).sqrt();
    result[axis] = wanted;
    result
}
