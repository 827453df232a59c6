//! The cosine whose power is the highlight, in the lecture's forms; Hast's forms are in
//! [`super::hast`].
use glam::DVec3;
use specula_scene::frame::EYE;

/// 2(L·N)(N·V) - L·V for a unit normal [lecture, eq. 4.5].
pub fn textbook(normal: DVec3, light: DVec3) -> f64 {
    2.0 * light.dot(normal) * normal.dot(EYE) - light.dot(EYE)
}

/// 2JK/D - L·V with J = L·N, K = V·N, D = N·N, for a normal of any length [lecture, eq. 4.6;
/// methods A7]; 0 for N = 0.
pub fn fast(normal: DVec3, light: DVec3) -> f64 {
    let d = normal.length_squared();
    if d > 0.0 { 2.0 * normal.dot(light) * normal.dot(EYE) / d - light.dot(EYE) } else { 0.0 }
}
