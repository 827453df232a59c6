//! The inputs of a `slerp` core.
use super::SlerpSpec;
use crate::spec::inputs::inputs;
use crate::spec::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    SlerpInputs {
        /// cos(f/S); 1 in a span of one pixel.
        turn_cosine: one,
        /// sin(f/S); 0 in a span of one pixel.
        turn_sine: one,
        /// A·V.
        view_start: one,
        /// T·V.
        view_across: one,
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
        /// A·L.
        light_start: one,
        /// T·L.
        light_across: one,
        /// L·V; 1 where the span has no normal, which leaves no highlight.
        light_dot_view: one,
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

impl SlerpSpec {
    /// The ports of a core with this method. Angles are 0 to 180 degrees, so no sine is negative.
    pub fn inputs(&self, core: &CoreSpec) -> SlerpInputs<InputPort> {
        let turn = self.formats.turn;
        let whole = SlerpInputs {
            turn_cosine: InputPort::between("turn_cosine", turn, -1.0, 1.0),
            turn_sine: InputPort::between("turn_sine", turn, 0.0, 1.0),
            view_start: self.component("view_start"),
            view_across: self.component("view_across"),
            exponent: self.power_unit().port(core),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> SlerpLight<InputPort> {
        SlerpLight {
            light_start: self.component(&format!("light{index}_start")),
            light_across: self.component(&format!("light{index}_across")),
            light_dot_view: self.component(&format!("light{index}_dot_view")),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }

    fn component(&self, name: &str) -> InputPort {
        InputPort::between(name, self.formats.component, -1.0, 1.0)
    }
}
