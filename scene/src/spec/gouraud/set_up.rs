//! Set-up of a span for `gouraud`.
use glam::DVec3;

use super::{GouraudInputs, GouraudLight, GouraudSpec, Intensity, Interpolation};
use crate::frame::{DirectionalLight, EYE, Frame, Span};
use crate::spec::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct GouraudSetUp<'a> {
    pub gouraud: &'a GouraudSpec,
    pub frame: &'a Frame,
}

impl SetUpSpan for GouraudSetUp<'_> {
    fn inputs(&self, span: &Span, material: &MaterialInputs) -> Vec<i64> {
        let lights = self.frame.lights.iter().zip(&material.lights);
        let inputs = GouraudInputs {
            ambient: material.ambient,
            lights: lights.map(|(light, coefficients)| self.light(span, light, coefficients)).collect(),
        };
        inputs.to_vec()
    }
}

impl GouraudSetUp<'_> {
    fn light(
        &self,
        span: &Span,
        light: &DirectionalLight,
        &Coefficients { diffuse, specular }: &Coefficients,
    ) -> GouraudLight<i64> {
        let n = self.frame.material(span).shininess;
        GouraudLight {
            diffuse_intensity: self.intensity(span, |normal| normal.dot(light.direction).max(0.0)),
            specular_intensity: self.intensity(span, |normal| highlight(normal, light.direction, n)),
            diffuse,
            specular,
        }
    }

    fn intensity(&self, span: &Span, of: impl Fn(DVec3) -> f64) -> Intensity<i64> {
        let formats = &self.gouraud.formats;
        match self.gouraud.interpolation {
            Interpolation::Linear => {
                let [start, step] = self.frame.interpolated(span, of).map(|x| formats.accumulator.quantise(x));
                Intensity { start, step: Some(step) }
            }
            Interpolation::Uniform => Intensity { start: formats.intensity.quantise(of(self.frame.mean_normal(span))), step: None },
        }
    }
}

/// max(R·L, 0)^n with R = 2(N·V)N - V [lecture, eq. 2.1]; 0 where there is no normal to reflect about.
fn highlight(normal: DVec3, light: DVec3, n: u32) -> f64 {
    if normal == DVec3::ZERO {
        return 0.0;
    }
    let reflection = 2.0 * normal.dot(EYE) * normal - EYE;
    libm::pow(reflection.dot(light).clamp(0.0, 1.0), f64::from(n))
}
