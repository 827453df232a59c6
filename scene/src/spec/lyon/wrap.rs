//! What the host chooses for wrapped normals [Hast, Barrera and Bengtsson; METHODS.md C4 to C7].
use glam::DVec3;

use super::{LyonSpec, Normals, WrapAxis};
use crate::frame::{Frame, Span};

/// The ends of a span of wrapped normals, and what they are wrapped around.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrap {
    /// Unit normals at the first and the last pixel.
    pub ends: [DVec3; 2],
    /// The unit vector w, within 90 degrees of both; that of the first pixel alone where wrapped normals follow.
    pub axis: DVec3,
    /// Whether each pixel but the first is wrapped around what the one before came to.
    pub follows: bool,
}

/// What it takes to follow: a wrapped normal lags behind by what it is short of N, which is little in narrow spans and in those of many steps
/// (NUMERICS 2b).
const NARROW: f64 = 30.0;
const WIDE: f64 = 120.0;
const MANY_STEPS: u32 = 16;

impl LyonSpec {
    /// Whether normals are wrapped around those of the pixel before.
    pub fn follows(&self) -> bool {
        self.normals == Normals::Wrapped && self.axis == WrapAxis::Previous
    }

    /// The wrap of a span. A normal of length 0 is taken from the other end; where both are, everything is 0.
    ///
    /// An axis that is 90 degrees or more from an end gives way: the face's normal to the bisector (EXTREMES row 8), and the bisector of
    /// opposite ends to a vector across them (row 7).
    pub fn wrap(&self, frame: &Frame, span: &Span) -> Wrap {
        let [start, end] = frame.end_normals(span).map(DVec3::try_normalize);
        let Some((start, end)) = start.or(end).zip(end.or(start)) else {
            return Wrap { ends: [DVec3::ZERO; 2], axis: DVec3::ZERO, follows: false };
        };
        let degrees = start.angle_between(end).to_degrees();
        if self.follows() && (degrees <= NARROW || (degrees <= WIDE && span.steps() >= MANY_STEPS)) {
            return Wrap { ends: [start, end], axis: start, follows: true };
        }
        let serves = |axis: &DVec3| axis.dot(start) > 0.0 && axis.dot(end) > 0.0;
        let face = match self.axis {
            WrapAxis::Face => Some(frame.mean_normal(span)).filter(serves),
            WrapAxis::Bisector | WrapAxis::Previous => None,
        };
        let bisector = || (start + end).try_normalize().filter(serves);
        let axis = face.or_else(bisector).unwrap_or_else(|| start.any_orthonormal_vector());
        Wrap { ends: [start, end], axis, follows: false }
    }
}
