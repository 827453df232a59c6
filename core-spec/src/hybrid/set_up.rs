//! Set-up of a span for `hybrid`.
use specula_scene::frame::{DirectionalLight, EYE, Frame, Span};

use super::{HybridInputs, HybridLight, HybridSpec};
use crate::Quadratic;
use crate::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct HybridSetUp<'a> {
    pub hybrid: &'a HybridSpec,
    pub frame: &'a Frame,
}

impl SetUpSpan for HybridSetUp<'_> {
    fn append(&self, span: &Span, material: &MaterialInputs, out: &mut Vec<i64>) {
        let lights = self.frame.lights.iter().zip(&material.lights);
        let [m, k] = self.frame.normal_and_step(span);
        let inputs = HybridInputs {
            denominator: Quadratic::squared_length(span, m, k)
                .quantised(self.hybrid.formats.accumulator),
            exponent: self.hybrid.power_unit().input(self.frame.material(span).shininess),
            ambient: material.ambient,
            lights: lights
                .map(|(light, coefficients)| self.light(span, light, coefficients))
                .collect(),
        };
        inputs.append_to(out);
    }
}

impl HybridSetUp<'_> {
    fn light(
        &self,
        span: &Span,
        light: &DirectionalLight,
        &Coefficients { diffuse, specular }: &Coefficients,
    ) -> HybridLight<i64> {
        let f = &self.hybrid.formats;
        let [intensity_start, intensity_step] = self.frame.gouraud(span, light.direction);
        HybridLight {
            numerator: Quadratic::reflected(
                span,
                self.frame.normal_and_step(span),
                EYE,
                light.direction,
            )
            .quantised(f.accumulator),
            intensity_start: f.diffuse_accumulator.quantise(intensity_start),
            intensity_step: f.diffuse_accumulator.quantise(intensity_step),
            diffuse,
            specular,
        }
    }
}
