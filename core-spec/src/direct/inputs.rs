//! The inputs of a `direct` core.
use super::DirectSpec;
use crate::core_input::CoreInput;
use crate::increments::Increments;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::linear::Linear;
use crate::parameters::CoreParameters;
use crate::ways::{EyeCosine, LightCosine};

inputs! {
    /// Inputs that the lights of a span have in common.
    DirectSpan {
        /// 1/S, what t grows by with each pixel; 0 in a span of one pixel.
        weight_step: one,
        /// κ = |B - A|².
        spread: one,
        /// N·V; there for an eye at infinity, or if places are seen from the middle of spans.
        view: group_if_any(Ends),
        /// The way to an eye at a place; there if places are seen from pixels.
        eye: group_if_any(EyeCosine),
        /// n, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    DirectLight {
        /// N·L; there without ways to places.
        light: group_if_any(Ends),
        /// The way to the light; there if places are seen from pixels.
        way: group_if_any(LightCosine),
        /// L·V, without ways to places; 1 where the span has no normal, which leaves no highlight.
        light_dot_view: one_if_any,
    }
}

inputs! {
    /// What is linear in t.
    Ends {
        /// At t = 0.
        start: one,
        /// At t = 1 less that at t = 0, or what it grows by with each pixel where increments are
        /// added.
        change: one,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type DirectInputs<T> = CoreInputs<DirectSpan<T>, DirectLight<T>, T>;

impl MethodInputs for DirectSpec {
    type SpanGroup = DirectSpan<CoreInput>;
    type LightGroup = DirectLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> DirectSpan<CoreInput> {
        let f = &self.formats;
        let weight = f.weight_accumulator;
        let weight_step = InputMeaning::weight_step();
        let spread = InputMeaning::surface(
            "how far the ends' normals are apart",
            "|B - A|^2 of the unit normals A and B at the first and the last pixel",
        );
        let has_eye = self.places.follows_ways(core) && core.local_eye;
        DirectSpan {
            weight_step: CoreInput::between(weight_step, "weight_step", weight, 0.0, 1.0),
            spread: CoreInput::between(spread, "spread", f.spread, 0.0, 4.0),
            view: (!has_eye).then(|| self.ends("N.V", "view")),
            eye: has_eye.then(|| EyeCosine::inputs(f.way_accumulator)),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> DirectLight<CoreInput> {
        let (dot_view, component) = (format!("light{index}_dot_view"), self.formats.component);
        // Spans without a normal have another one.
        let of_spans = || {
            let meaning = InputMeaning::light_dot_view_of_spans();
            CoreInput::between(meaning, dot_view, component, -1.0, 1.0).held_for_a_span()
        };
        let follows_ways = self.places.follows_ways(core);
        let format = self.formats.way_accumulator;
        DirectLight {
            light: (!follows_ways).then(|| self.ends("N.L", &format!("light{index}"))),
            way: follows_ways.then(|| LightCosine::inputs(core, index, format)),
            light_dot_view: (!follows_ways).then(of_spans),
        }
    }
}

impl DirectSpec {
    /// The inputs of a `value` that is linear along the span.
    fn ends(&self, value: &str, name: &str) -> Ends<CoreInput> {
        match self.increments {
            Increments::Multiplied => self.whole_change(value, name),
            Increments::Added => {
                let Linear { start, step } =
                    Linear::inputs(value, name, self.formats.scalar_accumulator);
                Ends { start, change: step }
            }
        }
    }

    fn whole_change(&self, value: &str, name: &str) -> Ends<CoreInput> {
        let (component, sum) = (self.formats.component, self.formats.component_sum());
        let [start, delta] = InputMeaning::along_span(
            value,
            "with N the unit normal at the pixel, interpolated from the vertices'",
        );
        Ends {
            start: CoreInput::between(start, format!("{name}_start"), component, -1.0, 1.0),
            change: CoreInput::between(delta, format!("{name}_delta"), sum, -2.0, 2.0),
        }
    }
}
