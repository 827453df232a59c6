//! The inputs of a `consistent` core.
use super::{ConsistentSpec, Highlight};
use crate::core_input::CoreInput;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;
use crate::ways::{VectorLight, VectorWay};

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
        /// The way to an eye at a place; there if places are seen from pixels.
        eye: group_if_any(VectorWay),
        /// n, or its logarithm.
        exponent: one,
    }
}

inputs! {
    /// Inputs of one light.
    ConsistentLight {
        /// L; there without ways to places.
        direction: vector_if_any,
        /// The way to the light; there if places are seen from pixels.
        way: group_if_any(VectorLight),
        /// H = (L + V)/|L + V|; there with Blinn's highlight only, without ways to places.
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
        let angle = |meaning: InputMeaning, name: &str, low: f64, high: f64| {
            CoreInput::between(
                meaning.in_unit("quarter turns"),
                name,
                f.angle_accumulator,
                low,
                high,
            )
        };
        let [normal_start, normal_delta] = InputMeaning::along_span(
            "the axis N of the normals' cone",
            "axes of the vertices' cones interpolated at the pixel's centre; those of both ends \
             scaled by one factor so that the longer has length 1",
        );
        let angle_start = InputMeaning::surface(
            "the cone's angle t at the first pixel",
            "the vertices' t interpolated at the pixel's centre, rounded up",
        );
        let angle_step = InputMeaning::surface(
            "what t grows by with each pixel",
            "(last pixel's t - first pixel's t)/(pixels - 1), 0 for one pixel, rounded up",
        );
        ConsistentSpan {
            normal_start: CoreInput::vector(&normal_start, "normal_start", f.vector, 1.0),
            normal_delta: CoreInput::vector(&normal_delta, "normal_delta", f.vector_sum(), 2.0),
            weight_step: CoreInput::between(
                InputMeaning::weight_step(),
                "weight_step",
                f.weight_accumulator,
                0.0,
                1.0,
            ),
            angle_start: angle(
                angle_start,
                "angle_start",
                0.0,
                LARGEST_ANGLE + f.angle_accumulator.ulp(),
            ),
            angle_step: angle(angle_step, "angle_step", -LARGEST_ANGLE, LARGEST_ANGLE),
            eye: (self.places.follows_ways(core) && core.local_eye)
                .then(|| VectorWay::inputs("E", "eye", f.way_accumulator)),
            exponent: self.power_unit().exponent_input(core),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> ConsistentLight<CoreInput> {
        let vector = |meaning: &InputMeaning, part: &str| {
            CoreInput::vector(meaning, &format!("light{index}_{part}"), self.formats.vector, 1.0)
        };
        let halfway = || vector(&InputMeaning::unit_halfway(), "halfway");
        let follows_ways = self.places.follows_ways(core);
        let f = &self.formats;
        ConsistentLight {
            direction: (!follows_ways).then(|| vector(&InputMeaning::direction(), "direction")),
            way: follows_ways
                .then(|| VectorLight::inputs(core, index, f.way_accumulator, f.vector)),
            halfway: (self.highlight == Highlight::Blinn && !follows_ways).then(halfway),
        }
    }
}
