//! The inputs of a `consistent` core.
use super::{ConsistentSpec, Highlight};
use crate::core_input::CoreInput;
use crate::core_input::InputRole::{Light, Surface};
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;

/// t at a vertex is 1.06097 at most, which is 1.06097 quarter turns with the trigonometric curve
/// and less with the rational one.
pub const LARGEST_ANGLE: f64 = 1.0625;

inputs! {
    /// Inputs that the lights of a span have in common.
    ConsistentSpan {
        /// N0, the normal at the first pixel.
        normal_start: vector,
        /// N1 - N0, over the whole span.
        normal_delta: vector,
        /// 1/S, what the weight grows by with each pixel; 0 in a span of one pixel.
        weight_step: one,
        /// t at the first pixel.
        angle_start: one,
        /// What t grows by with each pixel; next to 0 in a span of one pixel.
        angle_step: one,
        /// n, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    ConsistentLight {
        /// L.
        direction: vector,
        /// H = (L + V)/|L + V|; there with Blinn's highlight only.
        halfway: vector_if_any,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type ConsistentInputs<T> = CoreInputs<ConsistentSpan<T>, ConsistentLight<T>, T>;

impl MethodInputs for ConsistentSpec {
    type SpanGroup = ConsistentSpan<CoreInput>;
    type LightGroup = ConsistentLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> ConsistentSpan<CoreInput> {
        let f = &self.formats;
        let angle = |name: &str, low: f64, high: f64| {
            CoreInput::between(Surface, name, f.angle_accumulator, low, high)
        };
        ConsistentSpan {
            normal_start: CoreInput::vector(Surface, "normal_start", f.vector, 1.0),
            normal_delta: CoreInput::vector(Surface, "normal_delta", f.vector_sum(), 2.0),
            weight_step: CoreInput::between(Surface, "weight_step", f.weight_accumulator, 0.0, 1.0),
            angle_start: angle("angle_start", 0.0, LARGEST_ANGLE + f.angle_accumulator.ulp()),
            angle_step: angle("angle_step", -LARGEST_ANGLE, LARGEST_ANGLE),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, _core: &CoreParameters, index: usize) -> ConsistentLight<CoreInput> {
        let vector = |part: &str| {
            CoreInput::vector(Light, &format!("light{index}_{part}"), self.formats.vector, 1.0)
        };
        ConsistentLight {
            direction: vector("direction"),
            halfway: (self.highlight == Highlight::Blinn).then(|| vector("halfway")),
        }
    }
}
