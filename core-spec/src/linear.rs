//! What is linear in the pixel number, by start value and step.
use specula_datapath::Format;
use specula_scene::frame::Span;

use crate::core_input::{CoreInput, InputRole};
use crate::inputs::{InputGroup, inputs};

inputs! {
    /// Start value and step of what is linear in the pixel number.
    Linear {
        /// Value at the first pixel.
        start: one,
        /// What it grows by with each pixel; 0 in a span of one pixel.
        step: one,
    }
}

impl Linear<CoreInput> {
    /// The inputs of a cosine times a length up to 1: from -1 to 1 along the span.
    pub(crate) fn inputs(name: &str, format: Format) -> Linear<CoreInput> {
        let input = |part: &str, limit: f64| {
            CoreInput::between(InputRole::Surface, format!("{name}_{part}"), format, -limit, limit)
        };
        Linear { start: input("start", 1.0), step: input("step", 2.0) }
    }
}

impl Linear<f64> {
    /// c + b i, as far as the span is long enough to use it.
    pub(crate) fn new(span: &Span, c: f64, b: f64) -> Linear<f64> {
        Linear { start: c, step: if span.steps() > 0 { b } else { 0.0 } }
    }

    pub(crate) fn quantised(&self, format: Format) -> Linear<i64> {
        self.map_each(&mut |&x| format.quantise(x))
    }
}
