//! Gouraud diffuse with Hast's specular recurrence [Hast, Barrera and Bengtsson, eq. 17 to 26],
//! methods C3.
//!
//! Along a span N(i) = m + k i, so that both p = 2(N·V)(N·L) - (L·V)(N·N) and q = N·N are quadratic
//! in the pixel number i, and the base of the highlight is R·L = p/q for a normal of any length.
mod defaults;
mod inputs;
mod set_up;

use serde::{Deserialize, Serialize};
use specula_datapath::Format;

use crate::formats::formats;
use crate::power::{Power, PowerUnit};
use crate::ways::{Places, WayFormats};
pub use inputs::{HybridInputs, HybridLight, HybridSpan};

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HybridSpec {
    /// How the power of the highlight is taken.
    pub power: Power,
    /// From where lights and the eye at places are seen.
    pub places: Places,
    /// The narrowing points.
    pub formats: HybridFormats,
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct HybridFormats {
        /// Accumulator of the diffuse intensity: `S1.f`. The host rounds start and step into it.
        pub diffuse_accumulator: Format,
        /// Diffuse intensity, rounded from the accumulator: `U1.f`.
        pub diffuse: Format,
        /// Accumulators of p and q and their differences: `S3.f`. The host rounds start values and
        /// differences into it.
        pub accumulator: Format,
        /// p and q as they enter the divider: `S1.f`.
        pub operand: Format,
        /// 1/√(X·X), X to a place (with places seen from pixels only): `U<m>.f`, which reaches 2^m.
        pub way_root: Format,
        /// The base p/q, and each square of it: `U1.f`.
        pub base: Format,
        /// What tables make of the base (with power by tables only): `U1.f`.
        pub shape: Format,
    }
}

impl HybridSpec {
    /// Where what comes of ways to places is rounded.
    pub fn ways(&self) -> WayFormats {
        let &HybridFormats { accumulator, operand, way_root: root, base, shape, .. } =
            &self.formats;
        WayFormats { accumulator, operand, root, cosine: operand, base, shape }
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
