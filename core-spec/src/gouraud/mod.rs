//! Intensities of a polygon's vertices, or of the polygon as a whole [lecture, eq. 2.1 and 3.2 to
//! 3.6], methods A3 and A4.
//!
//! The host works out Phong's formula, max(N·L, 0) and max(R·L, 0)^n with R = 2(N·V)N - V, or Lyon's
//! f_k in place of the power [Lyon, figure 1; methods B]; the core sees nothing of n.
mod defaults;
mod highlight;
mod inputs;
mod lit_point;
mod set_up;

use serde::{Deserialize, Serialize};
use specula_datapath::Format;

use crate::formats::formats;

pub use highlight::{Highlight, VertexHighlight};
pub use inputs::{GouraudInputs, GouraudLight, Intensity};
pub use lit_point::LitPoint;

/// Where intensities are computed, and what lies between.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Interpolation {
    /// At the vertices, and linear between them (A4).
    Linear,
    /// Once for each polygon, from the polygon's own normal (A3, lecture eq. 2.1); no accumulator
    /// is built.
    Uniform,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GouraudSpec {
    /// Where intensities are computed.
    pub interpolation: Interpolation,
    /// What the highlight is at the points where it is computed.
    #[serde(default)]
    pub highlight: Highlight,
    /// k of f_k(x) = (1 - x/2^k)^(2^k), 0 to 4: how often the host squares it.
    #[serde(default = "default_squarings")]
    pub squarings: u32,
    /// The narrowing points.
    pub formats: GouraudFormats,
}

/// k of Lyon's figure 7, also in files of cores that were made before there was a choice.
const fn default_squarings() -> u32 {
    2
}

impl GouraudSpec {
    /// The highlight of a surface with the exponent `shininess`.
    pub const fn vertex_highlight(&self, shininess: u32) -> VertexHighlight {
        VertexHighlight { highlight: self.highlight, squarings: self.squarings, shininess }
    }
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct GouraudFormats {
        /// Accumulators of the intensities: `S1.f`. The host rounds start and step into it; with
        /// linear interpolation only.
        pub accumulator: Format,
        /// Diffuse and specular intensity, rounded from the accumulator, or by the host where they
        /// are uniform: `U1.f`.
        pub intensity: Format,
    }
}
