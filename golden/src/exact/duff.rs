//! Duff's diffuse with one of Hast's highlights, without rounding [Hast, Barrera and Bengtsson, eq.
//! 3 to 8, 17, 33 and 34; methods C2, C8 to C11].
use glam::DVec3;
use specula_scene::frame::{EYE, halfway};
use specula_scene::{Frame, Span};
use specula_spec::DuffSpec;
use specula_spec::duff::Highlight;

use super::coefficients::{Amounts, Coefficients};
use super::hybrid::base;
use super::method::ShadeSpan;
use super::shape::power;

/// One span, shaded by `duff`.
pub struct DuffSpan<'a> {
    spec: &'a DuffSpec,
    span: &'a Span,
    start: DVec3,
    delta: DVec3,
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> DuffSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &'a DuffSpec, frame: &'a Frame, span: &'a Span) -> Self {
        let [start, end] = frame.end_normals(span);
        let shininess = frame.material(span).shininess;
        DuffSpan {
            spec,
            span,
            start,
            delta: end - start,
            shininess,
            coefficients: Coefficients::new(frame, span),
        }
    }
}

impl ShadeSpan for DuffSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let normal = self.start + self.span.parameter(i) * self.delta;
        self.coefficients.sum(|light| Amounts {
            diffuse: diffuse(normal, light.direction),
            specular: highlight(self.spec.specular, normal, light.direction, self.shininess),
        })
    }
}

/// p/√q = N·L/√(N·N), kept within 0 to 1, and 0 for N = 0 [Hast et al., eq. 8].
pub fn diffuse(normal: DVec3, light: DVec3) -> f64 {
    cosine(normal, light).clamp(0.0, 1.0)
}

/// u·N/√(N·N), and 0 for N = 0.
fn cosine(normal: DVec3, u: DVec3) -> f64 {
    let q = normal.length_squared();
    if q > 0.0 { normal.dot(u) / q.sqrt() } else { 0.0 }
}

/// The highlight of a normal of any length, 0 to 1, and 0 for N = 0.
pub fn highlight(of: Highlight, normal: DVec3, light: DVec3, n: u32) -> f64 {
    match of {
        Highlight::Blinn => power(cosine(normal, halfway(light)).min(1.0), 4 * n),
        Highlight::Quotient => power(base(normal, light), n),
        Highlight::Eq33 => power(eq33(normal, light), n),
        Highlight::Eq34 => power(eq34(normal, light), n),
    }
}

/// R·L = 2(N·V)(p/q) - L·V, kept within 0 to 1, and 0 for N = 0 [Hast et al., eq. 33].
pub fn eq33(normal: DVec3, light: DVec3) -> f64 {
    let q = normal.length_squared();
    if q <= 0.0 {
        return 0.0;
    }
    (2.0 * normal.dot(EYE) * (normal.dot(light) / q) - light.dot(EYE)).clamp(0.0, 1.0)
}

/// R·L = 2(N·V s)(N·L s) - L·V with s = 1/√(N·N), kept within 0 to 1, and 0 for N = 0 [Hast et al.,
/// eq. 34].
pub fn eq34(normal: DVec3, light: DVec3) -> f64 {
    if normal == DVec3::ZERO {
        return 0.0;
    }
    (2.0 * cosine(normal, EYE) * cosine(normal, light) - light.dot(EYE)).clamp(0.0, 1.0)
}
