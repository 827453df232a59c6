//! Changes to unit vectors.
use glam::DVec3;
use specula_spec::Format;

use crate::stress::draw::{Draw, turned};

use super::super::random::log_uniform;

/// The vector, turned a little or more.
pub(super) fn turned_a_bit(vector: DVec3, draw: &mut Draw) -> DVec3 {
    let (angle, azimuth) = (log_uniform(draw, 1e-5, 1.0), draw.unit());
    vector.try_normalize().map_or(DVec3::Z, |axis| turned(axis, angle, azimuth))
}

/// The unit vector with a component near the middle between two values of `format`, where the
/// rounding error is largest; or near the middle between those around 0.
pub(super) fn badly_rounded(vector: DVec3, format: Format, draw: &mut Draw) -> DVec3 {
    let (axis, ulp) = (draw.between(0, 2) as usize, format.ulp());
    let short_of_it = 0.5 - log_uniform(draw, 1e-6, 0.2);
    let steps = draw.one_of(&[0.0, 0.0, (vector[axis] / ulp).round()]);
    with_component(vector, axis, (steps + short_of_it * draw.one_of(&[1.0, -1.0])) * ulp)
}

/// The unit vector with one component equal, or nearly equal, to another: they may become twins.
pub(super) fn with_alike_components(vector: DVec3, draw: &mut Draw) -> DVec3 {
    let (axis, other) = (draw.between(0, 2) as usize, draw.between(0, 2) as usize);
    let sign = draw.one_of(&[1.0, -1.0]);
    let apart = draw.one_of(&[0.0, 1.0]) * log_uniform(draw, 1e-6, 1e-2);
    with_component(vector, axis, sign * vector[other] + apart)
}

/// The unit vector with this component; the ratio of the others is kept.
fn with_component(vector: DVec3, axis: usize, component: f64) -> DVec3 {
    let component = component.clamp(-1.0, 1.0);
    let mut others = vector;
    others[axis] = 0.0;
    let across = others.try_normalize().unwrap_or(DVec3::AXES[(axis + 1) % 3]);
    let mut result = across * (1.0 - component * component).sqrt();
    result[axis] = component;
    result
}
