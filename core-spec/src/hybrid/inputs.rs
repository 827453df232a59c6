//! The inputs of a `hybrid` core.
use super::HybridSpec;
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::linear::Linear;
use crate::parameters::CoreParameters;
use crate::quadratic::{Quadratic, REFLECTED};
use crate::ways::{EyeCosine, LightCosine};

inputs! {
    /// Inputs that the lights of a span have in common.
    HybridSpan {
        /// q = N·N.
        denominator: group(Quadratic),
        /// N·V; there with ways to places.
        view: group_if_any(Linear),
        /// The way to an eye at a place; there if places are seen from pixels.
        eye: group_if_any(EyeCosine),
        /// n, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    HybridLight {
        /// p = 2(N·V)(N·L) - (L·V)(N·N); there without ways to places.
        numerator: group_if_any(Quadratic),
        /// The way to the light; there if places are seen from pixels.
        way: group_if_any(LightCosine),
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
        let f = &self.formats;
        let follows_ways = self.places.follows_ways(core);
        HybridSpan {
            denominator: Quadratic::squared_length_inputs(
                "N.N",
                "denominator",
                self.formats.accumulator,
            ),
            view: (follows_ways && !core.local_eye)
                .then(|| Linear::inputs("N.V", "view", f.accumulator)),
            eye: (follows_ways && core.local_eye).then(|| EyeCosine::inputs(f.accumulator)),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> HybridLight<CoreInput> {
        let f = &self.formats;
        let name = |part: &str| format!("light{index}_{part}");
        let intensity = |meaning: InputMeaning, part: &str, low: f64| {
            CoreInput::between(meaning, name(part), f.diffuse_accumulator, low, 1.0)
        };
        let value = "max(N.L, 0), interpolated from the vertices',";
        let [start, step] = [InputMeaning::at_first_pixel(value), InputMeaning::step(value)];
        let follows_ways = self.places.follows_ways(core);
        let numerator =
            || Quadratic::reflected_inputs(REFLECTED, &name("numerator"), f.accumulator);
        HybridLight {
            numerator: (!follows_ways).then(numerator),
            way: follows_ways.then(|| LightCosine::inputs(core, index, f.accumulator)),
            intensity_start: intensity(start, "intensity_start", 0.0),
            intensity_step: intensity(step, "intensity_step", -1.0),
        }
    }
}
