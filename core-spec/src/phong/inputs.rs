//! The inputs of a `phong` core.
use specula_datapath::Format;
use specula_scene::needs::LocalKind;

use super::{Highlight, PhongSpec, Places};
use crate::core_input::CoreInput;
use crate::core_input::InputRole::{self, Exponent, Light, Surface};
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;

inputs! {
    /// A vector that is interpolated along the span.
    Way {
        /// At the first pixel; H if it is wrapped.
        start: vector,
        /// What it changes by over the whole span.
        delta: vector,
        /// w; there if it is wrapped.
        axis: vector_if_any,
    }
}

inputs! {
    /// Inputs that the lights of a span have in common.
    PhongSpan {
        /// N0 and N1 - N0.
        normal: group(Way),
        /// 1/S, what the weight grows by with each pixel; 0 in a span of one pixel.
        weight_step: one,
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
        let largest = self.highlight.exponent_factor() * core.largest_shininess;
        let weight = self.formats.weight_accumulator;
        PhongSpan {
            normal: self.straight("normal"),
            weight_step: CoreInput::between(Surface, "weight_step", weight, 0.0, 1.0),
            shininess: whole_number(Exponent, "shininess", largest),
            eye: core.local_eye.then(|| self.way(Surface, "eye")),
        }
    }

    fn light_inputs(&self, core: &CoreParameters, index: usize) -> PhongLight<CoreInput> {
        let f = &self.formats;
        let kind =
            index.checked_sub(core.lights_at_infinity()).map(|local| core.local_lights[local]);
        let name = |part: &str| format!("light{index}_{part}");
        let vector = |part: &str| CoreInput::vector(Light, &name(part), f.vector, 1.0);
        let is_spot = matches!(kind, Some(LocalKind::Spot { .. }));
        let exponent = || whole_number(Light, &name("exponent"), core.largest_spot_exponent());
        let constant = kind.is_none() && !core.local_eye;
        PhongLight {
            direction: kind.is_none().then(|| vector("direction")),
            way: kind.is_some().then(|| self.way(Light, &name("way"))),
            axis: (is_spot && self.places == Places::Exact).then(|| vector("axis")),
            exponent: is_spot.then(exponent),
            light_dot_view: (constant && self.highlight == Highlight::Reflection)
                .then(|| CoreInput::between(Light, name("light_dot_view"), f.cosine, -1.0, 1.0)),
            halfway_gain: (constant && self.highlight != Highlight::Reflection)
                .then(|| CoreInput::whole(Light, name("halfway_gain"), f.gain)),
        }
    }
}

impl PhongSpec {
    /// A vector that is brought to unit length.
    fn straight(&self, name: &str) -> Way<CoreInput> {
        let (vector, sum) = (self.formats.vector, self.formats.vector_sum());
        Way {
            start: CoreInput::vector(Surface, &format!("{name}_start"), vector, 1.0),
            delta: CoreInput::vector(Surface, &format!("{name}_delta"), sum, 2.0),
            axis: None,
        }
    }

    /// A vector to a place; what it is wrapped around tells of `axis`, from span to span.
    fn way(&self, axis: InputRole, name: &str) -> Way<CoreInput> {
        let (vector, sum) = (self.formats.vector, self.formats.vector_sum());
        match self.places {
            Places::Exact => self.straight(name),
            Places::Wrapped => Way {
                start: CoreInput::vector(Surface, &format!("{name}_wrap_start"), sum, 2.0),
                delta: CoreInput::vector(Surface, &format!("{name}_wrap_delta"), sum, 2.0),
                axis: Some(
                    CoreInput::vector(axis, &format!("{name}_wrap_axis"), vector, 1.0)
                        .map(CoreInput::held_for_a_span),
                ),
            },
        }
    }
}

/// A number from 1 to `largest`.
fn whole_number(role: InputRole, name: &str, largest: u32) -> CoreInput {
    let format = Format::unsigned(u32::BITS - largest.leading_zeros(), 0);
    CoreInput::between(role, name, format, 1.0, f64::from(largest))
}
