//! The inputs of a `slerp` core.
use super::{Form, LARGEST_WEIGHT, SlerpSpec};
use crate::inputs::inputs;
use crate::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    SlerpInputs {
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
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light.
        lights: many(SlerpLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
    SlerpLight {
        /// N·L, of scalars.
        light: group_if_any(OnArc),
        /// L, where there is a normal.
        direction: vector_if_any,
        /// L·V; 1 where the span has no normal, which leaves no highlight.
        light_dot_view: one,
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
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

impl SlerpSpec {
    /// The ports of a core with this method. Angles are 0 to 180 degrees, so no sine is negative.
    pub fn inputs(&self, core: &CoreSpec) -> SlerpInputs<InputPort> {
        let (turn, state, ends) =
            (self.formats.turn, self.formats.scaled_state, self.between_ends());
        let vector = |name: &str| InputPort::vector(name, self.formats.vector, 1.0);
        let whole = SlerpInputs {
            turn_cosine: InputPort::between("turn_cosine", turn, -1.0, 1.0),
            turn_sine: InputPort::between("turn_sine", turn, 0.0, 1.0),
            turn_back: ends.then(|| InputPort::between("turn_back", turn, 0.0, 1.0)),
            rising_cosine: ends
                .then(|| InputPort::between("rising_cosine", state, 0.0, LARGEST_WEIGHT)),
            falling_cosine: ends.then(|| {
                InputPort::between("falling_cosine", state, -LARGEST_WEIGHT, LARGEST_WEIGHT)
            }),
            view: self.on_arc("view"),
            normal: (self.form == Form::Vector).then(|| Axes {
                start: vector("normal_start"),
                other: vector(if ends { "normal_end" } else { "normal_across" }),
            }),
            exponent: self.power_unit().port(core),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> SlerpLight<InputPort> {
        SlerpLight {
            light: self.on_arc(&format!("light{index}")),
            direction: (self.form == Form::Vector).then(|| {
                InputPort::vector(&format!("light{index}_direction"), self.formats.vector, 1.0)
            }),
            light_dot_view: self.component(&format!("light{index}_dot_view")),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }

    fn on_arc(&self, name: &str) -> Option<OnArc<InputPort>> {
        let component = |end: &str| self.component(&format!("{name}_{end}"));
        (self.form == Form::Scalar)
            .then(|| OnArc { start: component("start"), across: component("across") })
    }

    fn component(&self, name: &str) -> InputPort {
        InputPort::between(name, self.formats.component, -1.0, 1.0)
    }
}
