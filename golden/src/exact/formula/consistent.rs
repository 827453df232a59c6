//! Consistent normal interpolation: reflections that never point into the face [Reshetov, Soupikov
//! and Mark; methods D].
//!
//! N is the interpolated unit normal, I the incoming unit vector (towards the eye, the light or the
//! half-way vector), α the interpolated angle between vertex and face normals, b = N·I.
use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;

use super::normalisation::unit;

/// q = (1 - sin α)/(1 + sin α), for α from 0 to π/2.
pub fn q(alpha: f64) -> f64 {
    (1.0 - alpha.sin()) / (1.0 + alpha.sin())
}

/// q without a sine, (π - 2α)²/(π(π + (2π - 4)α)). It never exceeds [`q`], and is at most 0.012689
/// below it.
pub fn rational_q(alpha: f64) -> f64 {
    (PI - 2.0 * alpha).powi(2) / (PI * (PI + (2.0 * PI - 4.0) * alpha))
}

/// g = cos γ = 1 + q(b - 1).
pub fn cos_gamma(q: f64, b: f64) -> f64 {
    1.0 + q * (b - 1.0)
}

/// ρ = sin γ/sin β = √(q(1 + g)/(1 + b)), 0 to 1.
///
/// The clamp to 1 matters only for an I from behind (extremes row 46); b = -1 gives 0 (row 42).
pub fn rho(q: f64, b: f64) -> f64 {
    let below = 1.0 + b;
    if below <= 0.0 { 0.0 } else { (q * (1.0 + cos_gamma(q, b)) / below).max(0.0).sqrt().min(1.0) }
}

/// r = (g + ρb)N - ρI, which has length 1 for an I in front of the face.
pub fn reflection(normal: DVec3, incoming: DVec3, q: f64) -> DVec3 {
    let b = normal.dot(incoming);
    let rho = rho(q, b);
    (cos_gamma(q, b) + rho * b) * normal - rho * incoming
}

/// N_c = (I + r)/|I + r|; `None` for r = -I (extremes row 41).
pub fn normal(incoming: DVec3, reflection: DVec3) -> Option<DVec3> {
    unit(incoming + reflection)
}

/// N_c·I = |I + r|/2, 0 to 1, without a normalisation; 0 for r = -I.
pub fn cosine(incoming: DVec3, reflection: DVec3) -> f64 {
    ((incoming + reflection).length() / 2.0).min(1.0)
}

/// The enlargement of a vertex's angle, acos(m)(1 + c(1 - m)^e), with which its interpolation
/// reaches the face's angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaling {
    /// The constant c.
    pub constant: f64,
    /// The exponent e.
    pub exponent: i32,
}

impl Scaling {
    /// The constants for [`rational_q`], as printed.
    pub const RATIONAL: Scaling = Scaling { constant: 0.03632, exponent: 2 };
    /// The constants for [`q`], as printed: the angle is too small by up to 0.42 degrees (extremes
    /// row 47).
    pub const TRIGONOMETRIC: Scaling = Scaling { constant: 0.06096, exponent: 2 };
    /// The constants for [`q`] with the exponent that suffices everywhere (numerics N1).
    pub const TRIGONOMETRIC_LINEAR: Scaling = Scaling { constant: 0.06097, exponent: 1 };
}

/// The angle α of a vertex from m, the least cosine between its normal and the normals of the faces
/// around it. It is in radians, up to 1.63 or 1.67 for m = 0.
///
/// It is not clamped to π/2, since that would reduce the angles interpolated from it (extremes row
/// 45).
pub fn vertex_angle(least_cosine: f64, scaling: Scaling) -> f64 {
    let m = least_cosine.clamp(-1.0, 1.0);
    m.acos() * (1.0 + scaling.constant * (1.0 - m).powi(scaling.exponent))
}

/// m of a vertex where the surface is convex, so that its angle is moved from acos(m) towards π/2 by
/// the share `convexity`, 0 to 1 (figure 8, for which the paper has no formula: this one is ours).
///
/// No angle becomes smaller, so that r stays outside of the faces; where the surface is flat or
/// concave, with a convexity of 0, none changes.
pub fn modulated_cosine(least_cosine: f64, convexity: f64) -> f64 {
    let angle = least_cosine.clamp(0.0, 1.0).acos();
    (angle + convexity.clamp(0.0, 1.0) * (FRAC_PI_2 - angle)).cos().max(0.0)
}

/// The angle α of a pixel: interpolated, and only then clamped to 0 to π/2.
pub fn pixel_angle(vertex_angles: [f64; 3], weights: [f64; 3]) -> f64 {
    let interpolated: f64 = vertex_angles.iter().zip(weights).map(|(a, w)| a * w).sum();
    interpolated.clamp(0.0, FRAC_PI_2)
}
