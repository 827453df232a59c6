//! Set-up of a span for `hybrid`.
use glam::DVec3;

use super::{HybridInputs, HybridLight, HybridSpec};
use crate::frame::{DirectionalLight, EYE, Frame, Span};
use crate::spec::Quadratic;
use crate::spec::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct HybridSetUp<'a> {
    pub hybrid: &'a HybridSpec,
    pub frame: &'a Frame,
}

impl SetUpSpan for HybridSetUp<'_> {
    fn inputs(&self, span: &Span, material: &MaterialInputs) -> Vec<i64> {
        let lights = self.frame.lights.iter().zip(&material.lights);
        let [m, k] = self.frame.normal_and_step(span);
        let inputs = HybridInputs {
            denominator: Quadratic::squared_length(span, m, k).quantised(self.hybrid.formats.accumulator),
            log2_shininess: i64::from(self.frame.material(span).shininess.ilog2()),
            ambient: material.ambient,
            lights: lights.map(|(light, coefficients)| self.light(span, light, coefficients)).collect(),
        };
        inputs.to_vec()
    }
}

impl HybridSetUp<'_> {
    fn light(&self, span: &Span, light: &DirectionalLight, &Coefficients { diffuse, specular }: &Coefficients) -> HybridLight<i64> {
        let f = &self.hybrid.formats;
        let [m, k] = self.frame.normal_and_step(span);
        let [intensity_start, intensity_step] = self.frame.gouraud(span, light.direction);
        HybridLight {
            numerator: numerator(span, m, k, light.direction).quantised(f.accumulator),
            intensity_start: f.diffuse_accumulator.quantise(intensity_start),
            intensity_step: f.diffuse_accumulator.quantise(intensity_step),
            diffuse,
            specular,
        }
    }
}

/// p(i) = 2(N·V)(N·L) - (L·V)(N·N) with N = m + k i.
fn numerator(span: &Span, m: DVec3, k: DVec3, l: DVec3) -> Quadratic<f64> {
    let l_dot_v = l.dot(EYE);
    Quadratic::new(
        span,
        2.0 * m.dot(EYE) * m.dot(l) - l_dot_v * m.dot(m),
        2.0 * (m.dot(EYE) * k.dot(l) + k.dot(EYE) * m.dot(l)) - 2.0 * l_dot_v * k.dot(m),
        2.0 * k.dot(EYE) * k.dot(l) - l_dot_v * k.dot(k),
    )
}
