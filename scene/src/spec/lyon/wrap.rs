//! What the host wraps normals around [Hast, Barrera and Bengtsson; METHODS.md C4 to C7].
use super::{LyonSpec, WrapAxis};
use crate::frame::{Frame, Span};
use crate::spec::Wrap;

impl LyonSpec {
    /// The wrap of a span's normals.
    pub fn wrap(&self, frame: &Frame, span: &Span) -> Wrap {
        let preferred = match self.axis {
            WrapAxis::Face => Some(frame.mean_normal(span)),
            WrapAxis::Bisector => None,
        };
        Wrap::around(preferred, frame.end_normals(span))
    }
}
