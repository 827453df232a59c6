//! Gouraud diffuse with Hast's specular base, without rounding [Hast, Barrera and Bengtsson, eq. 17
//! to 26; methods C3].
use glam::DVec3;
use specula_scene::frame::EYE;
use specula_scene::{Frame, Span};

use super::coefficients::{Amounts, Coefficients};
use super::diffuse::gouraud;
use super::shade_span::ShadeSpan;
use super::shape::power;

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

/// R·L for a normal of any length: p/q with p = 2(N·V)(N·L) - (L·V)(N·N) and q = N·N, kept within 0
/// to 1, and 0 for N = 0 [Hast et al., eq. 17].
pub fn base(normal: DVec3, light: DVec3) -> f64 {
    let q = normal.length_squared();
    let p = 2.0 * normal.dot(EYE) * normal.dot(light) - light.dot(EYE) * q;
    if p <= 0.0 || q <= 0.0 { 0.0 } else { (p / q).min(1.0) }
}
