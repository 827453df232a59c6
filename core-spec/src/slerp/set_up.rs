//! Set-up of a span for `slerp`.
use glam::DVec3;
use specula_scene::frame::{DirectionalLight, EYE, Frame, Span};

use super::{Axes, Course, Form, OnArc, SlerpInputs, SlerpLight, SlerpSpec};
use crate::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct SlerpSetUp<'a> {
    pub slerp: &'a SlerpSpec,
    pub frame: &'a Frame,
}

impl SetUpSpan for SlerpSetUp<'_> {
    fn append(&self, span: &Span, material: &MaterialInputs, out: &mut Vec<i64>) {
        let f = &self.slerp.formats;
        let course = self.slerp.course(self.frame, span);
        let [turn_cosine, turn_sine, turn_back] = course.turn.map(|x| f.turn.quantise(x));
        let ends = self.slerp.between_ends();
        let axes = course.axes.map(|axis| f.vector.quantise_vector(axis));
        let lights = self.frame.lights.iter().zip(&material.lights);
        let inputs = SlerpInputs {
            turn_cosine,
            turn_sine,
            turn_back: ends.then_some(turn_back),
            rising_cosine: ends.then(|| f.scaled_state.quantise(course.rising_cosine)),
            falling_cosine: ends.then(|| f.scaled_state.quantise(course.falling_cosine)),
            view: self.on_arc(&course, EYE),
            normal: (self.slerp.form == Form::Vector)
                .then_some(Axes { start: axes[0], other: axes[1] }),
            exponent: self.slerp.power_unit().input(self.frame.material(span).shininess),
            ambient: material.ambient,
            lights: lights
                .map(|(light, coefficients)| self.light(&course, light, coefficients))
                .collect(),
        };
        inputs.append_to(out);
    }
}

impl SlerpSetUp<'_> {
    fn light(
        &self,
        course: &Course,
        light: &DirectionalLight,
        &Coefficients { diffuse, specular }: &Coefficients,
    ) -> SlerpLight<i64> {
        let f = &self.slerp.formats;
        let l_dot_v = if course.axes[0] == DVec3::ZERO { 1.0 } else { light.direction.dot(EYE) };
        SlerpLight {
            light: self.on_arc(course, light.direction),
            direction: (self.slerp.form == Form::Vector)
                .then(|| f.vector.quantise_vector(light.direction)),
            light_dot_view: f.component.quantise(l_dot_v),
            diffuse,
            specular,
        }
    }

    fn on_arc(&self, course: &Course, x: DVec3) -> Option<OnArc<i64>> {
        let [start, across] =
            course.axes.map(|axis| self.slerp.formats.component.quantise(axis.dot(x)));
        (self.slerp.form == Form::Scalar).then_some(OnArc { start, across })
    }
}
