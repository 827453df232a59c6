//! Unit vectors along a span without a root: what they are wrapped around [Hast, Barrera and
//! Bengtsson, eq. 27, 28 and 36 to 38; methods C4 to C7, C16 to C18].
use glam::DVec3;

use crate::frame::{EYE, Frame, LocalLight, Span};

/// The ends of a span of wrapped vectors, and what they are wrapped around.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrap {
    /// Unit vectors at the first and the last pixel.
    pub ends: [DVec3; 2],
    /// The unit vector w, within 90 degrees of both unless it was [`Wrap::fixed`].
    pub axis: DVec3,
}

impl Wrap {
    /// Vectors at the ends, of any length, wrapped around `preferred`. A vector of length 0 is
    /// taken from the other end; where both are, everything is 0.
    ///
    /// An axis that is 90 degrees or more from an end gives way to the bisector (extremes row 8),
    /// and the bisector of opposite ends to a vector across them (row 7).
    pub fn around(preferred: Option<DVec3>, ends: [DVec3; 2]) -> Wrap {
        Wrap::of_ends(ends, |start, end| {
            let serves = |axis: &DVec3| axis.dot(start) > 0.0 && axis.dot(end) > 0.0;
            let bisector = || (start + end).try_normalize().filter(serves);
            preferred
                .filter(serves)
                .or_else(bisector)
                .unwrap_or_else(|| start.any_orthonormal_vector())
        })
    }

    /// As [`Wrap::around`], whatever the angle between `axis` and the ends.
    pub fn fixed(axis: DVec3, ends: [DVec3; 2]) -> Wrap {
        Wrap::of_ends(ends, |_, _| axis)
    }

    /// The directions from a span to a light: around the way back along a spot's axis, as the paper
    /// has it, which leaves dark what is 90 degrees or more from it; around the bisector for a light
    /// without an axis.
    pub fn to_light(frame: &Frame, span: &Span, light: &LocalLight) -> Wrap {
        let ends = frame.end_vectors_to(span, light.position);
        match &light.spot {
            Some(spot) => Wrap::fixed(-spot.axis, ends),
            None => Wrap::around(None, ends),
        }
    }

    /// The directions from a span to the eye, around the direction to an eye at infinity.
    pub fn to_eye(frame: &Frame, span: &Span, eye: DVec3) -> Wrap {
        Wrap::around(Some(EYE), frame.end_vectors_to(span, eye))
    }

    /// The vector to be wrapped at the parameter `t` of the span, 0 to 1: no longer than 1.
    pub fn chord(&self, t: f64) -> DVec3 {
        self.ends[0].lerp(self.ends[1], t)
    }

    fn of_ends(ends: [DVec3; 2], axis: impl FnOnce(DVec3, DVec3) -> DVec3) -> Wrap {
        let [start, end] = ends.map(DVec3::try_normalize);
        match start.or(end).zip(end.or(start)) {
            Some((start, end)) => Wrap { ends: [start, end], axis: axis(start, end) },
            None => Wrap { ends: [DVec3::ZERO; 2], axis: DVec3::ZERO },
        }
    }
}
