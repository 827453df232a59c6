//! Duff's diffuse with one of Hast's highlights, without rounding [Hast, Barrera and Bengtsson, eq.
//! 3 to 8, 17, 33 and 34; methods C2, C8 to C11].
use glam::DVec3;
use specula_scene::frame::halfway;
use specula_scene::{Frame, Span};
use specula_spec::DuffSpec;
use specula_spec::duff::Highlight;

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::hast::{base, cosine, diffuse, eq33, eq34};
use crate::exact::formula::shape::power;

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

/// The highlight for a normal of any length, 0 to 1, and 0 for N = 0.
pub fn highlight(of: Highlight, normal: DVec3, light: DVec3, n: u32) -> f64 {
    match of {
        Highlight::Blinn => power(cosine(normal, halfway(light)).min(1.0), 4 * n),
        Highlight::Quotient => power(base(normal, light), n),
        Highlight::Eq33 => power(eq33(normal, light), n),
        Highlight::Eq34 => power(eq34(normal, light), n),
    }
}
