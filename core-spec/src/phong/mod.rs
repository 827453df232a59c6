//! Phong shading with the normal brought to unit length at each pixel [lecture, eq. 2.1, 4.1, 4.2],
//! methods A3, A5, and Blinn's distributions [Lyon, TR 43, appendix], with lights and eye at
//! infinity or at places [Hast et al., eq. 35 to 38], methods C15 to C18.
mod defaults;
mod inputs;
mod set_up;

use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::needs::Needs;

use crate::error::SpecError;
use crate::formats::formats;
use crate::increments::{Increments, SpanVectors};

pub use inputs::{PhongInputs, PhongLight, PhongSpan, Way};

/// How strong the highlight is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Highlight {
    /// Phong's (R·L)^n, R·L = 2(N·V)(N·L) - V·L (A3; formulation 1 of Lyon's appendix).
    Reflection,
    /// Blinn's (H*·N)^4n with H* = (L + V)/|L + V| (formulation 5).
    Blinn,
    /// Torrance and Sparrow's exp(-2n α²), α the angle between H* and N (formulation 11).
    TorranceSparrow,
    /// Trowbridge and Reitz's (1/(1 + (1 - (H*·N)²) n))² (formulation 12).
    TrowbridgeReitz,
}

/// How the direction to a light or an eye at a place F comes out of F - P, which is linear along a
/// span.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Places {
    /// (F - P)/|F - P|, by a reciprocal root (C15).
    Exact,
    /// 2v H - w with H = w + (F - P) and v = H·w / H·H, without a root; F - P has length 1 at both
    /// ends of the span (C16 to C18).
    Wrapped,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PhongSpec {
    /// How strong the highlight is.
    pub highlight: Highlight,
    /// How directions to places come about.
    pub places: Places,
    /// What becomes of the increments of vectors along a span.
    #[serde(default)]
    pub increments: Increments,
    /// The narrowing points.
    pub formats: PhongFormats,
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct PhongFormats {
        /// Accumulator of the interpolation weight a (with increments multiplied only): `U1.f`. The
        /// host rounds the step 1/S into it.
        pub weight_accumulator: Format,
        /// The weight a, rounded from the accumulator: `U1.f`.
        pub weight: Format,
        /// Accumulators of the components of vectors along a span (with increments added only):
        /// `S3.f`. The host rounds start and step into it.
        #[serde(default = "default_vector_accumulator")]
        pub vector_accumulator: Format,
        /// Components of normals and of vectors to lights and eye, before and after normalisation:
        /// `S1.f`. Differences over a span have the same fraction bits and one more integer bit.
        pub vector: Format,
        /// Squared lengths: `U2.f`.
        pub length_squared: Format,
        /// 1 over a length: `U4.f`, saturated.
        pub gain: Format,
        /// H·w and H·H of wrapped vectors: `U3.f`.
        pub wrap_operand: Format,
        /// v = H·w / H·H, 0 to 1: `U1.f`.
        pub wrap_ratio: Format,
        /// N·L, N·V and V·L: `S1.f`.
        pub cosine: Format,
        /// What is raised to a power, or 1 - H*·N: `U1.f`.
        pub base: Format,
        /// Powers, and what they are multiplied to: `U1.f`.
        pub shape: Format,
    }
}

/// The format of what cores do not have that were made before increments could be added.
const fn default_vector_accumulator() -> Format {
    Format::signed(3, 24)
}

/// By how much wrapped directions to places may move a colour, in LSBs from 0 to 255.
const MOST_OFF_BY_WRAPS: f64 = 3.0;

impl PhongSpec {
    /// Vectors along a span.
    pub(crate) fn span_vectors(&self) -> SpanVectors {
        SpanVectors {
            increments: self.increments,
            vector: self.formats.vector,
            accumulator: self.formats.vector_accumulator,
        }
    }

    /// The same with true directions to places where wrapped ones do not serve a scene.
    pub(crate) fn with_places_for(self, needs: &Needs) -> PhongSpec {
        let places = if wraps_serve(needs) { self.places } else { Places::Exact };
        PhongSpec { places, ..self }
    }

    /// Whether wrapped directions, if there are any, serve a scene.
    ///
    /// # Errors
    /// [`SpecError::Lacks`] says how far off colours would be.
    fn check_wraps(&self, needs: &Needs) -> Result<(), SpecError> {
        if self.places == Places::Exact || wraps_serve(needs) {
            return Ok(());
        }
        Err(SpecError::Lacks {
            has: format!(
                "its directions to places are wrapped, which may move colours by \
                 {MOST_OFF_BY_WRAPS} LSB"
            ),
            needs: format!("has colours that they may move by {:.1}", needs.most_off_by_wraps),
        })
    }
}

fn wraps_serve(needs: &Needs) -> bool {
    needs.most_off_by_wraps <= MOST_OFF_BY_WRAPS
}

impl Highlight {
    /// What the host multiplies the exponent n by: Blinn's lobe in the angle to H* is as wide as
    /// Phong's in the angle to R with 4n.
    pub fn exponent_factor(self) -> u32 {
        match self {
            Highlight::Reflection | Highlight::TorranceSparrow | Highlight::TrowbridgeReitz => 1,
            Highlight::Blinn => 4,
        }
    }
}
