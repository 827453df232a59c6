//! Spherical linear interpolation of normals [lecture, eq. 4.7 to 4.12; methods A8 to A11].
use glam::DVec3;

use super::normalisation::unit;

/// For 1 - N0·N1 below this (10 degrees) the normalised lerp is used instead: its error is at most
/// 0.0049 degrees, and that of sin φ is larger where N0·N1 was rounded (extremes rows 13 and 15).
pub const SMALLEST_VERSINE: f64 = 0.015_192_246_987_791_98;

/// For 1 + N0·N1 below this, the plane of the two normals is unknown (extremes row 14).
const SMALLEST_ABOVE_OPPOSITE: f64 = 1e-12;

/// The weights [sin((1-t)φ), sin(tφ)]/sin φ, for φ between 0 and π [eq. 4.7].
pub fn weights(angle: f64, t: f64) -> [f64; 2] {
    [((1.0 - t) * angle).sin() / angle.sin(), (t * angle).sin() / angle.sin()]
}

/// The angle between two unit normals if slerp can be used: they are neither closer than 10 degrees
/// nor opposite.
pub fn angle(ends: [DVec3; 2]) -> Option<f64> {
    let cosine = ends[0].dot(ends[1]);
    let serves = 1.0 - cosine >= SMALLEST_VERSINE && 1.0 + cosine >= SMALLEST_ABOVE_OPPOSITE;
    // atan2 keeps the digits that acos of a rounded dot product loses.
    serves.then(|| ends[0].cross(ends[1]).length().atan2(cosine))
}

/// The unit normal at `t`, 0 to 1, between two unit normals; the normalised lerp where slerp cannot
/// be used.
///
/// The result is `None` where the ends are opposite and the lerp vanishes (extremes row 1).
pub fn slerp(ends: [DVec3; 2], t: f64) -> Option<DVec3> {
    match angle(ends) {
        Some(angle) => {
            let [a, b] = weights(angle, t);
            Some(a * ends[0] + b * ends[1])
        }
        None => unit(ends[0].lerp(ends[1], t)),
    }
}

/// T = (N1 - N0 cos φ)/sin φ, the unit vector perpendicular to N0, towards N1: N = cos(tφ) N0 +
/// sin(tφ) T has no 1/sin φ [methods A11].
///
/// The result is `None` where the normals are parallel.
pub fn tangent(ends: [DVec3; 2]) -> Option<DVec3> {
    unit(ends[1] - ends[0].dot(ends[1]) * ends[0])
}
