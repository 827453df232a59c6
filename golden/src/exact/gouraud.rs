//! Intensities of the vertices or of the polygon, without rounding [lecture, eq. 2.1 and 3.2 to 3.6; METHODS.md A3, A4].
use glam::DVec3;
use specula_scene::spec::GouraudSpec;
use specula_scene::spec::gouraud::Interpolation;
use specula_scene::{Frame, Span};

use super::coefficients::{Amounts, Coefficients};
use super::diffuse::lambert;
use super::method::ShadePixel;
use super::normalisation::unit;
use super::reflection::reflect;
use super::shape::power;

/// One span, shaded by `gouraud`.
pub struct GouraudSpan<'a> {
    span: &'a Span,
    /// Normals that intensities are worked out of, and how much each counts at the first and at the last pixel.
    normals: Vec<DVec3>,
    ends: [Vec<f64>; 2],
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> GouraudSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &GouraudSpec, frame: &Frame, span: &'a Span) -> Self {
        let vertices = &frame.triangles[span.triangle].normals;
        let (normals, ends) = match spec.interpolation {
            Interpolation::Linear => (vertices.to_vec(), [span.start, span.end].map(Vec::from)),
            Interpolation::Uniform => {
                (vec![unit(vertices.iter().sum()).unwrap_or(DVec3::ZERO)], [1.0; 2].map(|weight| vec![weight]))
            }
        };
        let shininess = frame.material(span).shininess;
        GouraudSpan { span, normals, ends, shininess, coefficients: Coefficients::new(frame, span) }
    }

    /// Σ weight · `of`(normal), kept within 0 to 1.
    fn interpolated(&self, i: u32, of: impl Fn(DVec3) -> f64) -> f64 {
        let t = self.span.parameter(i);
        let weights = self.ends[0].iter().zip(&self.ends[1]).map(|(start, end)| start + t * (end - start));
        self.normals.iter().zip(weights).map(|(&n, weight)| weight * of(n)).sum::<f64>().clamp(0.0, 1.0)
    }
}

impl ShadePixel for GouraudSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        self.coefficients.sum(|light| Amounts {
            diffuse: self.interpolated(i, |n| lambert(n, light.direction)),
            specular: self.interpolated(i, |n| highlight(n, light.direction, self.shininess)),
        })
    }
}

/// max(R·L, 0)^n; none where there is no normal.
fn highlight(normal: DVec3, light: DVec3, shininess: u32) -> f64 {
    if normal == DVec3::ZERO { 0.0 } else { power(reflect(normal).dot(light).min(1.0), shininess) }
}
