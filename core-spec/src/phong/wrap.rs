//! What the host wraps directions to places around [Hast, Barrera and Bengtsson, eq. 36 and 38;
//! methods C16 to C18].
use glam::DVec3;
use specula_scene::Wrap;
use specula_scene::frame::{EYE, Frame, LocalLight, Span};

/// The wrap of the directions from a span to a light: around the way back along a spot's axis, as
/// the paper has it, which leaves dark what is 90 degrees or more from it; around the bisector for
/// a light without an axis.
pub fn wrap_to_light(frame: &Frame, span: &Span, light: &LocalLight) -> Wrap {
    let ends = frame.end_vectors_to(span, light.position);
    match &light.spot {
        Some(spot) => Wrap::fixed(-spot.axis, ends),
        None => Wrap::around(None, ends),
    }
}

/// The wrap of the directions from a span to the eye, around the direction to an eye at infinity.
pub fn wrap_to_eye(frame: &Frame, span: &Span, eye: DVec3) -> Wrap {
    Wrap::around(Some(EYE), frame.end_vectors_to(span, eye))
}
