//! The fast Phong formulas evaluated anew at every pixel [lecture, eq. 4.3 to 4.6], methods A6,
//! A7; numerics N3b.
//!
//! With A and B the unit normals at the ends of a span, N = A + t (B - A) has the squared length
//! q = 1 - κ t (1 - t), κ = |B - A|². So J = N·L and K = N·V are linear in t, and q needs no
//! forward differences, whose errors grow with the square of the span's length. J and K are made of
//! t, or added up from pixel to pixel, J ← J + ΔJ, as the lecture prints it.
mod defaults;
mod inputs;
mod set_up;

use serde::{Deserialize, Serialize};
use specula_datapath::Format;

use crate::formats::formats;
use crate::increments::Increments;
use crate::power::{Power, PowerUnit};
use crate::ways::{Places, WayFormats};
pub use inputs::{DirectInputs, DirectLight, DirectSpan, Ends};

/// How √q is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Root {
    /// 1/√q, correctly rounded.
    Exact,
    /// d = √q by Newton's d ← (d + q/d)/2, which begins with the d of the pixel before, and 1 at
    /// the first (§4.2 of the lecture).
    Newton,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DirectSpec {
    /// How √q is found.
    pub root: Root,
    /// Newton's steps at each pixel, 1 or 2.
    pub newton_steps: u32,
    /// How the power of the highlight is taken.
    pub power: Power,
    /// From where lights and the eye at places are seen.
    pub places: Places,
    /// What becomes of the increments of N·L and N·V along a span.
    #[serde(default)]
    pub increments: Increments,
    /// The narrowing points.
    pub formats: DirectFormats,
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct DirectFormats {
        /// Accumulator of t: `U1.f`. The host rounds the step 1/S into it.
        pub weight_accumulator: Format,
        /// t, rounded from the accumulator: `U1.f`.
        pub weight: Format,
        /// t (1 - t): `U1.f`.
        pub product: Format,
        /// κ: `U3.f`, rounded by the host.
        pub spread: Format,
        /// A·L and A·V (with increments multiplied only), and L·V: `S1.f`, rounded by the host.
        /// Differences between the ends have one more integer bit.
        pub component: Format,
        /// Accumulators of N·L and N·V (with increments added only): `S1.f`. The host rounds start
        /// and step into it.
        #[serde(default = "default_scalar_accumulator")]
        pub scalar_accumulator: Format,
        /// q: `U1.f`.
        pub length_squared: Format,
        /// d = √q by Newton's method, and q/d before: `U1.f`.
        pub length: Format,
        /// 1/√q, or 1/d: `U<m>.f`. q counts as 4^-m at least, with m from 0 to 4.
        pub reciprocal: Format,
        /// N·L and N·V, before and after they are multiplied by 1/√q: `S1.f`.
        pub cosine: Format,
        /// Accumulators of what comes of ways to places, and their differences (with places seen
        /// from pixels only): `S3.f`. The host rounds start values and differences into it.
        pub way_accumulator: Format,
        /// 1/√(X·X), X to a place (with places seen from pixels only): `U<m>.f`, which reaches 2^m.
        pub way_root: Format,
        /// N·L/√q, clamped: `U1.f`.
        pub diffuse: Format,
        /// The base of the highlight, and each square of it: `U1.f`.
        pub base: Format,
        /// What tables make of the base (with power by tables only): `U1.f`.
        pub shape: Format,
    }
}

/// The format of what cores do not have that were made before increments could be added.
const fn default_scalar_accumulator() -> Format {
    Format::signed(1, 24)
}

impl DirectFormats {
    /// Format of differences between the ends: the component's with one more integer bit.
    pub fn component_sum(&self) -> Format {
        Format::signed(self.component.integer_bits + 1, self.component.fraction_bits)
    }
}

impl DirectSpec {
    /// Where what comes of ways to places is rounded.
    pub fn ways(&self) -> WayFormats {
        let &DirectFormats {
            way_accumulator: accumulator,
            way_root: root,
            cosine,
            base,
            shape,
            ..
        } = &self.formats;
        WayFormats { accumulator, operand: cosine, root, cosine, base, shape }
    }

    /// The power of the highlight.
    pub fn power_unit(&self) -> PowerUnit {
        PowerUnit {
            power: self.power,
            log2_factor: 0,
            base: self.formats.base,
            shape: self.formats.shape,
        }
    }
}
