//! The inputs of a `gouraud` core.
use specula_datapath::Format;

use super::{GouraudSpec, Highlight, Interpolation};
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, NoInputs, inputs};
use crate::parameters::CoreParameters;

inputs! {
    /// Inputs of one light.
    GouraudLight {
        /// max(N·L, 0).
        diffuse_intensity: group(Intensity),
        /// max(R·L, 0)^n, or f_k of R - L.
        specular_intensity: group(Intensity),
    }
}

inputs! {
    /// An intensity along a span.
    Intensity {
        /// At the first pixel, 0 to 1.
        start: one,
        /// What it grows by with each pixel, 0 in a span of one pixel; with linear interpolation
        /// only.
        step: one_if_any,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type GouraudInputs<T> = CoreInputs<NoInputs<T>, GouraudLight<T>, T>;

impl MethodInputs for GouraudSpec {
    type SpanGroup = NoInputs<CoreInput>;
    type LightGroup = GouraudLight<CoreInput>;

    fn span_inputs(&self, _core: &CoreParameters) -> NoInputs<CoreInput> {
        NoInputs::default()
    }

    fn light_inputs(&self, _core: &CoreParameters, index: usize) -> GouraudLight<CoreInput> {
        GouraudLight {
            diffuse_intensity: self
                .intensity("max(N.L, 0)", &format!("light{index}_diffuse_intensity")),
            specular_intensity: self
                .intensity(self.highlight_in_words(), &format!("light{index}_specular_intensity")),
        }
    }
}

impl GouraudSpec {
    fn highlight_in_words(&self) -> &'static str {
        match self.highlight {
            Highlight::Power => "max(R.L, 0)^n",
            Highlight::FK => "f_k of R - L",
        }
    }

    /// The inputs of a `value`, a formula, along a span.
    fn intensity(&self, value: &str, name: &str) -> Intensity<CoreInput> {
        let input = |meaning: InputMeaning, name: &str, format: Format, low: f64| {
            CoreInput::between(meaning, name, format, low, 1.0)
        };
        let of_vertices = format!("{value}, interpolated from the vertices',");
        let start = InputMeaning::at_first_pixel(&of_vertices);
        let of_polygon =
            InputMeaning::surface(format!("{value} of the polygon"), "the same at its middle");
        let accumulator = self.formats.accumulator;
        match self.interpolation {
            Interpolation::Linear => Intensity {
                start: input(start, &format!("{name}_start"), accumulator, 0.0),
                step: Some(input(
                    InputMeaning::step(&of_vertices),
                    &format!("{name}_step"),
                    accumulator,
                    -1.0,
                )),
            },
            Interpolation::Uniform => Intensity {
                start: input(of_polygon, name, self.formats.intensity, 0.0),
                step: None,
            },
        }
    }
}
