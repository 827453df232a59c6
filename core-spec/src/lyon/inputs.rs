//! The inputs of a `lyon` core.
use specula_datapath::Format;

use super::{LyonSpec, Normals, ShapeDatapath};
use crate::inputs::inputs;
use crate::{CoreSpec, InputPort};

inputs! {
    /// The core's inputs, or whatever belongs to each of them.
    LyonInputs {
        /// N0, the normal at the first pixel; of flat normals the only one, and of those wrapped
        /// around a fixed w N0 + w.
        normal_start: vector,
        /// N1 - N0, over the whole span; not there with flat normals.
        normal_delta: vector_if_any,
        /// 1/S, what the weight grows by with each pixel; 0 in a span of one pixel. Not there with
        /// flat normals.
        weight_step: one_if_any,
        /// w, with wrapped normals.
        wrap_axis: vector_if_any,
        /// Whether w is the wrapped normal before from the second pixel on, where normals are
        /// wrapped around that.
        wrap_follows: one_if_any,
        /// n, or m of the root shape.
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
        /// The half-way vector, where D is made of one.
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
        let changes = self.normals != Normals::Flat;
        let whole = LyonInputs {
            normal_start: match self.normals {
                Normals::Linear => InputPort::vector("normal_start", f.vector, 1.0),
                Normals::Flat => InputPort::vector("normal", f.vector, 1.0),
                Normals::Wrapped if self.follows() => {
                    InputPort::vector("normal_start", f.vector, 1.0)
                }
                Normals::Wrapped => InputPort::vector("wrap_start", f.vector_sum(), 2.0),
            },
            normal_delta: changes.then(|| InputPort::vector("normal_delta", f.vector_sum(), 2.0)),
            weight_step: changes
                .then(|| InputPort::between("weight_step", f.weight_accumulator, 0.0, 1.0)),
            wrap_axis: (self.normals == Normals::Wrapped)
                .then(|| InputPort::vector("wrap_axis", f.vector, 1.0)),
            wrap_follows: self
                .follows()
                .then(|| InputPort::between("wrap_follows", Format::unsigned(1, 0), 0.0, 1.0)),
            shininess: self.shininess_input(core),
            ambient: core.colour_ports("ambient"),
            lights: (0..core.lights).map(|i| self.light_inputs(core, i)).collect(),
        };
        whole.map(|port| core.over_frames(port))
    }

    fn shininess_input(&self, core: &CoreSpec) -> InputPort {
        let largest = core.largest_shininess;
        match self.shape {
            ShapeDatapath::FK => {
                let format = Format::unsigned(u32::BITS - largest.leading_zeros(), 0);
                InputPort::between("shininess", format, 1.0, f64::from(largest))
            }
            ShapeDatapath::Root => {
                let root = |shininess| f64::from(self.squared_root_shininess(shininess)).sqrt();
                InputPort::between(
                    "root_shininess",
                    self.formats.root_shininess,
                    root(1),
                    root(largest),
                )
            }
        }
    }

    fn light_inputs(&self, core: &CoreSpec, index: usize) -> LyonLight<InputPort> {
        let f = &self.formats;
        let name = format!("light{index}_halfway");
        let halfway = || match self.difference.takes_unit_halfway() {
            // g2 makes h longer than 1 by 0.2 % at most (methods B9), and that only where it is no
            // nearer than 20 degrees to an axis.
            true => InputPort::vector(&name, f.vector, 1.0),
            false => InputPort::vector(&name, f.vector_sum(), 2.0),
        };
        LyonLight {
            direction: InputPort::vector(&format!("light{index}_direction"), f.vector, 1.0),
            halfway: (self.difference.takes_halfway() || self.difference.takes_unit_halfway())
                .then(halfway),
            diffuse: core.colour_ports(&format!("light{index}_diffuse")),
            specular: core.colour_ports(&format!("light{index}_specular")),
        }
    }
}
