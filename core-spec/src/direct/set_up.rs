//! Set-up of a span for `direct`.
use glam::DVec3;
use specula_scene::frame::{DirectionalLight, EYE, Frame, Span};

use super::{DirectInputs, DirectLight, DirectSpec, Ends};
use crate::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct DirectSetUp<'a> {
    pub direct: &'a DirectSpec,
    pub frame: &'a Frame,
}

impl SetUpSpan for DirectSetUp<'_> {
    fn append(&self, span: &Span, material: &MaterialInputs, out: &mut Vec<i64>) {
        let f = &self.direct.formats;
        let normals = self.frame.unit_end_normals(span);
        let step = span.weight_step();
        let lights = self.frame.lights.iter().zip(&material.lights);
        let inputs = DirectInputs {
            weight_step: f.weight_accumulator.quantise(step),
            spread: f.spread.quantise((normals[1] - normals[0]).length_squared()),
            view: self.ends(normals, EYE),
            exponent: self.direct.power_unit().input(self.frame.material(span).shininess),
            ambient: material.ambient,
            lights: lights
                .map(|(light, coefficients)| self.light(normals, light, coefficients))
                .collect(),
        };
        inputs.append_to(out);
    }
}

impl DirectSetUp<'_> {
    fn light(
        &self,
        normals: [DVec3; 2],
        light: &DirectionalLight,
        &Coefficients { diffuse, specular }: &Coefficients,
    ) -> DirectLight<i64> {
        let l_dot_v = if normals[0] == DVec3::ZERO { 1.0 } else { light.direction.dot(EYE) };
        DirectLight {
            light: self.ends(normals, light.direction),
            light_dot_view: self.direct.formats.component.quantise(l_dot_v),
            diffuse,
            specular,
        }
    }

    /// N·`x` at both ends, each rounded, so that what lies between never leaves what they are.
    fn ends(&self, normals: [DVec3; 2], x: DVec3) -> Ends<i64> {
        let component = self.direct.formats.component;
        let [start, end] = normals.map(|n| component.quantise(n.dot(x).clamp(-1.0, 1.0)));
        Ends { start, delta: end - start }
    }
}
