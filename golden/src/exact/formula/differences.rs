//! Lyon's vectors D, whose length measures the distance from the highlight [Lyon, TR 43; methods B2
//! to B7].
//!
//! R - L and H × N are in [`super::reflection`].
use glam::DVec3;
use specula_scene::frame::EYE;

use super::reflection::halfway;

/// D1 = 2(V·N)N - H, equal to R - L [methods B3].
pub fn d1(normal: DVec3, light: DVec3) -> DVec3 {
    2.0 * EYE.dot(normal) * normal - halfway(light)
}

/// D2 = 2(L·N)N - H; for a unit normal it is as long as D1 [methods B4].
pub fn d2(normal: DVec3, light: DVec3) -> DVec3 {
    2.0 * light.dot(normal) * normal - halfway(light)
}

/// D3 = (H·N)N - H, never longer than D1 [methods B5].
pub fn d3(normal: DVec3, light: DVec3) -> DVec3 {
    to_projection(normal, halfway(light))
}

/// H* - N for a half-way vector of any length [methods B6].
pub fn to_normal(normal: DVec3, halfway: DVec3) -> DVec3 {
    halfway - normal
}

/// (H*·N)N - H* for a half-way vector of any length [methods B6].
pub fn to_projection(normal: DVec3, halfway: DVec3) -> DVec3 {
    halfway.dot(normal) * normal - halfway
}
