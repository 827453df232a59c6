//! Consistent normal interpolation [Reshetov, Soupikov and Mark, SIGGRAPH Asia 2010], methods D.
//!
//! A direction I is reflected about the interpolated normal N in such a way that the reflection r
//! never points into the surface. How far it departs from 2(N·I)N - I depends on α, the angle
//! between N and the faces around: g = N·r = 1 + q(N·I - 1), with q = 1 (the plain reflection) for
//! α = 0 and q = 0 (r = N) for a quarter turn.
mod defaults;
mod directions;
mod inputs;
mod set_up;

use serde::{Deserialize, Serialize};
use specula_datapath::Format;

use crate::formats::formats;
use crate::power::{Power, PowerUnit};
use crate::ways::Places;
pub use directions::Directions;
pub use inputs::{ConsistentInputs, ConsistentLight, ConsistentSpan, LARGEST_ANGLE};

/// How q depends on α, with t = 2α/π.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Curve {
    /// q = (1 - t)²/(1 + (π - 2)t), never above the other and at most 0.0127 below it.
    Rational,
    /// q = (1 - sin α)/(1 + sin α).
    Trigonometric,
}

/// What is diffusely reflected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Diffuse {
    /// N·L of the interpolated normal.
    Lambert,
    /// N_c·L, N_c half-way between L and its consistent reflection.
    Consistent,
}

/// Where the base of the highlight comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Highlight {
    /// r·L, r the consistent reflection of the eye.
    Reflection,
    /// N_c·H, N_c half-way between H = (L + V)/|L + V| and its consistent reflection, to the power
    /// 4n: Blinn's.
    Blinn,
}

/// m: normals shorter than 2^-m = 1/16 of the longer one at the ends of their span are lengthened
/// by 2^m and stay short.
pub const LARGEST_GAIN_BITS: u32 = 4;

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ConsistentSpec {
    /// How q depends on α.
    pub curve: Curve,
    /// What is diffusely reflected.
    pub diffuse: Diffuse,
    /// The base of the highlight.
    pub highlight: Highlight,
    /// How the power of the highlight is taken.
    pub power: Power,
    /// From where lights and the eye at places are seen.
    pub places: Places,
    /// What leaves the core beside the colour.
    #[serde(default, skip_serializing_if = "Directions::is_none")]
    pub directions: Directions,
    /// The narrowing points.
    pub formats: ConsistentFormats,
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct ConsistentFormats {
        /// Accumulator of the interpolation weight a: `U1.f`. The host rounds the step 1/S into it.
        pub weight_accumulator: Format,
        /// The weight a, rounded from the accumulator: `U1.f`.
        pub weight: Format,
        /// Components of normals and light directions, of N' after interpolation and of n after
        /// normalisation: `S1.f`; of the reflection r: `S2.f`.
        pub vector: Format,
        /// z = N'·N': `U1.f`.
        pub length_squared: Format,
        /// 1/√z, for z no smaller than 4^-4: `U4.f`, and 2^4 itself.
        pub gain: Format,
        /// Accumulator of t: `S1.f`. The host rounds start and step up into it.
        pub angle_accumulator: Format,
        /// t = 2α/π, rounded up from the accumulator and clamped to 1: `U1.f`.
        pub angle: Format,
        /// tan(π(1 - t)/4), rounded down, and the steps of its polynomial (with the trigonometric
        /// curve only): `U1.f`.
        pub tangent: Format,
        /// q, rounded down: `U1.f`.
        pub contraction: Format,
        /// The cosines b = n·I and g = n·r: `S1.f`; g + ρb, the share of n in r: `S2.f`.
        pub cosine: Format,
        /// ρ² before its root: `U1.f`.
        pub sine_ratio_squared: Format,
        /// ρ = sin γ/sin β, the share of -I in r: `U1.f`.
        pub sine_ratio: Format,
        /// Accumulators of the components of ways to places (with places seen from pixels only):
        /// `S3.f`. The host rounds start and step into it.
        pub way_accumulator: Format,
        /// Diffuse intensity, clamped to 0..1: `U1.f`.
        pub diffuse: Format,
        /// r·L or N_c·H, clamped to 0..1, and each square of it: `U1.f`.
        pub base: Format,
        /// What tables make of the base (with power by tables only): `U1.f`.
        pub shape: Format,
    }
}

impl ConsistentFormats {
    /// Format of N1 - N0: the vector's with one more integer bit, since the difference of two
    /// vectors is up to twice as long.
    pub fn vector_sum(&self) -> Format {
        Format::signed(self.vector.integer_bits + 1, self.vector.fraction_bits)
    }
}

impl Highlight {
    /// log2 of what the exponent is of n: 4 with Blinn's half-way vector, whose angle to N is half
    /// as wide as R's to L, else 1.
    pub fn log2_exponent_factor(self) -> u32 {
        if self == Highlight::Blinn { 2 } else { 0 }
    }
}

impl Curve {
    /// t at a vertex whose normal has the least cosine `m` with the faces around it: α =
    /// acos(m)(1 + c(1 - m)^e) in quarter turns, 0 to 1.0625. α is not clamped to a quarter turn
    /// here, so that it is not too small between vertices (extremes row 45).
    ///
    /// c and e are such that the interpolated α suffices everywhere in a triangle: the paper's for
    /// the rational curve; for the trigonometric one the paper's e = 2 does not do, and e = 1 with
    /// c = 0.06097 does (numerics N1).
    pub fn quarter_turns(self, m: f64) -> f64 {
        let m = m.clamp(0.0, 1.0);
        let excess = match self {
            Curve::Rational => 0.03632 * (1.0 - m) * (1.0 - m),
            Curve::Trigonometric => 0.06097 * (1.0 - m),
        };
        libm::acos(m) * std::f64::consts::FRAC_2_PI * (1.0 + excess)
    }
}

impl ConsistentSpec {
    /// The power of the highlight.
    pub fn power_unit(&self) -> PowerUnit {
        PowerUnit {
            power: self.power,
            log2_factor: self.highlight.log2_exponent_factor(),
            base: self.formats.base,
            shape: self.formats.shape,
        }
    }
}
