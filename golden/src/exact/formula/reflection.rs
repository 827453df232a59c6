//! The reflected eye vector, and vectors D whose length grows with the angle between it and the
//! light.
use glam::DVec3;
use specula_scene::frame::EYE;

/// R = 2(N·V)N - V [Lyon, methods B1]: one reflection for a pixel, whatever the number of lights.
pub fn reflect(normal: DVec3) -> DVec3 {
    2.0 * normal.dot(EYE) * normal - EYE
}

/// H = L + V, not normalised.
pub fn halfway(light: DVec3) -> DVec3 {
    light + EYE
}

/// 2(N·u)N - u - w: u reflected about N, less w. With V and L it is D = R - L, and D2 the other way
/// round [methods B2, B4].
pub fn reflected_minus(normal: DVec3, u: DVec3, w: DVec3) -> DVec3 {
    2.0 * normal.dot(u) * normal - (u + w)
}

/// D = R - L, equal to 2(N·V)N - H [methods B2, B3]. |D|² = 2 - 2 R·L for a unit normal.
pub fn reflection_minus_light(normal: DVec3, light: DVec3) -> DVec3 {
    reflected_minus(normal, EYE, light)
}

/// The vector from a half-way vector to its projection on the normal, (h·N)N - h [methods B5, B6].
pub fn projection(normal: DVec3, halfway: DVec3) -> DVec3 {
    halfway.dot(normal) * normal - halfway
}

/// D = H × N [methods B13]. For a unit normal it is as long as (H·N)N - H (B5).
pub fn halfway_cross_normal(normal: DVec3, light: DVec3) -> DVec3 {
    halfway(light).cross(normal)
}
