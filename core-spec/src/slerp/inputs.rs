//! The inputs of a `slerp` core.
use specula_datapath::Format;

use super::{Form, LARGEST_WEIGHT, SlerpSpec};
use crate::core_input::CoreInput;
use crate::core_input::InputRole::{self, Light, Surface};
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;

inputs! {
    /// Inputs that the lights of a span have in common.
    SlerpSpan {
        /// cos(f/S); 1 in a span of one pixel, and where normals are interpolated linearly.
        turn_cosine: one,
        /// sin(f/S); 0 in a span of one pixel, and 1/S where normals are interpolated linearly.
        turn_sine: one,
        /// The sine by which cosines turn, between the ends themselves: the same, or 0 where
        /// normals are interpolated linearly.
        turn_back: one_if_any,
        /// The cosine that goes with the weight of the end, at the first pixel, between the ends
        /// themselves.
        rising_cosine: one_if_any,
        /// The cosine that goes with the weight of the start, at the first pixel, between the ends
        /// themselves.
        falling_cosine: one_if_any,
        /// N·V, of scalars.
        view: group_if_any(OnArc),
        /// What a normal is put together from.
        normal: group_if_any(Axes),
        /// n, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    SlerpLight {
        /// N·L, of scalars.
        light: group_if_any(OnArc),
        /// L, where there is a normal.
        direction: vector_if_any,
        /// L·V; 1 where the span has no normal, which leaves no highlight.
        light_dot_view: one,
    }
}

inputs! {
    /// N·X along an arc.
    OnArc {
        /// A·X.
        start: one,
        /// T·X.
        across: one,
    }
}

inputs! {
    /// What a normal is put together from.
    Axes {
        /// A.
        start: vector,
        /// T, or B.
        other: vector,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type SlerpInputs<T> = CoreInputs<SlerpSpan<T>, SlerpLight<T>, T>;

/// Angles are 0 to 180 degrees, so no sine is negative.
impl MethodInputs for SlerpSpec {
    type SpanGroup = SlerpSpan<CoreInput>;
    type LightGroup = SlerpLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> SlerpSpan<CoreInput> {
        let (turn, state, ends) =
            (self.formats.turn, self.formats.scaled_state, self.between_ends());
        let number = |name: &str, format: Format, low: f64, high: f64| {
            CoreInput::between(Surface, name, format, low, high)
        };
        let vector = |name: &str| CoreInput::vector(Surface, name, self.formats.vector, 1.0);
        SlerpSpan {
            turn_cosine: number("turn_cosine", turn, -1.0, 1.0),
            turn_sine: number("turn_sine", turn, 0.0, 1.0),
            turn_back: ends.then(|| number("turn_back", turn, 0.0, 1.0)),
            rising_cosine: ends.then(|| number("rising_cosine", state, 0.0, LARGEST_WEIGHT)),
            falling_cosine: ends
                .then(|| number("falling_cosine", state, -LARGEST_WEIGHT, LARGEST_WEIGHT)),
            view: self.on_arc("view"),
            normal: (self.form == Form::Vector).then(|| Axes {
                start: vector("normal_start"),
                other: vector(if ends { "normal_end" } else { "normal_across" }),
            }),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, _core: &CoreParameters, index: usize) -> SlerpLight<CoreInput> {
        let name = |part: &str| format!("light{index}_{part}");
        SlerpLight {
            light: self.on_arc(&format!("light{index}")),
            direction: (self.form == Form::Vector)
                .then(|| CoreInput::vector(Light, &name("direction"), self.formats.vector, 1.0)),
            // Spans without a normal have another one.
            light_dot_view: self.component(Light, &name("dot_view")).held_for_a_span(),
        }
    }
}

impl SlerpSpec {
    fn on_arc(&self, name: &str) -> Option<OnArc<CoreInput>> {
        let component = |end: &str| self.component(Surface, &format!("{name}_{end}"));
        (self.form == Form::Scalar)
            .then(|| OnArc { start: component("start"), across: component("across") })
    }

    fn component(&self, role: InputRole, name: &str) -> CoreInput {
        CoreInput::between(role, name, self.formats.component, -1.0, 1.0)
    }
}
