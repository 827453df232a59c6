//! The method that a spec names.
use specula_scene::spec::MethodSpec;
use specula_scene::{CoreSpec, Frame, Span};

use super::{HybridSpan, LyonSpan};

/// One span, shaded by a spec's method.
pub enum MethodSpan<'a> {
    /// By [`MethodSpec::Lyon`].
    Lyon(LyonSpan<'a>),
    /// By [`MethodSpec::Hybrid`].
    Hybrid(HybridSpan<'a>),
}

impl<'a> MethodSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &'a CoreSpec, frame: &'a Frame, span: &'a Span) -> Self {
        match &spec.method {
            MethodSpec::Lyon(lyon) => MethodSpan::Lyon(LyonSpan::new(lyon, frame, span)),
            MethodSpec::Hybrid(_) => MethodSpan::Hybrid(HybridSpan::new(frame, span)),
        }
    }

    /// Pixel `i`, 0 to length - 1: 0..=255 LSB a channel.
    pub fn pixel(&self, i: u32) -> [f64; 3] {
        match self {
            MethodSpan::Lyon(lyon) => lyon.pixel(i),
            MethodSpan::Hybrid(hybrid) => hybrid.pixel(i),
        }
    }
}
