//! Lights and eyes at finite places [Hast, Barrera and Bengtsson, eq. 35 to 38; methods C15 to
//! C18].
use glam::DVec3;
use specula_scene::frame::EYE;

use super::normalisation::unit;
use super::wrap::wrap;

/// L = (F - P)/|F - P| [eq. 35]; `None` for F = P.
pub fn direction(light: DVec3, point: DVec3) -> Option<DVec3> {
    unit(light - point)
}

/// Warn's spot factor max(S·L', 0)^p, with S and L' unit vectors towards the lamp.
pub fn spot(axis: DVec3, light: DVec3, concentration: u32) -> f64 {
    axis.dot(light).max(0.0).powi(concentration.cast_signed())
}

/// min(1, 1/(c + l d + q d²)), what distance leaves of a light, with c, l and q in this order ["Sometimes
/// a distance term is used", §1].
pub fn attenuation([constant, linear, quadratic]: [f64; 3], distance: f64) -> f64 {
    (1.0 / (constant + linear * distance + quadratic * distance * distance)).min(1.0)
}

/// F - P at a span's ends, both divided by their mean length: vectors in between then have a length
/// of about 1, which the wraps below need.
///
/// Unscaled, a light 10 away at 60 degrees comes out at 110.6 (extremes row 40). Two vectors of
/// length 0 stay 0.
pub fn scaled(ends: [DVec3; 2]) -> [DVec3; 2] {
    let mean = f64::midpoint(ends[0].length(), ends[1].length());
    if mean > 0.0 { ends.map(|end| end / mean) } else { ends }
}

/// L' = 2H(H·S)/(H·H) - S with H = S + (F - P) [eq. 36], of length 1. It is S itself where the
/// light is at the point (extremes row 39) or exactly opposite to the axis, where H vanishes.
pub fn wrapped(axis: DVec3, to_light: DVec3) -> DVec3 {
    wrap(axis, to_light).unwrap_or(axis)
}

/// S·L' = 2(H·S)²/(H·H) - 1, computed without the vector [eq. 37].
pub fn wrapped_cosine(axis: DVec3, to_light: DVec3) -> f64 {
    let h = axis + to_light;
    let square = h.length_squared();
    if square > 0.0 { (2.0 * h.dot(axis).powi(2) / square - 1.0).clamp(-1.0, 1.0) } else { -1.0 }
}

/// V' = 2H(H·v)/(H·H) - v with H = v + (F - P) for an eye at F [eq. 38]. Here v looks back along
/// the view's axis (the paper's looks into the scene).
pub fn wrapped_view(to_eye: DVec3) -> DVec3 {
    wrapped(EYE, to_eye)
}
