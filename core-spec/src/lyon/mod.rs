//! Lyon's reformulation of Phong shading for hardware [Lyon, Apple TR 43], methods B1 to B13.
mod defaults;
mod inputs;
mod set_up;
mod wrap;

use serde::{Deserialize, Serialize};
use specula_datapath::Format;

use crate::formats::formats;
use crate::increments::{Increments, SpanVectors};
use crate::ways::Places;

pub use inputs::{LyonInputs, LyonLight, LyonSpan};
pub use wrap::NormalWrap;

/// What the normal does along a span.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normals {
    /// N' = N0 + a (N1 - N0), which is then brought near unit length (B12).
    Linear,
    /// The polygon's own normal, the same at every pixel: neither interpolated nor normalised
    /// (lecture 21, eq. 2.1).
    Flat,
    /// n = 2v H - w with H = (N0 + w) + a (N1 - N0) and v = H·w / H·H: of unit length, whatever H
    /// is [Hast, Barrera and Bengtsson, eq. 27 and 28; C4, C5].
    Wrapped,
}

/// The unit vector w that wrapped normals are wrapped around (C7).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum WrapAxis {
    /// The bisector of the end normals.
    Bisector,
    /// The polygon's own normal; the bisector where an end normal is 90 degrees or more from it
    /// (extremes row 8).
    Face,
    /// The wrapped normal of the pixel before, and N0 at the first; the bisector in spans of more
    /// than 30 degrees that take fewer than 16 steps, and in those of more than 120 degrees
    /// (extremes row 11).
    Previous,
}

/// How the interpolated normal is brought to unit length: n = g·N', with z = N'·N' and y = 1 - z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Normalisation {
    /// n = N': nothing is done, and there are no Newton steps.
    None,
    /// g1 = 1 + y/2 (B8).
    G1,
    /// g2 = 1 + (y + y²)/2 (B9).
    G2,
    /// g = 1/√max(z, 4^-4), correctly rounded: exact for normals no shorter than 1/16, those of
    /// spans up to 172 degrees. No Newton steps.
    Exact,
}

/// The vector D whose squared length the highlight depends on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Difference {
    /// D = R - L with R = 2(N·V)N - V (B1, B2; figure 7). It is D1 = 2(N·V)N - H (B3; figure 5).
    ReflectionMinusLight,
    /// D2 = 2(N·L)N - H with H = L + V: the light reflected, less V (B4; figure 5). For a unit
    /// normal as long as R - L.
    LightReflection,
    /// D3 = (H·N)N - H (B5; figure 5). For a unit normal |H| sin of the angle between H and N.
    HalfwayProjection,
    /// D = H × N (B13). As long as D3 for a unit normal.
    HalfwayCrossNormal,
    /// D = h - N, where h is what [`Halfway`] says (B6).
    UnitHalfwayMinusNormal,
    /// D = (h·N)N - h, where h is what [`Halfway`] says (B6).
    UnitHalfwayProjection,
}

impl Difference {
    /// Whether D is made of H = L + V.
    pub const fn takes_halfway(self) -> bool {
        matches!(self, Difference::HalfwayProjection | Difference::HalfwayCrossNormal)
    }

    /// Whether D is made of a half-way vector of about unit length.
    ///
    /// The angle between H and N is half of that between R and L, so such a D is half as long as
    /// R - L and goes with 4n (B6, B7).
    pub const fn takes_unit_halfway(self) -> bool {
        matches!(self, Difference::UnitHalfwayMinusNormal | Difference::UnitHalfwayProjection)
    }

    /// log2 of the factor of the exponent that gives D the highlight of cos^n: 2 where D is half as
    /// long as R - L, else 0.
    pub const fn log2_exponent_factor(self) -> u32 {
        if self.takes_unit_halfway() { 2 } else { 0 }
    }
}

/// The half-way vector of about unit length, made by the host (B6, B7; figure 9).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Halfway {
    /// H* = H/|H| with H = L + V; a light with L = -V has none, and no highlight (extremes row 12).
    Unit,
    /// h = H/2, not normalised.
    Half,
    /// h1 = g2(h·h) h with h = H/2.
    HalfG2,
}

/// How the shape function is computed from D.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ShapeDatapath {
    /// x = (n/2) D·D: one wide product (figure 7).
    FK,
    /// x = mD·mD/2 with m = √n: small squares of fractions, and a comparator that also sees the
    /// integer parts (figure 8).
    Root,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LyonSpec {
    /// What the normal does along a span.
    pub normals: Normals,
    /// What wrapped normals are wrapped around.
    pub axis: WrapAxis,
    /// What becomes of the increments of normals that change along a span.
    #[serde(default)]
    pub increments: Increments,
    /// First approximation of 1/|N'|.
    pub normalisation: Normalisation,
    /// Newton steps g ← g(3 - z g²)/2 after it, 0 to 3.
    pub newton_steps: u32,
    /// The vector D.
    pub difference: Difference,
    /// The half-way vector of those D that take one of about unit length.
    pub halfway: Halfway,
    /// How f_k is computed from D.
    pub shape: ShapeDatapath,
    /// k of the shape function f_k(x) = (1 - x/2^k)^(2^k), 0 to 4: how often the shape is squared.
    pub squarings: u32,
    /// An odd number from 1 to 15: the shape function is (1 - x/K)^K with K this times 2^k (B10).
    #[serde(default = "one")]
    pub odd_power: u32,
    /// From where lights and the eye at places are seen.
    pub places: Places,
    /// The narrowing points.
    pub formats: LyonFormats,
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct LyonFormats {
        /// Accumulator of the interpolation weight a (with increments multiplied only): `U1.f`. The
        /// host rounds the step 1/S into it.
        pub weight_accumulator: Format,
        /// The weight a, rounded from the accumulator: `U1.f`.
        pub weight: Format,
        /// Accumulators of the components of normals (with increments added only): `S3.f`. The host
        /// rounds start and step into it.
        #[serde(default = "default_normal_accumulator")]
        pub normal_accumulator: Format,
        /// Components of normals and light directions, of N' after interpolation and of n after
        /// normalisation: `S1.f`. Differences of normals and half-way vectors have the same
        /// fraction bits and one more integer bit.
        pub vector: Format,
        /// H·w and H·H of wrapped normals: `U3.f`, since H·H reaches 4.
        pub wrap_operand: Format,
        /// v = H·w / H·H of wrapped normals: `U1.f`.
        pub wrap_ratio: Format,
        /// z = N'·N': `U1.f`.
        pub length_squared: Format,
        /// g, and within a Newton step g² and 3 - z g²: `U2.f`.
        pub gain: Format,
        /// Accumulators of the components of ways to places (with places seen from pixels only):
        /// `S3.f`. The host rounds start and step into it.
        pub way_accumulator: Format,
        /// Products of N'·N' (with g1 and g2), N·L, H × N and D·D (of the shape f-k), truncated before
        /// they are added: `S3.f`.
        pub product: Format,
        /// N·L after clamping at 0: `U1.f`.
        pub diffuse: Format,
        /// The components of D, and before them 2 N·V, 2 N·L, H·N or h·N where D is made of it:
        /// `S2.f`.
        pub difference: Format,
        /// m of the root shape: `U7.f`. The host rounds it.
        pub root_shininess: Format,
        /// n over an odd power greater than 1: `U13.f`. The host rounds it.
        #[serde(default = "default_shininess_share")]
        pub shininess_share: Format,
        /// m|D_c| 2^-h of the root shape: `U8.f`.
        pub scaled_difference: Format,
        /// x/2^k before comparison with 1, 1 - x/2^k, and after each squaring: `U1.f`.
        pub shape: Format,
    }
}

/// Without an odd power, as in files of cores that were made before there was one.
const fn one() -> u32 {
    1
}

/// Formats of what those cores do not have.
const fn default_shininess_share() -> Format {
    Format::unsigned(13, 12)
}

const fn default_normal_accumulator() -> Format {
    Format::signed(3, 24)
}

impl LyonFormats {
    /// What a product of two numbers of such a format is less after it was truncated, at most.
    pub fn truncated(&self, factor: Format) -> f64 {
        let is_shorter = self.product.fraction_bits < 2 * factor.fraction_bits;
        if is_shorter { self.product.ulp() } else { 0.0 }
    }

    /// Format of N1 - N0 and of H: the vector's with one more integer bit, since the sum of two
    /// vectors is up to twice as long.
    pub fn vector_sum(&self) -> Format {
        Format::signed(self.vector.integer_bits + 1, self.vector.fraction_bits)
    }
}

/// m of the exact normalisation: g is 2^m at most.
pub const LOG2_LARGEST_GAIN: u32 = 4;

impl LyonSpec {
    /// Normals along a span.
    pub(crate) fn span_vectors(&self) -> SpanVectors {
        SpanVectors {
            increments: self.increments,
            vector: self.formats.vector,
            accumulator: self.formats.normal_accumulator,
        }
    }

    /// The same with g2 alone for a normalisation.
    pub fn with_g2(&self) -> LyonSpec {
        LyonSpec { normalisation: Normalisation::G2, newton_steps: 0, ..self.clone() }
    }

    /// K of the shape function (1 - x/K)^K.
    pub const fn terms(&self) -> u32 {
        self.odd_power << self.squarings
    }

    /// h of the root shape, u_c = m|D_c| 2^-h: 1, 1, 2, 2, 3 for k = 0 to 4, and one less where D
    /// goes with 4n.
    pub const fn root_shift(&self) -> u32 {
        self.squarings / 2 + 1 - self.difference.log2_exponent_factor() / 2
    }

    /// What m² of the root shape is for n = 1, so that u·u = n D·D / 2K: 1 for odd k, and 2 for even
    /// k, whose shift is a half too far, over the odd power. Where D goes with 4n, the shift has the
    /// factor.
    pub fn root_factor(&self) -> f64 {
        let of_shift = if self.squarings.is_multiple_of(2) { 2.0 } else { 1.0 };
        of_shift / f64::from(self.odd_power)
    }

    /// What the host multiplies n by where the shape is made of n D·D.
    pub fn shininess_factor(&self) -> f64 {
        1.0 / f64::from(self.odd_power)
    }
}
