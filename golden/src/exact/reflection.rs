//! The reflected eye vector, and vectors D whose length grows with the angle between it and the light.
use glam::DVec3;
use specula_scene::frame::EYE;

/// R = 2(N·V)N - V [Lyon, METHODS.md B1]: one reflection a pixel, whatever the number of lights.
pub fn reflect(normal: DVec3) -> DVec3 {
    2.0 * normal.dot(EYE) * normal - EYE
}

/// H = L + V, not normalised.
pub fn halfway(light: DVec3) -> DVec3 {
    light + EYE
}

/// D = R - L, equal to 2(N·V)N - H [METHODS.md B2, B3]. |D|² = 2 - 2 R·L for a unit normal.
pub fn reflection_minus_light(normal: DVec3, light: DVec3) -> DVec3 {
    2.0 * normal.dot(EYE) * normal - halfway(light)
}

/// D = H × N [METHODS.md B13]. For a unit normal it is as long as (H·N)N - H (B5).
pub fn halfway_cross_normal(normal: DVec3, light: DVec3) -> DVec3 {
    halfway(light).cross(normal)
}
