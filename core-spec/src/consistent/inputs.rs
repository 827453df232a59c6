//! The inputs of a `consistent` core.
use super::{ConsistentSpec, Highlight};
use crate::inputs::inputs;
use crate::{CoreSpec, InputPort};

/// t at a vertex is 1.06097 at most, which is 1.06097 quarter turns with the trigonometric curve
/// and less with the rational one.
pub const LARGEST_ANGLE: f64 = 1.0625;

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    ConsistentInputs {
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
        /// n, or its logarithm.
        exponent: one,
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light.
        lights: many(ConsistentLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
    ConsistentLight {
        /// L.
        direction: vector,
        /// H = (L + V)/|L + V|; there with Blinn's highlight only.
        halfway: vector_if_any,
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

impl ConsistentSpec {
    /// The ports of a core with this method.
    pub fn inputs(&self, core: &CoreSpec) -> ConsistentInputs<InputPort> {
        let f = &self.formats;
        let whole = ConsistentInputs {
            normal_start: InputPort::vector("normal_start", f.vector, 1.0),
            normal_delta: InputPort::vector("normal_delta", f.vector_sum(), 2.0),
            weight_step: InputPort::between("weight_step", f.weight_accumulator, 0.0, 1.0),
            angle_start: InputPort::between(
                "angle_start",
                f.angle_accumulator,
                0.0,
                LARGEST_ANGLE + f.angle_accumulator.ulp(),
            ),
            angle_step: InputPort::between(
                "angle_step",
                f.angle_accumulator,
                -LARGEST_ANGLE,
                LARGEST_ANGLE,
            ),
            exponent: self.power_unit().port(core),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> ConsistentLight<InputPort> {
        let vector = |part: &str| {
            InputPort::vector(&format!("light{index}_{part}"), self.formats.vector, 1.0)
        };
        ConsistentLight {
            direction: vector("direction"),
            halfway: (self.highlight == Highlight::Blinn).then(|| vector("halfway")),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }
}
