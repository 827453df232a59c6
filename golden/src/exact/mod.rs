//! Shading in f64, in LSBs of the 8-bit output, clamped to 0..=255 and not rounded.
//!
//! Directions are unit vectors in view space, and V = (0, 0, 1)
//! ([`EYE`](specula_scene::frame::EYE)).
//!
//! [`formula`] has the papers' formulas, [`mod@method`] the shading methods made of them.
pub mod figure9;
pub mod formula;
pub mod method;

use specula_scene::{Frame, Span};
use specula_spec::CoreSpec;

pub use method::{
    ConsistentSpan, DirectSpan, DuffSpan, GouraudSpan, HybridSpan, LyonSpan, MethodSpan, PhongSpan,
    ReflectionSpan, SlerpSpan,
};

/// Exact Phong shading of pixel `i` of a span, 0..=255 LSB a channel [methods A3, A5].
///
/// [`PhongSpan`] shades a whole span faster.
pub fn phong(frame: &Frame, span: &Span, i: u32) -> [f64; 3] {
    PhongSpan::new(frame, span).pixel(i)
}

/// The spec's method without rounding at pixel `i` of a span, 0..=255 LSB a channel.
///
/// It has the clamps of `docs/arithmetic.md`, and uses inputs before the host quantises them.
/// [`MethodSpan`] shades a whole span faster.
pub fn method(spec: &CoreSpec, frame: &Frame, span: &Span, i: u32) -> [f64; 3] {
    MethodSpan::new(spec, frame, span).pixel(i)
}
