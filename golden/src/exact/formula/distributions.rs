//! The twelve specular formulations that Lyon compares in figure 9 [Lyon, TR 43, appendix,
//! `specfuns.m`; methods B].
use glam::DVec3;

use super::differences::{to_normal, to_projection};
use super::normalisation::{g2, unit};
use super::reflection::{halfway, reflect, reflection_minus_light};
use super::shape::{f_k, power};

/// A row of the appendix. All but the first four use the half-way vector and 4n.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// 1: max(R·L, 0)^n.
    Phong,
    /// 2: f_0 of R - L.
    Lyon0,
    /// 3: f_1 of R - L.
    Lyon1,
    /// 4: f_2 of R - L.
    Lyon2,
    /// 5: max(H*·N, 0)^4n.
    Blinn,
    /// 6: f_2 of H* - N.
    UnitHalfway,
    /// 7: f_2 of h - (h·N)N, with h = (L + V)/2 not normalised.
    Projected,
    /// 8: f_2 of h1 - (h1·N)N, h1 = h g2(h·h).
    NearlyUnitProjected2,
    /// 9: f_1 of the same vector.
    NearlyUnitProjected1,
    /// 10: f_2 of h1 - N.
    NearlyUnit,
    /// 11: exp(-2n α²), with α the angle from H* to N; it is not cut off at 90 degrees.
    TorranceSparrow,
    /// 12: (1 + n sin² α)^-2, and (1 + n)^-2 from 90 degrees on.
    TrowbridgeReitz,
}

impl Formulation {
    /// All formulations, in the appendix's order.
    pub const ALL: [Formulation; 12] = [
        Formulation::Phong,
        Formulation::Lyon0,
        Formulation::Lyon1,
        Formulation::Lyon2,
        Formulation::Blinn,
        Formulation::UnitHalfway,
        Formulation::Projected,
        Formulation::NearlyUnitProjected2,
        Formulation::NearlyUnitProjected1,
        Formulation::NearlyUnit,
        Formulation::TorranceSparrow,
        Formulation::TrowbridgeReitz,
    ];
}

/// The highlight of a unit normal, 0 to 1.
///
/// L = -V leaves no H* (extremes row 12): rows 5, 6 and 11 are then 0 and row 12 has its least
/// value; rows 7 to 9 are 1 for every normal, as the method says.
pub fn formulation(row: Formulation, n: u32, normal: DVec3, light: DVec3) -> f64 {
    let exponent = f64::from(n);
    let chord = |k| f_k(exponent / 2.0 * reflection_minus_light(normal, light).length_squared(), k);
    let of_difference = |d: DVec3, k| f_k(2.0 * exponent * d.length_squared(), k);
    let half = halfway(light) / 2.0;
    let nearly_unit = || g2(half.length_squared()) * half;
    let star = unit(half);
    match row {
        Formulation::Phong => power(reflect(normal).dot(light), n),
        Formulation::Lyon0 => chord(0),
        Formulation::Lyon1 => chord(1),
        Formulation::Lyon2 => chord(2),
        Formulation::Blinn => star.map_or(0.0, |h| power(h.dot(normal), 4 * n)),
        Formulation::UnitHalfway => star.map_or(0.0, |h| of_difference(to_normal(normal, h), 2)),
        Formulation::Projected => of_difference(to_projection(normal, half), 2),
        Formulation::NearlyUnitProjected2 => of_difference(to_projection(normal, nearly_unit()), 2),
        Formulation::NearlyUnitProjected1 => of_difference(to_projection(normal, nearly_unit()), 1),
        Formulation::NearlyUnit => of_difference(to_normal(normal, nearly_unit()), 2),
        Formulation::TorranceSparrow => {
            star.map_or(0.0, |h| torrance_sparrow(h.dot(normal), exponent))
        }
        Formulation::TrowbridgeReitz => {
            trowbridge_reitz(star.map_or(0.0, |h| h.dot(normal)), exponent)
        }
    }
}

/// Blinn's D2, exp(-2n α²). A cosine that rounding made larger than 1 counts as 1 (extremes row
/// 36).
pub fn torrance_sparrow(cosine: f64, n: f64) -> f64 {
    (-2.0 * n * cosine.clamp(-1.0, 1.0).acos().powi(2)).exp()
}

/// Blinn's D3, (1 + n sin² α)^-2.
pub fn trowbridge_reitz(cosine: f64, n: f64) -> f64 {
    let cosine = cosine.clamp(0.0, 1.0);
    (1.0 + (1.0 - cosine * cosine) * n).powi(-2)
}
