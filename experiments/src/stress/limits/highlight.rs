//! Highlights that are meant to be others than max(R·L, 0)^n: how far they are from it, for a true
//! normal.
use glam::DVec3;
use specula_golden::exact::distributions::{Formulation, formulation};
use specula_golden::exact::normalisation::{g2, unit};
use specula_golden::exact::reflection::{halfway, halfway_cross_normal, projection, reflect};
use specula_golden::exact::shape::{f_k, power};
use specula_spec::LyonSpec;
use specula_spec::lyon::{Difference, Halfway};
use specula_spec::phong::Highlight;

/// Shorter than this L + V leaves a half-way vector that cores do not bring to unit length
/// (extremes rows 12 and 35).
const SHORTEST_HALFWAY: f64 = 1.0 / 8.0;

/// A highlight of a method, for an eye at infinity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lobe {
    /// max(R·L, 0)^n.
    Phong,
    /// One of the twelve formulations of Lyon's appendix.
    Of(Formulation),
    /// f_k of one of Lyon's differences.
    Shape {
        /// D.
        difference: Difference,
        /// The half-way vector in it.
        halfway: Halfway,
        /// k.
        squarings: u32,
    },
    /// One that no formula here has.
    Unknown,
}

impl Lobe {
    /// That of `phong`.
    pub fn of_phong(highlight: Highlight) -> Lobe {
        match highlight {
            Highlight::Reflection => Lobe::Phong,
            Highlight::Blinn => Lobe::BLINN,
            Highlight::TorranceSparrow => Lobe::Of(Formulation::TorranceSparrow),
            Highlight::TrowbridgeReitz => Lobe::Of(Formulation::TrowbridgeReitz),
        }
    }

    /// Blinn's.
    pub const BLINN: Lobe = Lobe::Of(Formulation::Blinn);

    /// That of `lyon`; of R - L and of the light's reflection f_k's difference from the power is a
    /// law of its own.
    pub fn of_lyon(lyon: &LyonSpec) -> Lobe {
        match lyon.difference {
            Difference::ReflectionMinusLight | Difference::LightReflection => Lobe::Phong,
            difference => {
                Lobe::Shape { difference, halfway: lyon.halfway, squarings: lyon.squarings }
            }
        }
    }

    /// How far it is from max(R·L, 0)^n of a true normal, 0 to 1; none where no formula has it.
    pub fn off(self, n: u32, normal: DVec3, light: DVec3) -> Option<f64> {
        let own = match self {
            Lobe::Phong => return Some(0.0),
            Lobe::Unknown => return None,
            _ if halfway(light).length() < SHORTEST_HALFWAY => return None,
            Lobe::Of(row) => formulation(row, n, normal, light),
            Lobe::Shape { difference, halfway, squarings } => {
                shape(difference, halfway, squarings, n, normal, light)?
            }
        };
        Some((own - power(reflect(normal).dot(light).min(1.0), n)).abs())
    }
}

fn shape(
    difference: Difference,
    kind: Halfway,
    squarings: u32,
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
    Some(f_k(factor * half_exponent * d.length_squared(), squarings))
}
