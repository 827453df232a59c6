//! The inputs of a `gouraud` core.
use super::{GouraudSpec, Interpolation};
use crate::inputs::inputs;
use crate::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    GouraudInputs {
        /// Ambient light sent back, in LSBs.
        ambient: vector,
        /// What belongs to each light.
        lights: many(GouraudLight),
    }
}

inputs! {
    /// Inputs that belong to one light.
    GouraudLight {
        /// max(N·L, 0).
        diffuse_intensity: group(Intensity),
        /// max(R·L, 0)^n.
        specular_intensity: group(Intensity),
        /// Diffuse coefficient, in LSBs.
        diffuse: vector,
        /// Specular coefficient, in LSBs.
        specular: vector,
    }
}

inputs! {
    /// An intensity along a span.
    Intensity {
        /// At the first pixel, 0 to 1.
        start: one,
        /// What it grows by with each pixel, 0 in a span of one pixel; with linear interpolation
        /// only.
        step: one_if_any,
    }
}

impl GouraudSpec {
    /// The ports of a core with this method.
    pub fn inputs(&self, core: &CoreSpec) -> GouraudInputs<InputPort> {
        let whole = GouraudInputs {
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> GouraudLight<InputPort> {
        GouraudLight {
            diffuse_intensity: self.intensity_ports(&format!("light{index}_diffuse_intensity")),
            specular_intensity: self.intensity_ports(&format!("light{index}_specular_intensity")),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }

    fn intensity_ports(&self, name: &str) -> Intensity<InputPort> {
        let accumulator = self.formats.accumulator;
        match self.interpolation {
            Interpolation::Linear => Intensity {
                start: InputPort::between(format!("{name}_start"), accumulator, 0.0, 1.0),
                step: Some(InputPort::between(format!("{name}_step"), accumulator, -1.0, 1.0)),
            },
            Interpolation::Uniform => Intensity {
                start: InputPort::between(name, self.formats.intensity, 0.0, 1.0),
                step: None,
            },
        }
    }
}
