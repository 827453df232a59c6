//! What the host wraps normals around [Hast, Barrera and Bengtsson; methods C4 to C7].
use specula_scene::Wrap;
use specula_scene::frame::{Frame, Span};

use super::{LyonSpec, Normals, WrapAxis};

/// How the normals of a span are wrapped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalWrap {
    /// Their ends, and what they are wrapped around; the normal of the first pixel where they
    /// follow.
    pub wrap: Wrap,
    /// Whether each pixel but the first is wrapped around what the one before came to.
    pub follows: bool,
}

/// What it takes to follow: a wrapped normal lags behind by what it is short of N, which is little
/// in narrow spans and in those of many steps (numerics N2b).
const NARROW: f64 = 30.0;
const WIDE: f64 = 120.0;
const MANY_STEPS: u32 = 16;

impl LyonSpec {
    /// Whether normals are wrapped around those of the pixel before.
    pub fn follows(&self) -> bool {
        self.normals == Normals::Wrapped && self.axis == WrapAxis::Previous
    }

    /// The wrap of a span's normals.
    pub fn wrap(&self, frame: &Frame, span: &Span) -> NormalWrap {
        let preferred = match self.axis {
            WrapAxis::Face => Some(frame.facet_normal(span)),
            WrapAxis::Bisector | WrapAxis::Previous => None,
        };
        let wrap = Wrap::around(preferred, frame.end_normals(span));
        let [start, end] = wrap.ends;
        // Not a number where there is no normal, so that nothing follows.
        let degrees = start.angle_between(end).to_degrees();
        if self.follows() && (degrees <= NARROW || (degrees <= WIDE && span.steps() >= MANY_STEPS))
        {
            NormalWrap { wrap: Wrap { axis: start, ..wrap }, follows: true }
        } else {
            NormalWrap { wrap, follows: false }
        }
    }
}
