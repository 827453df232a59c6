//! Highlights that are defined otherwise than max(R·L, 0)^n: their difference from it, for an exact
//! normal.
use glam::DVec3;
use specula_golden::exact::formula::distributions::{Formulation, formulation};
use specula_golden::exact::formula::normalisation::{g2, unit};
use specula_golden::exact::formula::reflection::{
    halfway, halfway_cross_normal, projection, reflect,
};
use specula_golden::exact::formula::shape::{lobe, power};
use specula_spec::LyonSpec;
use specula_spec::lyon::{Difference, Halfway};
use specula_spec::phong::Highlight;

/// If L + V is shorter than this, cores do not normalise the half-way vector (extremes rows 12 and
/// 35).
const SHORTEST_HALFWAY: f64 = 1.0 / 8.0;

/// A highlight of a method, for an eye at infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lobe {
    /// max(R·L, 0)^n.
    Phong,
    /// One of the twelve formulations of Lyon's appendix.
    Formula(Formulation),
    /// (1 - x/K)^K of one of Lyon's differences.
    Shape {
        /// The vector D.
        difference: Difference,
        /// The half-way vector in it.
        halfway: Halfway,
        /// K.
        factors: u32,
    },
    /// A highlight without a formula here.
    Unknown,
}

impl Lobe {
    /// The highlight of `phong`.
    pub fn of_phong(highlight: Highlight) -> Lobe {
        match highlight {
            Highlight::Reflection => Lobe::Phong,
            Highlight::Blinn => Lobe::BLINN,
            Highlight::TorranceSparrow => Lobe::Formula(Formulation::TorranceSparrow),
            Highlight::TrowbridgeReitz => Lobe::Formula(Formulation::TrowbridgeReitz),
        }
    }

    /// Blinn's highlight.
    pub const BLINN: Lobe = Lobe::Formula(Formulation::Blinn);

    /// The highlight of `lyon`. For R - L and the light's reflection, the difference between the
    /// shape and the power is a separate law.
    pub fn of_lyon(lyon: &LyonSpec) -> Lobe {
        match lyon.difference {
            Difference::ReflectionMinusLight | Difference::LightReflection => Lobe::Phong,
            difference => Lobe::Shape { difference, halfway: lyon.halfway, factors: lyon.terms() },
        }
    }

    /// The difference from max(R·L, 0)^n of an exact normal, 0 to 1; `None` if there is no formula.
    pub fn difference(self, n: u32, normal: DVec3, light: DVec3) -> Option<f64> {
        let own = match self {
            Lobe::Phong => return Some(0.0),
            Lobe::Unknown => return None,
            _ if halfway(light).length() < SHORTEST_HALFWAY => return None,
            Lobe::Formula(row) => formulation(row, n, normal, light),
            Lobe::Shape { difference, halfway, factors } => {
                shape(difference, halfway, factors, n, normal, light)?
            }
        };
        Some((own - power(reflect(normal).dot(light).min(1.0), n)).abs())
    }
}

fn shape(
    difference: Difference,
    kind: Halfway,
    factors: u32,
    n: u32,
    normal: DVec3,
    light: DVec3,
) -> Option<f64> {
    let half_exponent = f64::from(n) / 2.0;
    let half = halfway(light) / 2.0;
    let about_unit = match kind {
        Halfway::Unit => unit(half)?,
        Halfway::Half => half,
        Halfway::HalfG2 => g2(half.length_squared()) * half,
    };
    let (d, factor) = match difference {
        Difference::HalfwayProjection => (projection(normal, halfway(light)), 1.0),
        Difference::HalfwayCrossNormal => (halfway_cross_normal(normal, light), 1.0),
        Difference::UnitHalfwayMinusNormal => (about_unit - normal, 4.0),
        Difference::UnitHalfwayProjection => (projection(normal, about_unit), 4.0),
        Difference::ReflectionMinusLight | Difference::LightReflection => return None,
    };
    Some(lobe(factor * half_exponent * d.length_squared(), factors))
}
