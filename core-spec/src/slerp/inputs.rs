//! The inputs of a `slerp` core.
use specula_datapath::Format;

use super::{Form, LARGEST_WEIGHT, SlerpSpec};
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::linear::Linear;
use crate::parameters::CoreParameters;
use crate::quadratic::Quadratic;
use crate::ways::{LightWay, VectorWay};

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
        /// N·V, of scalars; there for an eye at infinity, or if places are seen from the middle of
        /// spans.
        view: group_if_any(OnArc),
        /// The way to an eye at a place; there if places are seen from pixels.
        eye: group_if_any(EyeAlongArc),
        /// What a normal is put together from.
        normal: group_if_any(Axes),
        /// n, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    SlerpLight {
        /// N·L, of scalars; there without ways to places.
        light: group_if_any(OnArc),
        /// L, where there is a normal; there without ways to places.
        direction: vector_if_any,
        /// The way to the light; there if places are seen from pixels.
        way: group_if_any(LightAlongArc),
        /// L·V, without ways to places; 1 where the span has no normal, which leaves no highlight.
        light_dot_view: one_if_any,
    }
}

inputs! {
    /// A way X by its scalars, or by its components where there is a normal.
    WayAlongArc {
        /// A·X, of scalars.
        start: group_if_any(Linear),
        /// T·X, of scalars.
        across: group_if_any(Linear),
        /// X itself, where there is a normal.
        vector: group_if_any(VectorWay),
    }
}

inputs! {
    /// The way to an eye at a place.
    EyeAlongArc {
        /// What the normal makes of it.
        normal: group(WayAlongArc),
        /// E·E.
        squared: group(Quadratic),
    }
}

inputs! {
    /// The way to a light.
    LightAlongArc {
        /// What the normal makes of it.
        normal: group(WayAlongArc),
        /// The rest.
        way: group(LightWay),
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

/// What inputs of a span are, and how the host computes them; f is the angle between the unit
/// normals at the first and the last pixel.
const TURN_COSINE: (&str, &str) = (
    "by how much a pixel turns the normal, the cosine",
    "cos(f/(pixels - 1)); 1 for one pixel and where normals are interpolated linearly",
);
const TURN_SINE: (&str, &str) = (
    "by how much a pixel turns the normal, the sine",
    "sin(f/(pixels - 1)), 0 for one pixel; 1/(pixels - 1) where normals are interpolated linearly",
);
const TURN_BACK: (&str, &str) = (
    "the sine by which cosines turn",
    "sin(f/(pixels - 1)); 0 where normals are interpolated linearly",
);
const RISING_COSINE: (&str, &str) = (
    "the cosine beside the end's weight, at the first pixel",
    "1/sin f for f from 10 to 170 degrees, else 1",
);
const FALLING_COSINE: (&str, &str) = (
    "the cosine beside the start's weight, at the first pixel",
    "cos f/sin f for f from 10 to 170 degrees, 1 below and 0 above",
);
const START: (&str, &str) =
    ("A, the normal at the first pixel", "A is the unit normal at the first pixel");
const ACROSS: (&str, &str) = (
    "T, across A",
    "T is the unit vector perpendicular to A towards the last pixel's normal, 0 where that is A",
);
const END: (&str, &str) = (
    "B, the normal at the last pixel",
    "the unit normal at the last pixel; T from 170 degrees between the ends on",
);

/// Angles are 0 to 180 degrees, so no sine is negative.
impl MethodInputs for SlerpSpec {
    type SpanGroup = SlerpSpan<CoreInput>;
    type LightGroup = SlerpLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> SlerpSpan<CoreInput> {
        let (turn, state, ends) =
            (self.formats.turn, self.formats.scaled_state, self.between_ends());
        let number = |(what, computed), name: &str, format: Format, low: f64, high: f64| {
            CoreInput::between(InputMeaning::surface(what, computed), name, format, low, high)
        };
        let vector = |(what, computed), name: &str| {
            CoreInput::vector(
                &InputMeaning::surface(what, computed),
                name,
                self.formats.vector,
                1.0,
            )
        };
        let has_eye = self.places.follows_ways(core) && core.local_eye;
        SlerpSpan {
            turn_cosine: number(TURN_COSINE, "turn_cosine", turn, -1.0, 1.0),
            turn_sine: number(TURN_SINE, "turn_sine", turn, 0.0, 1.0),
            turn_back: ends.then(|| number(TURN_BACK, "turn_back", turn, 0.0, 1.0)),
            rising_cosine: ends
                .then(|| number(RISING_COSINE, "rising_cosine", state, 0.0, LARGEST_WEIGHT)),
            falling_cosine: ends.then(|| {
                number(FALLING_COSINE, "falling_cosine", state, -LARGEST_WEIGHT, LARGEST_WEIGHT)
            }),
            view: self.on_arc("V", "view").filter(|_| !has_eye),
            eye: has_eye.then(|| EyeAlongArc {
                normal: self.way_along_arc("E", "eye"),
                squared: Quadratic::squared_length_inputs(
                    "E.E",
                    "eye_squared",
                    self.formats.way_accumulator,
                ),
            }),
            normal: (self.form == Form::Vector).then(|| Axes {
                start: vector(START, "normal_start"),
                other: if ends {
                    vector(END, "normal_end")
                } else {
                    vector(ACROSS, "normal_across")
                },
            }),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> SlerpLight<CoreInput> {
        let name = |part: &str| format!("light{index}_{part}");
        if self.places.follows_ways(core) {
            return SlerpLight::of_way(LightAlongArc {
                normal: self.way_along_arc("X", &name("way")),
                way: LightWay::inputs(core, index, self.formats.way_accumulator),
            });
        }
        SlerpLight {
            light: self.on_arc("L", &format!("light{index}")),
            way: None,
            direction: (self.form == Form::Vector).then(|| {
                let meaning = InputMeaning::direction();
                CoreInput::vector(&meaning, &name("direction"), self.formats.vector, 1.0)
            }),
            // Spans without a normal have another one.
            light_dot_view: Some(
                self.component(InputMeaning::light_dot_view_of_spans(), &name("dot_view"))
                    .held_for_a_span(),
            ),
        }
    }
}

impl<T> SlerpLight<T> {
    /// A light of which nothing but the way is sent.
    pub(super) fn of_way(way: LightAlongArc<T>) -> SlerpLight<T> {
        SlerpLight { light: None, direction: None, way: Some(way), light_dot_view: None }
    }
}

impl SlerpSpec {
    /// The inputs of N.`x` along an arc.
    fn on_arc(&self, x: &str, name: &str) -> Option<OnArc<CoreInput>> {
        let component = |axis: &str, computed: &'static str, end: &str| {
            let meaning = InputMeaning::surface(format!("{axis}.{x}"), computed);
            self.component(meaning, &format!("{name}_{end}"))
        };
        (self.form == Form::Scalar).then(|| OnArc {
            start: component("A", START.1, "start"),
            across: component("T", ACROSS.1, "across"),
        })
    }

    /// The inputs of a way `x`.
    fn way_along_arc(&self, x: &str, name: &str) -> WayAlongArc<CoreInput> {
        let format = self.formats.way_accumulator;
        let scalar = |axis: &str, end: &str| {
            let scalar =
                || Linear::inputs(&format!("{axis}.{x}"), &format!("{name}_{end}"), format);
            (self.form == Form::Scalar).then(scalar)
        };
        WayAlongArc {
            start: scalar("A", "start"),
            across: scalar("T", "across"),
            vector: (self.form == Form::Vector).then(|| VectorWay::inputs(x, name, format)),
        }
    }

    fn component(&self, meaning: InputMeaning, name: &str) -> CoreInput {
        CoreInput::between(meaning, name, self.formats.component, -1.0, 1.0)
    }
}
