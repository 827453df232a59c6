//! Set-up of a span for `duff`.
use glam::DVec3;
use specula_scene::frame::{DirectionalLight, EYE, Frame, Span, halfway};

use super::{DuffInputs, DuffLight, DuffSpec, Highlight};
use crate::set_up::{Coefficients, MaterialInputs, SetUpSpan};
use crate::{Linear, Quadratic};

/// Sets up the spans of a frame.
pub(super) struct DuffSetUp<'a> {
    pub duff: &'a DuffSpec,
    pub frame: &'a Frame,
}

impl SetUpSpan for DuffSetUp<'_> {
    fn append(&self, span: &Span, material: &MaterialInputs, out: &mut Vec<i64>) {
        let highlight = self.duff.specular;
        let normal = self.frame.normal_and_step(span);
        let [m, k] = normal;
        let lights = self.frame.lights.iter().zip(&material.lights);
        let inputs = DuffInputs {
            denominator: Quadratic::squared_length(span, m, k)
                .quantised(self.duff.formats.accumulator),
            view: highlight.looks_at_the_eye().then(|| self.linear(span, normal, EYE)),
            exponent: self.duff.power_unit().input(self.frame.material(span).shininess),
            ambient: material.ambient,
            lights: lights
                .map(|(light, coefficients)| self.light(span, normal, light, coefficients))
                .collect(),
        };
        inputs.append_to(out);
    }
}

impl DuffSetUp<'_> {
    /// (m + k i)·u.
    fn linear(&self, span: &Span, [m, k]: [DVec3; 2], u: DVec3) -> Linear<i64> {
        Linear::new(span, m.dot(u), k.dot(u)).quantised(self.duff.formats.linear_accumulator)
    }

    fn light(
        &self,
        span: &Span,
        normal: [DVec3; 2],
        light: &DirectionalLight,
        &Coefficients { diffuse, specular }: &Coefficients,
    ) -> DuffLight<i64> {
        let (f, l) = (&self.duff.formats, light.direction);
        let highlight = self.duff.specular;
        let numerator = || Quadratic::reflected(span, normal, EYE, l).quantised(f.accumulator);
        DuffLight {
            cosine: self.linear(span, normal, l),
            halfway: (highlight == Highlight::Blinn).then(|| self.linear(span, normal, halfway(l))),
            numerator: (highlight == Highlight::Quotient).then(numerator),
            dot_view: highlight.looks_at_the_eye().then(|| f.cosine.quantise(l.dot(EYE))),
            diffuse,
            specular,
        }
    }
}
