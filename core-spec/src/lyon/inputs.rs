//! The inputs of a `lyon` core.
use specula_datapath::Format;

use super::{LyonSpec, Normals, ShapeDatapath};
use crate::core_input::CoreInput;
use crate::core_input::InputRole::{Exponent, Light, Surface};
use crate::inputs::{CoreInputs, MethodInputs, inputs};
use crate::parameters::CoreParameters;

inputs! {
    /// Inputs that the lights of a span have in common.
    LyonSpan {
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
    }
}

inputs! {
    /// Inputs of one light.
    LyonLight {
        /// L.
        direction: vector,
        /// The half-way vector, where D is made of one.
        halfway: vector_if_any,
    }
}

/// The inputs of a core, or whatever belongs to each of them.
pub type LyonInputs<T> = CoreInputs<LyonSpan<T>, LyonLight<T>, T>;

impl MethodInputs for LyonSpec {
    type SpanGroup = LyonSpan<CoreInput>;
    type LightGroup = LyonLight<CoreInput>;

    fn span_inputs(&self, core: &CoreParameters) -> LyonSpan<CoreInput> {
        let f = &self.formats;
        let changes = self.normals != Normals::Flat;
        let vector = |name: &str| CoreInput::vector(Surface, name, f.vector, 1.0);
        let sum = |name: &str| CoreInput::vector(Surface, name, f.vector_sum(), 2.0);
        let number =
            |name: &str, format: Format| CoreInput::between(Surface, name, format, 0.0, 1.0);
        LyonSpan {
            normal_start: match self.normals {
                Normals::Linear => vector("normal_start"),
                Normals::Flat => vector("normal"),
                Normals::Wrapped if self.follows() => vector("normal_start"),
                Normals::Wrapped => sum("wrap_start"),
            },
            normal_delta: changes.then(|| sum("normal_delta")),
            weight_step: changes.then(|| number("weight_step", f.weight_accumulator)),
            wrap_axis: (self.normals == Normals::Wrapped).then(|| vector("wrap_axis")),
            wrap_follows: self.follows().then(|| number("wrap_follows", Format::unsigned(1, 0))),
            shininess: self.shininess_input(core),
        }
    }

    fn light_inputs(&self, _core: &CoreParameters, index: usize) -> LyonLight<CoreInput> {
        let f = &self.formats;
        let name = format!("light{index}_halfway");
        let halfway = || {
            if self.difference.takes_unit_halfway() {
                // g2 makes h longer than 1 by 0.2 % at most (methods B9), and that only where it is
                // no nearer than 20 degrees to an axis.
                CoreInput::vector(Light, &name, f.vector, 1.0)
            } else {
                CoreInput::vector(Light, &name, f.vector_sum(), 2.0)
            }
        };
        let direction = format!("light{index}_direction");
        LyonLight {
            direction: CoreInput::vector(Light, &direction, f.vector, 1.0),
            halfway: (self.difference.takes_halfway() || self.difference.takes_unit_halfway())
                .then(halfway),
        }
    }
}

impl LyonSpec {
    fn shininess_input(&self, core: &CoreParameters) -> CoreInput {
        let largest = core.largest_shininess;
        match self.shape {
            ShapeDatapath::FK => {
                let format = Format::unsigned(u32::BITS - largest.leading_zeros(), 0);
                CoreInput::between(Exponent, "shininess", format, 1.0, f64::from(largest))
            }
            ShapeDatapath::Root => {
                let root = |shininess| f64::from(self.squared_root_shininess(shininess)).sqrt();
                CoreInput::between(
                    Exponent,
                    "root_shininess",
                    self.formats.root_shininess,
                    root(1),
                    root(largest),
                )
            }
        }
    }
}
