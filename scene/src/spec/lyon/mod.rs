//! Lyon's reformulation of Phong shading for hardware [Lyon, Apple TR 43], METHODS.md B1 to B13.
mod choose;
mod inputs;
mod set_up;

use serde::{Deserialize, Serialize};

use crate::format::Format;
pub use inputs::{LyonInputs, LyonLight};

/// How the interpolated normal is brought to unit length: n = g·N', with z = N'·N' and y = 1 - z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normalisation {
    /// g1 = 1 + y/2 (B8).
    G1,
    /// g2 = 1 + (y + y²)/2 (B9).
    G2,
}

/// The vector D whose squared length the highlight depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Difference {
    /// D = R - L with R = 2(N·V)N - V (B1, B2; figure 7).
    ReflectionMinusLight,
    /// D = H × N with H = L + V (B13).
    HalfwayCrossNormal,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LyonSpec {
    /// First approximation of 1/|N'|.
    pub normalisation: Normalisation,
    /// Newton steps g ← g(3 - z g²)/2 after it, 0 to 3.
    pub newton_steps: u32,
    /// The vector D.
    pub difference: Difference,
    /// k of the shape function f_k(x) = (1 - x/2^k)^(2^k), 0 to 3: how often the shape is squared.
    pub squarings: u32,
    /// The narrowing points.
    pub formats: LyonFormats,
}

/// The narrowing points of the method, in the order of the data.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LyonFormats {
    /// Accumulator of the interpolation weight a: `U1.f`. The host rounds the step 1/S into it.
    pub weight_accumulator: Format,
    /// The weight a, rounded from the accumulator: `U1.f`.
    pub weight: Format,
    /// Components of normals and light directions, of N' after interpolation and of n after normalisation: `S1.f`.
    /// Differences of normals and half-way vectors have the same fraction bits and one more integer bit.
    pub vector: Format,
    /// z = N'·N': `U1.f`.
    pub length_squared: Format,
    /// g, and within a Newton step g² and 3 - z g²: `U2.f`.
    pub gain: Format,
    /// N·L after clamping at 0: `U1.f`.
    pub diffuse: Format,
    /// 2 N·V (with D = R - L only) and the components of D: `S2.f`.
    pub difference: Format,
    /// x/2^k before comparison with 1, 1 - x/2^k, and after each squaring: `U1.f`.
    pub shape: Format,
}

impl LyonFormats {
    /// Format of N1 - N0 and of H: the vector's with one more integer bit, since the sum of two vectors is up to twice as long.
    pub fn vector_sum(&self) -> Format {
        Format::signed(self.vector.integer_bits + 1, self.vector.fraction_bits)
    }
}
