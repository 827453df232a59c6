//! Duff's Phong shading by forward differences with the highlights that Hast adds [Hast, Barrera
//! and Bengtsson, eq. 3 to 8, 17, 33 and 34], methods C2 and C8 to C11.
//!
//! Along a span N(i) = m + k i, so that p = N·L is linear and q = N·N quadratic in the pixel number
//! i, and N·L of the unit normal is p/√q.
mod defaults;
mod inputs;
mod set_up;

use serde::{Deserialize, Serialize};
use specula_datapath::Format;

use crate::formats::formats;
use crate::power::{Power, PowerUnit};
use crate::ways::{Places, WayFormats};
pub use inputs::{DuffInputs, DuffLight, DuffSpan};

/// Where the base of the highlight comes from. N is the interpolated normal, s = 1/√(N·N).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Highlight {
    /// N·H s with H = (L + V)/|L + V|, to the power 4n: Blinn's (C8).
    Blinn,
    /// R·L as a quotient of two quadratics, by a divider of its own (C9, eq. 17).
    Quotient,
    /// R·L = 2(N·V)(p/q) - L·V, by a divider of its own (C10, eq. 33).
    Eq33,
    /// R·L = 2(N·V s)(p s) - L·V, with nothing to divide (C11, eq. 34).
    Eq34,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DuffSpec {
    /// The base of the highlight.
    pub specular: Highlight,
    /// How the power of the highlight is taken.
    pub power: Power,
    /// From where lights and the eye at places are seen.
    pub places: Places,
    /// The narrowing points.
    pub formats: DuffFormats,
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct DuffFormats {
        /// Accumulators of p, N·V and N·H: `S1.f`. The host rounds start values and steps into it.
        pub linear_accumulator: Format,
        /// Accumulators of q, of the numerator of the quotient, and their differences: `S3.f`. The
        /// host rounds start values and differences into it.
        pub accumulator: Format,
        /// p, q, N·V, N·H and the numerator, rounded from their accumulators: `S1.f`.
        pub operand: Format,
        /// s = 1/√q: `U<m>.f`. The integer bits m, 1 to 12, say how far it reaches: 2^m, for
        /// normals no shorter than 2^-m.
        pub root: Format,
        /// 1/√(X·X), X to a place (with places seen from pixels only): `U<m>.f`, which reaches 2^m.
        pub way_root: Format,
        /// p/q (with eq. 33 only), as large as s at most: `S2.f`.
        pub quotient: Format,
        /// Cosines: p s, N·V s and N·H s, clamped to -1..1, and L·V as the host rounds it: `S1.f`.
        pub cosine: Format,
        /// Diffuse intensity: `U1.f`.
        pub diffuse: Format,
        /// The base of the highlight, and each square of it: `U1.f`.
        pub base: Format,
        /// What tables make of the base (with power by tables only): `U1.f`.
        pub shape: Format,
    }
}

impl Highlight {
    /// Whether the base needs N·V and L·V.
    pub fn looks_at_the_eye(self) -> bool {
        matches!(self, Highlight::Eq33 | Highlight::Eq34)
    }

    /// log2 of what the exponent is of n: 4 with Blinn's half-way vector, whose angle to N is half
    /// as wide as R's to L, else 1.
    pub fn log2_exponent_factor(self) -> u32 {
        if self == Highlight::Blinn { 2 } else { 0 }
    }
}

impl DuffSpec {
    /// Where what comes of ways to places is rounded.
    pub fn ways(&self) -> WayFormats {
        let &DuffFormats { accumulator, operand, way_root: root, cosine, base, shape, .. } =
            &self.formats;
        WayFormats { accumulator, operand, root, cosine, base, shape }
    }

    /// The power of the highlight.
    pub fn power_unit(&self) -> PowerUnit {
        PowerUnit {
            power: self.power,
            log2_factor: self.specular.log2_exponent_factor(),
            base: self.formats.base,
            shape: self.formats.shape,
        }
    }
}
