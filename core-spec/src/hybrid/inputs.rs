//! The inputs of a `hybrid` core.
use super::HybridSpec;
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;
use crate::quadratic::{Quadratic, REFLECTED};

inputs! {
    /// Inputs that the lights of a span have in common.
    HybridSpan {
        /// q = N·N.
        denominator: group(Quadratic),
        /// n, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    HybridLight {
        /// p = 2(N·V)(N·L) - (L·V)(N·N).
        numerator: group(Quadratic),
        /// Gouraud's intensity at the first pixel.
        intensity_start: one,
        /// What it grows by with each pixel; 0 in a span of one pixel.
        intensity_step: one,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type HybridInputs<T> = CoreInputs<HybridSpan<T>, HybridLight<T>, T>;

/// With |N| ≤ 1 along the span, |p| ≤ q ≤ 1.
impl MethodInputs for HybridSpec {
    type SpanGroup = HybridSpan<CoreInput>;
    type LightGroup = HybridLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> HybridSpan<CoreInput> {
        HybridSpan {
            denominator: Quadratic::squared_length_inputs(
                "N.N",
                "denominator",
                self.formats.accumulator,
            ),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, _core: &CoreParameters, index: usize) -> HybridLight<CoreInput> {
        let f = &self.formats;
        let name = |part: &str| format!("light{index}_{part}");
        let intensity = |meaning: InputMeaning, part: &str, low: f64| {
            CoreInput::between(meaning, name(part), f.diffuse_accumulator, low, 1.0)
        };
        let value = "max(N.L, 0), interpolated from the vertices',";
        let [start, step] = [InputMeaning::at_first_pixel(value), InputMeaning::step(value)];
        HybridLight {
            numerator: Quadratic::reflected_inputs(REFLECTED, &name("numerator"), f.accumulator),
            intensity_start: intensity(start, "intensity_start", 0.0),
            intensity_step: intensity(step, "intensity_step", -1.0),
        }
    }
}
