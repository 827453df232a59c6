//! Spherical interpolation along the scan line, of the scalars that shading needs [lecture, eq. 4.7
//! and 4.9 to 4.12], methods A9 to A11.
//!
//! With A and B the unit normals at the ends of a span, f the angle between them and T the unit
//! vector across A towards B, N(i) = cos(i f/S) A + sin(i f/S) T. So J = N·L and K = N·V are what
//! one rotation makes of four scalars, whatever the number of lights, and the base of the highlight
//! is 2 J K - L·V. Nothing is divided by sin f: a span of no angle is one like others.
mod arc_rotation;
mod defaults;
mod inputs;
mod set_up;

use serde::{Deserialize, Serialize};
use specula_datapath::Format;
use specula_scene::{Arc, Frame, Span};

use crate::formats::formats;
use crate::power::{Power, PowerUnit};
use crate::ways::{Places, WayFormats};
pub use arc_rotation::{ArcRotation, LARGEST_WEIGHT};
pub use inputs::{
    Axes, EyeAlongArc, LightAlongArc, OnArc, SlerpInputs, SlerpLight, SlerpSpan, WayAlongArc,
};

/// What is put together from the weights of an arc.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// J = N·L of each light and K = N·V, in an orthonormal frame (A10).
    Scalar,
    /// N itself, brought near unit length by the factor (3 - N·N)/2, and from it N·L and N·V (A8,
    /// A9, A11).
    Vector,
}

/// What the normal of [`Form::Vector`] is put together from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Basis {
    /// A and the unit vector T across it: N = cos(i f/S) A + sin(i f/S) T, one rotation (A11).
    Orthonormal,
    /// A and B, with the sines of (1 - t) f and t f over sin f: two rotations (A8, A9). Below 10
    /// degrees 1 - t and t stand for them, and from 170 degrees on the basis is orthonormal.
    Ends,
}

/// How normals go along the triangle's edges, from which they go along scan lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Edges {
    /// Linearly, as everything else in a triangle; A and B are brought to unit length.
    #[default]
    Linear,
    /// By slerp from vertex to vertex, and from there to A and B by slerp along the scan line
    /// (lecture, §4.4, step ii).
    Slerp,
}

/// Options of the method.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SlerpSpec {
    /// What is put together from the weights of an arc.
    pub form: Form,
    /// What a normal is put together from; scalars have an orthonormal frame.
    pub frame: Basis,
    /// How normals go along edges.
    #[serde(default)]
    pub edges: Edges,
    /// How the power of the highlight is taken.
    pub power: Power,
    /// From where lights and the eye at places are seen.
    pub places: Places,
    /// The narrowing points.
    pub formats: SlerpFormats,
}

formats! {
    /// The narrowing points of the method, in the order of the data.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields)]
    pub struct SlerpFormats {
        /// Cosine and sine of the angle from pixel to pixel: `S1.f`, rounded by the host.
        pub turn: Format,
        /// Cosine and sine of the angle from the first pixel, rounded at every pixel: `S1.f`.
        pub state: Format,
        /// Cosines and sines of both angles over sin f, between the ends themselves: `S3.f`, since
        /// 1/sin f reaches 5.76.
        pub scaled_state: Format,
        /// The same, as they are multiplied with: `S1.f`, and `S3.f` between the ends themselves.
        pub weight: Format,
        /// Components of A, B, T and L, of N, and of N times (3 - N·N)/2: `S1.f`.
        pub vector: Format,
        /// A·L, T·L, A·V, T·V and L·V: `S1.f`, rounded by the host.
        pub component: Format,
        /// J, K, the correction of K's length, and K after it: `S1.f`.
        pub cosine: Format,
        /// Accumulators of what comes of ways to places, and their differences (with places seen
        /// from pixels only): `S3.f`. The host rounds start values and differences into it.
        pub way_accumulator: Format,
        /// 1/√(X·X), X to a place (with places seen from pixels only): `U<m>.f`, which reaches 2^m.
        pub way_root: Format,
        /// J, clamped: `U1.f`.
        pub diffuse: Format,
        /// The base of the highlight, and each square of it: `U1.f`.
        pub base: Format,
        /// What tables make of the base (with power by tables only): `U1.f`.
        pub shape: Format,
    }
}

impl SlerpSpec {
    /// The arc from the normal at a span's first pixel to that at its last.
    pub fn arc(&self, frame: &Frame, span: &Span) -> Arc {
        match self.edges {
            Edges::Linear => frame.arc(span),
            Edges::Slerp => frame.arc_between_edges(span),
        }
    }

    /// A length that the middle of no chord between a span's ends falls short of, 0 to 1, where
    /// linearly interpolated normals are `shortest_normal` long. They say nothing of ends between
    /// which normals go by slerp from vertex to vertex.
    pub const fn shortest_chord(&self, shortest_normal: f64) -> f64 {
        match self.edges {
            Edges::Linear => shortest_normal,
            Edges::Slerp => 0.0,
        }
    }

    /// Where what comes of ways to places is rounded.
    pub fn ways(&self) -> WayFormats {
        let &SlerpFormats {
            way_accumulator: accumulator, way_root: root, cosine, base, shape, ..
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
