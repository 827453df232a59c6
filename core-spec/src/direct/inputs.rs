//! The inputs of a `direct` core.
use super::DirectSpec;
use crate::inputs::inputs;
use crate::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    DirectInputs {
        /// 1/S, what t grows by with each pixel; 0 in a span of one pixel.
        weight_step: one,
        /// κ = |B - A|².
        spread: one,
        /// N·V.
        view: group(Ends),
        /// n, or its logarithm.
        exponent: one,
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light.
        lights: many(DirectLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
    DirectLight {
        /// N·L.
        light: group(Ends),
        /// L·V; 1 where the span has no normal, which leaves no highlight.
        light_dot_view: one,
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

inputs! {
    /// What is linear in t.
    Ends {
        /// At t = 0.
        start: one,
        /// At t = 1 less that at t = 0.
        delta: one,
    }
}

impl DirectSpec {
    /// The ports of a core with this method.
    pub fn inputs(&self, core: &CoreSpec) -> DirectInputs<InputPort> {
        let f = &self.formats;
        let whole = DirectInputs {
            weight_step: InputPort::between("weight_step", f.weight_accumulator, 0.0, 1.0),
            spread: InputPort::between("spread", f.spread, 0.0, 4.0),
            view: self.ends("view"),
            exponent: self.power_unit().port(core),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> DirectLight<InputPort> {
        DirectLight {
            light: self.ends(&format!("light{index}")),
            light_dot_view: InputPort::between(
                format!("light{index}_dot_view"),
                self.formats.component,
                -1.0,
                1.0,
            ),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }

    fn ends(&self, name: &str) -> Ends<InputPort> {
        Ends {
            start: InputPort::between(format!("{name}_start"), self.formats.component, -1.0, 1.0),
            delta: InputPort::between(
                format!("{name}_delta"),
                self.formats.component_sum(),
                -2.0,
                2.0,
            ),
        }
    }
}
