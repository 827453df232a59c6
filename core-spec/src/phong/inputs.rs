//! The inputs of a `phong` core.
use specula_scene::needs::LocalKind;

use super::{Highlight, PhongSpec, Places};
use crate::core_input::CoreInput;
use crate::core_input::InputRole::{self, Exponent, Light, Surface};
use crate::increments::Increments;
use crate::input_meaning::InputMeaning;
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;
use crate::ways::{spot_axis, spot_exponent};

inputs! {
    /// A vector that is interpolated along the span.
    Way {
        /// At the first pixel; H if it is wrapped.
        start: vector,
        /// What it changes by: over the whole span, or with each pixel where increments are added.
        delta: vector,
        /// w; there if it is wrapped.
        axis: vector_if_any,
    }
}

inputs! {
    /// Inputs that the lights of a span have in common.
    PhongSpan {
        /// N0, and N1 - N0 or a share of that.
        normal: group(Way),
        /// 1/S, what the weight grows by with each pixel; 0 in a span of one pixel. Not there where
        /// increments are added.
        weight_step: one_if_any,
        /// n, or 4n for Blinn's lobe.
        shininess: one,
        /// To the eye; there if that is at a place.
        eye: group_if_any(Way),
    }
}

inputs! {
    /// Inputs of one light.
    PhongLight {
        /// L; there for a light at infinity.
        direction: vector_if_any,
        /// To the light; there for a light at a place.
        way: group_if_any(Way),
        /// The spot's axis; there for a spot whose direction is not wrapped around it.
        axis: vector_if_any,
        /// The spot's exponent.
        exponent: one_if_any,
        /// V·L; there where light and eye are at infinity.
        light_dot_view: one_if_any,
        /// 1/|L + V|; there where light and eye are at infinity and the highlight is in the angle
        /// to H*.
        halfway_gain: one_if_any,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type PhongInputs<T> = CoreInputs<PhongSpan<T>, PhongLight<T>, T>;

impl MethodInputs for PhongSpec {
    type SpanGroup = PhongSpan<CoreInput>;
    type LightGroup = PhongLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> PhongSpan<CoreInput> {
        let factor = self.highlight.exponent_factor();
        let largest = factor * core.largest_shininess;
        let weight = self.formats.weight_accumulator;
        let exponent = InputMeaning::of(
            Exponent,
            "the highlight's exponent",
            format!("{factor} times the material's n"),
        );
        let weight_step =
            || CoreInput::between(InputMeaning::weight_step(), "weight_step", weight, 0.0, 1.0);
        let normal = InputMeaning::normal_along_span();
        PhongSpan {
            normal: self.along(("the normal N", normal), "normal", 1.0),
            weight_step: (self.increments == Increments::Multiplied).then(weight_step),
            shininess: CoreInput::whole_number(exponent, "shininess", largest),
            eye: core.local_eye.then(|| self.way(&TO_EYE, "eye")),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> PhongLight<CoreInput> {
        let f = &self.formats;
        let kind =
            index.checked_sub(core.lights_at_infinity()).map(|local| core.local_lights[local]);
        let name = |part: &str| format!("light{index}_{part}");
        let vector = |meaning: &InputMeaning, part: &str| {
            CoreInput::vector(meaning, &name(part), f.vector, 1.0)
        };
        let is_spot = matches!(kind, Some(LocalKind::Spot { .. }));
        let exponent = || spot_exponent(core, &name("exponent"));
        let dot_view = InputMeaning::light_dot_view();
        let gain = InputMeaning::light("1/|L + V|", "with V = (0, 0, 1); saturated where L = -V");
        let constant = kind.is_none() && !core.local_eye;
        PhongLight {
            direction: kind.is_none().then(|| vector(&InputMeaning::direction(), "direction")),
            way: kind.is_some().then(|| self.way(&TO_LIGHT, &name("way"))),
            axis: (is_spot && self.places == Places::Exact)
                .then(|| spot_axis(&name("axis"), f.vector)),
            exponent: is_spot.then(exponent),
            light_dot_view: (constant && self.highlight == Highlight::Reflection)
                .then(|| CoreInput::between(dot_view, name("light_dot_view"), f.cosine, -1.0, 1.0)),
            halfway_gain: (constant && self.highlight != Highlight::Reflection)
                .then(|| CoreInput::whole(gain, name("halfway_gain"), f.gain)),
        }
    }
}

/// The place of a light or of the eye.
struct Place {
    /// What tells where it is, besides the surface.
    role: InputRole,
    /// The vector to it, in words.
    vector: &'static str,
    /// What that is wrapped around, and how the host computes it.
    axis: &'static str,
}

const TO_EYE: Place = Place {
    role: Surface,
    vector: "the vector to the eye",
    axis: "(0, 0, 1); the unit bisector of the ends' where that is 90 degrees or more from one",
};
const TO_LIGHT: Place = Place {
    role: Light,
    vector: "the vector to the light",
    axis: "against a spot's axis; for other lights the unit bisector of the ends'",
};

impl PhongSpec {
    /// The vector called `value` along the span, no longer than `longest`.
    fn along(
        &self,
        (value, [start, delta]): (&str, [InputMeaning; 2]),
        name: &str,
        longest: f64,
    ) -> Way<CoreInput> {
        let vectors = self.span_vectors();
        Way {
            start: vectors.start(&start, &format!("{name}_start"), longest),
            delta: vectors.change(value, &delta, name),
            axis: None,
        }
    }

    /// A vector to a place.
    fn way(&self, place: &Place, name: &str) -> Way<CoreInput> {
        match self.places {
            Places::Exact => {
                let meanings = InputMeaning::along_span(
                    place.vector,
                    "from the surface to the place; those of both ends scaled by one factor so \
                     that the longer has length 1",
                );
                self.along((place.vector, meanings), name, 1.0)
            }
            Places::Wrapped => {
                let value = format!("{}, of unit length, plus w,", place.vector);
                let meanings = InputMeaning::along_span(&value, "from the surface to the place");
                let axis = InputMeaning::of(
                    place.role,
                    format!("w, what {} is wrapped around", place.vector),
                    place.axis,
                );
                let vector = self.formats.vector;
                let axis = CoreInput::vector(&axis, &format!("{name}_wrap_axis"), vector, 1.0);
                Way {
                    axis: Some(axis.map(CoreInput::held_for_a_span)),
                    ..self.along((&value, meanings), &format!("{name}_wrap"), 2.0)
                }
            }
        }
    }
}
