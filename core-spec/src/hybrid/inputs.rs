//! The inputs of a `hybrid` core.
use super::HybridSpec;
use crate::inputs::inputs;
use crate::quadratic::Quadratic;
use crate::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    HybridInputs {
        /// q = N·N.
        denominator: group(Quadratic),
        /// n, or its logarithm.
        exponent: one,
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light.
        lights: many(HybridLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
    HybridLight {
        /// p = 2(N·V)(N·L) - (L·V)(N·N).
        numerator: group(Quadratic),
        /// Gouraud's intensity at the first pixel.
        intensity_start: one,
        /// What it grows by with each pixel; 0 in a span of one pixel.
        intensity_step: one,
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

impl HybridSpec {
    /// The ports of a core with this method. With |N| ≤ 1 along the span, |p| ≤ q ≤ 1.
    pub fn inputs(&self, core: &CoreSpec) -> HybridInputs<InputPort> {
        let whole = HybridInputs {
            denominator: Quadratic::squared_length_ports("denominator", self.formats.accumulator),
            exponent: self.power_unit().port(core),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> HybridLight<InputPort> {
        let accumulator = self.formats.diffuse_accumulator;
        HybridLight {
            numerator: Quadratic::reflected_ports(
                &format!("light{index}_numerator"),
                self.formats.accumulator,
            ),
            intensity_start: InputPort::between(
                format!("light{index}_intensity_start"),
                accumulator,
                0.0,
                1.0,
            ),
            intensity_step: InputPort::between(
                format!("light{index}_intensity_step"),
                accumulator,
                -1.0,
                1.0,
            ),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }
}
