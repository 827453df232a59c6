//! Gouraud diffuse with Hast's specular base, without rounding [Hast, Barrera and Bengtsson, eq. 17
//! to 26; methods C3].
use glam::DVec3;
use specula_scene::{Frame, Span};

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::diffuse::gouraud;
use crate::exact::formula::hast::base;
use crate::exact::formula::shape::power;

/// One span, shaded by `hybrid`.
pub struct HybridSpan<'a> {
    span: &'a Span,
    vertex_normals: &'a [DVec3; 3],
    start: DVec3,
    delta: DVec3,
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> HybridSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(frame: &'a Frame, span: &'a Span) -> Self {
        let [start, end] = frame.end_normals(span);
        HybridSpan {
            span,
            vertex_normals: &frame.triangles[span.triangle].normals,
            start,
            delta: end - start,
            shininess: frame.material(span).shininess,
            coefficients: Coefficients::new(frame, span),
        }
    }
}

impl ShadeSpan for HybridSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let weights = self.span.weights(i);
        let normal = self.start + self.span.parameter(i) * self.delta;
        self.coefficients.sum(|light| Amounts {
            diffuse: gouraud(self.vertex_normals, weights, light.direction),
            specular: power(base(normal, light.direction), self.shininess),
        })
    }
}
