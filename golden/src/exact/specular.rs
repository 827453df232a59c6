//! The cosine that the highlight is a power of, in each paper's form.
use glam::DVec3;
use specula_scene::frame::EYE;

use super::normalisation::unit;
use super::reflection::halfway;

/// 2(L·N)(N·V) - L·V of a unit normal [lecture, eq. 4.5].
pub fn textbook(normal: DVec3, light: DVec3) -> f64 {
    2.0 * light.dot(normal) * normal.dot(EYE) - light.dot(EYE)
}

/// 2JK/D - L·V with J = L·N, K = V·N, D = N·N, a normal of any length [lecture, eq. 4.6; METHODS.md A7]. 0 for N = 0.
pub fn fast(normal: DVec3, light: DVec3) -> f64 {
    let d = normal.length_squared();
    if d > 0.0 { 2.0 * normal.dot(light) * normal.dot(EYE) / d - light.dot(EYE) } else { 0.0 }
}

/// r p/q - L·V with r = 2N·V, p and q Duff's [Hast, Barrera and Bengtsson, eq. 33; METHODS.md C10]. 0 for N = 0.
pub fn by_quotient(normal: DVec3, light: DVec3) -> f64 {
    let (p, q, r) = (normal.dot(light), normal.length_squared(), 2.0 * normal.dot(EYE));
    if q > 0.0 { r * (p / q) - light.dot(EYE) } else { 0.0 }
}

/// (rs)(ps) - L·V with s = 1/√q [eq. 34; METHODS.md C11]. 0 for N = 0.
pub fn by_root(normal: DVec3, light: DVec3) -> f64 {
    let (p, q, r) = (normal.dot(light), normal.length_squared(), 2.0 * normal.dot(EYE));
    let s = 1.0 / q.sqrt();
    if q > 0.0 { (r * s) * (p * s) - light.dot(EYE) } else { 0.0 }
}

/// N·H/|H| of a unit normal [Blinn; METHODS.md C8]; 0 for L = -V, which has no H.
pub fn blinn(normal: DVec3, light: DVec3) -> f64 {
    unit(halfway(light)).map_or(0.0, |h| normal.dot(h))
}
