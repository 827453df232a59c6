//! The inputs of a `lyon` core.
use super::{Difference, LyonSpec};
use crate::format::Format;
use crate::spec::inputs::inputs;
use crate::spec::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    LyonInputs {
        /// N0, the normal at the first pixel.
        normal_start: vector,
        /// N1 - N0, over the whole span.
        normal_delta: vector,
        /// 1/S, what the weight grows by with each pixel; 0 in a span of one pixel.
        weight_step: one,
        /// n.
        shininess: one,
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light.
        lights: many(LyonLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
    LyonLight {
        /// L.
        direction: vector,
        /// H = L + V; there with D = H × N only.
        halfway: vector_if_any,
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

impl LyonSpec {
    /// The ports of a core with this method.
    pub fn inputs(&self, core: &CoreSpec) -> LyonInputs<InputPort> {
        let f = &self.formats;
        let shininess = Format::unsigned(u32::BITS - core.largest_shininess.leading_zeros(), 0);
        LyonInputs {
            normal_start: InputPort::vector("normal_start", f.vector, 1.0),
            normal_delta: InputPort::vector("normal_delta", f.vector_sum(), 2.0),
            weight_step: InputPort::between("weight_step", f.weight_accumulator, 0.0, 1.0),
            shininess: InputPort::between("shininess", shininess, 1.0, f64::from(core.largest_shininess)),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        }
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> LyonLight<InputPort> {
        let f = &self.formats;
        let halfway = || InputPort::vector(&format!("light{index}_halfway"), f.vector_sum(), 2.0);
        LyonLight {
            direction: InputPort::vector(&format!("light{index}_direction"), f.vector, 1.0),
            halfway: (self.difference == Difference::HalfwayCrossNormal).then(halfway),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }
}
