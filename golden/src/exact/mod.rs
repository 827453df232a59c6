//! Shading in f64, in LSBs of the 8-bit output, clamped to 0..=255 and not rounded.
//!
//! Directions are unit vectors in view space, and V = (0, 0, 1)
//! ([`EYE`](specula_scene::frame::EYE)).
mod coefficients;
pub mod consistent;
pub mod consistent_span;
pub mod differences;
pub mod diffuse;
pub mod direct;
mod direct_span;
mod directions;
pub mod distributions;
pub mod duff;
pub mod figure9;
pub mod gouraud;
pub mod hybrid;
pub mod illumination;
pub mod lyon;
mod method;
pub mod newton;
pub mod normalisation;
pub mod phong;
pub mod point_light;
pub mod quadratic;
pub mod reflection;
pub mod reflection_shading;
pub mod root_shininess;
pub mod shape;
pub mod slerp;
mod slerp_span;
pub mod specular;
pub mod wrap;

use specula_scene::{Frame, Span};
use specula_spec::CoreSpec;

pub use consistent_span::ConsistentSpan;
pub use duff::DuffSpan;

pub use direct_span::DirectSpan;
pub use gouraud::GouraudSpan;
pub use hybrid::HybridSpan;
pub use lyon::LyonSpan;
pub use method::MethodSpan;
pub use phong::PhongSpan;
pub use reflection_shading::ReflectionSpan;
pub use slerp_span::SlerpSpan;

/// True Phong shading of pixel `i` of a span, 0..=255 LSB a channel [methods A3, A5].
///
/// [`PhongSpan`] shades a whole span faster.
pub fn phong(frame: &Frame, span: &Span, i: u32) -> [f64; 3] {
    PhongSpan::new(frame, span).pixel(i)
}

/// The spec's method without rounding at pixel `i` of a span, 0..=255 LSB a channel.
///
/// It has the clamps of `docs/arithmetic.md` and inputs as they were before the host quantised
/// them. [`MethodSpan`] shades a whole span faster.
pub fn method(spec: &CoreSpec, frame: &Frame, span: &Span, i: u32) -> [f64; 3] {
    MethodSpan::new(spec, frame, span).pixel(i)
}
