//! What is linear in the pixel number, by start value and step.
use specula_datapath::Format;
use specula_scene::frame::Span;

use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
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
    ///
    /// `value` is the formula of what is linear, such as `N.L`.
    pub(crate) fn inputs(value: &str, name: &str, format: Format) -> Linear<CoreInput> {
        let input = |meaning: InputMeaning, part: &str, limit: f64| {
            CoreInput::between(meaning, format!("{name}_{part}"), format, -limit, limit)
        };
        let [start, step] = [InputMeaning::at_first_pixel(value), InputMeaning::step(value)];
        Linear { start: input(start, "start", 1.0), step: input(step, "step", 2.0) }
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
