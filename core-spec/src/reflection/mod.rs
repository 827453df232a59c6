//! Hast's reflection shading, which needs no root: the normal is a fixed one reflected about a
//! half-way vector [Hast, Barrera and Bengtsson, eq. 27 to 34], methods C4 to C6 and C12 to C14.
//!
//! With H = (N + n)/2, linear along the span, N' = 2H(H·n)/(H·H) - n is a unit vector for any N,
//! and that of N where N is one. So N'·u = (2(H·u)(H·n) - (n·u) q)/q with q = H·H is a quotient of
//! quadratics in the pixel number for any u. (The paper's H is twice as long, and the quotient the
//! same.)
mod defaults;
mod inputs;
mod set_up;

use glam::DVec3;
use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::frame::{Frame, Span};

use crate::formats::formats;
use crate::power::{Power, PowerUnit};
use crate::ways::{Places, WayFormats};
pub use inputs::{ReflectedEye, ReflectedLight, ReflectionInputs, ReflectionLight, ReflectionSpan};

/// No longer than this, a sum of two unit vectors has no direction that is worth having (extremes
/// row 9).
const SHORTEST_SUM: f64 = 1.0 / (1 << 20) as f64;

/// The fixed normal n.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Bisector {
    /// Half-way between the normals at the span's ends.
    Span,
    /// The polygon's own normal (§4), for all of its spans; half-way between the ends where it is
    /// 90 degrees or more from one of them (extremes row 8).
    Triangle,
}

/// Where the base of the highlight comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Highlight {
    /// N'·H with H = (L + V)/|L + V|, to the power 4n: Blinn's (C12).
    Blinn,
    /// R·L of the interpolated normal by a divider of its own, as `hybrid` has it (C13).
    Hybrid,
    /// R·L = 2(N'·V)(N'·L) - L·V (C14, eq. 34).
    Eq34,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReflectionSpec {
    /// The fixed normal.
    pub bisector: Bisector,
    /// The base of the highlight.
    pub specular: Highlight,
    /// How the power of the highlight is taken.
    pub power: Power,
    /// From where lights and the eye at places are seen.
    pub places: Places,
    /// The narrowing points.
    pub formats: ReflectionFormats,
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct ReflectionFormats {
        /// Accumulators of q, of the numerators, and their differences: `S3.f`. The host rounds
        /// start values and differences into it.
        pub accumulator: Format,
        /// q and the numerators, rounded from their accumulators: `S1.f`.
        pub operand: Format,
        /// 1/q: `U3.f`.
        pub reciprocal: Format,
        /// 1/√(X·X), X to a place (with places seen from pixels only): `U<m>.f`, which reaches 2^m.
        pub way_root: Format,
        /// N'·L, N'·V and N'·H, clamped to -1..1, and L·V as the host rounds it: `S1.f`.
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
    /// log2 of what the exponent is of n: 4 with Blinn's half-way vector, whose angle to N is half
    /// as wide as R's to L, else 1.
    pub fn log2_exponent_factor(self) -> u32 {
        if self == Highlight::Blinn { 2 } else { 0 }
    }
}

impl Bisector {
    /// n for a span: a unit vector less than 90 degrees from the normals at both ends, so that |H|
    /// ≥ 1/2 all along. `None` where the ends are opposite or have no direction (extremes rows 1
    /// and 7 to 9).
    pub fn fixed_normal(self, frame: &Frame, span: &Span) -> Option<DVec3> {
        let ends = frame.unit_end_normals(span);
        let of_ends = || {
            Some(ends[0] + ends[1]).filter(|sum| sum.length() > SHORTEST_SUM).map(DVec3::normalize)
        };
        let faces_both = |n: &DVec3| ends.iter().all(|end| end.dot(*n) > SHORTEST_SUM);
        match self {
            Bisector::Span => of_ends(),
            Bisector::Triangle => {
                Some(frame.facet_normal(span)).filter(faces_both).or_else(of_ends)
            }
        }
    }
}

impl ReflectionSpec {
    /// Where what comes of ways to places is rounded.
    pub fn ways(&self) -> WayFormats {
        let &ReflectionFormats {
            accumulator, operand, way_root: root, cosine, base, shape, ..
        } = &self.formats;
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
