//! The inputs of a `phong` core.
use specula_datapath::Format;
use specula_scene::needs::LocalKind;

use super::{Highlight, PhongSpec, Places};
use crate::inputs::inputs;
use crate::{CoreSpec, InputPort};

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
    /// The core's inputs, or whatever belongs to each of them.
    PhongInputs {
        /// N0 and N1 - N0.
        normal: group(Way),
        /// 1/S, what the weight grows by with each pixel; 0 in a span of one pixel.
        weight_step: one,
        /// n, or 4n for Blinn's lobe.
        shininess: one,
        /// To the eye; there if that is at a place.
        eye: group_if_any(Way),
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light, those at infinity first.
        lights: many(PhongLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
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
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

impl PhongSpec {
    /// The ports of a core with this method.
    pub fn inputs(&self, core: &CoreSpec) -> PhongInputs<InputPort> {
        let largest = self.highlight.exponent_factor() * core.largest_shininess;
        let (integer, f) = (Format::unsigned(bits(largest), 0), &self.formats);
        let at_infinity = core.lights - core.local_lights.len();
        let kinds = (0..core.lights)
            .map(|i| i.checked_sub(at_infinity).map(|local| core.local_lights[local]));
        let whole = PhongInputs {
            normal: self.straight("normal"),
            weight_step: InputPort::between("weight_step", f.weight_accumulator, 0.0, 1.0),
            shininess: InputPort::between("shininess", integer, 1.0, f64::from(largest)),
            eye: core.local_eye.then(|| self.way("eye")),
            ambient: core.colour_ports("ambient"),
            lights: kinds.enumerate().map(|(i, kind)| self.light_inputs(core, i, kind)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    /// A vector that is brought to unit length.
    fn straight(&self, name: &str) -> Way<InputPort> {
        Way {
            start: InputPort::vector(&format!("{name}_start"), self.formats.vector, 1.0),
            delta: InputPort::vector(&format!("{name}_delta"), self.formats.vector_sum(), 2.0),
            axis: None,
        }
    }

    /// A vector to a place.
    fn way(&self, name: &str) -> Way<InputPort> {
        match self.places {
            Places::Exact => self.straight(name),
            Places::Wrapped => Way {
                start: InputPort::vector(
                    &format!("{name}_wrap_start"),
                    self.formats.vector_sum(),
                    2.0,
                ),
                delta: InputPort::vector(
                    &format!("{name}_wrap_delta"),
                    self.formats.vector_sum(),
                    2.0,
                ),
                axis: Some(InputPort::vector(
                    &format!("{name}_wrap_axis"),
                    self.formats.vector,
                    1.0,
                )),
            },
        }
    }

    fn light_inputs(
        &self,
        core: &CoreSpec,
        index: usize,
        kind: Option<LocalKind>,
    ) -> PhongLight<InputPort> {
        let f = &self.formats;
        let name = |part: &str| format!("light{index}_{part}");
        let vector = |part: &str| InputPort::vector(&name(part), f.vector, 1.0);
        let is_spot = matches!(kind, Some(LocalKind::Spot { .. }));
        let largest = core.largest_spot_exponent();
        let exponent = || {
            InputPort::between(
                name("exponent"),
                Format::unsigned(bits(largest), 0),
                1.0,
                f64::from(largest),
            )
        };
        let constant = kind.is_none() && !core.local_eye;
        PhongLight {
            direction: kind.is_none().then(|| vector("direction")),
            way: kind.is_some().then(|| self.way(&name("way"))),
            axis: (is_spot && self.places == Places::Exact).then(|| vector("axis")),
            exponent: is_spot.then(exponent),
            light_dot_view: (constant && self.highlight == Highlight::Reflection)
                .then(|| InputPort::between(name("light_dot_view"), f.cosine, -1.0, 1.0)),
            halfway_gain: (constant && self.highlight != Highlight::Reflection)
                .then(|| InputPort::whole(name("halfway_gain"), f.gain)),
            diffuse: core.colour_ports(&name("diffuse")),
            specular: core.colour_ports(&name("specular")),
        }
    }
}

/// Bits of a whole number.
fn bits(largest: u32) -> u32 {
    u32::BITS - largest.leading_zeros()
}
