//! Set-up of a span for `slerp`.
use glam::DVec3;

use super::{SlerpInputs, SlerpLight, SlerpSpec};
use crate::frame::{Arc, DirectionalLight, EYE, Frame, Span};
use crate::spec::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct SlerpSetUp<'a> {
    pub slerp: &'a SlerpSpec,
    pub frame: &'a Frame,
}

impl SetUpSpan for SlerpSetUp<'_> {
    fn inputs(&self, span: &Span, material: &MaterialInputs) -> Vec<i64> {
        let f = &self.slerp.formats;
        let arc = self.frame.arc(span);
        let turn = if span.steps() == 0 { 0.0 } else { arc.angle / f64::from(span.steps()) };
        let lights = self.frame.lights.iter().zip(&material.lights);
        let inputs = SlerpInputs {
            turn_cosine: f.turn.quantise(libm::cos(turn)),
            turn_sine: f.turn.quantise(libm::sin(turn)),
            view_start: f.component.quantise(arc.start.dot(EYE)),
            view_across: f.component.quantise(arc.across.dot(EYE)),
            exponent: self.slerp.power_unit().input(self.frame.material(span).shininess),
            ambient: material.ambient,
            lights: lights.map(|(light, coefficients)| self.light(&arc, light, coefficients)).collect(),
        };
        inputs.to_vec()
    }
}

impl SlerpSetUp<'_> {
    fn light(&self, arc: &Arc, light: &DirectionalLight, &Coefficients { diffuse, specular }: &Coefficients) -> SlerpLight<i64> {
        let component = self.slerp.formats.component;
        let l_dot_v = if arc.start == DVec3::ZERO { 1.0 } else { light.direction.dot(EYE) };
        SlerpLight {
            light_start: component.quantise(arc.start.dot(light.direction)),
            light_across: component.quantise(arc.across.dot(light.direction)),
            light_dot_view: component.quantise(l_dot_v),
            diffuse,
            specular,
        }
    }
}
