//! Consistent normal interpolation as a shading method, without rounding [Reshetov, Soupikov and
//! Mark; methods D].
use glam::DVec3;
use specula_scene::frame::{EYE, halfway};
use specula_scene::{Frame, Span};
use specula_spec::ConsistentSpec;
use specula_spec::consistent::{Curve, Diffuse, Highlight, LARGEST_GAIN_BITS};

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::consistent::{
    Scaling, cos_gamma, cosine, pixel_angle, q, rational_q, reflection, vertex_angle,
};
use crate::exact::formula::diffuse::lambert;
use crate::exact::formula::shape::power;

/// One span, shaded by `consistent`.
pub struct ConsistentSpan<'a> {
    spec: &'a ConsistentSpec,
    span: &'a Span,
    start: DVec3,
    delta: DVec3,
    vertex_angles: [f64; 3],
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> ConsistentSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &'a ConsistentSpec, frame: &Frame, span: &'a Span) -> Self {
        let [start, end] = frame.end_axes(span);
        let scaling = match spec.curve {
            Curve::Rational => Scaling::RATIONAL,
            Curve::Trigonometric => Scaling::TRIGONOMETRIC_LINEAR,
        };
        ConsistentSpan {
            spec,
            span,
            start,
            delta: end - start,
            vertex_angles: frame.triangles[span.triangle]
                .cones
                .map(|cone| vertex_angle(cone.cosine.max(0.0), scaling)),
            shininess: frame.material(span).shininess,
            coefficients: Coefficients::new(frame, span),
        }
    }

    /// N, and q of its angle; `None` where the interpolated normal vanishes. A normal shorter than
    /// 1/16 is not brought to unit length.
    pub fn normal_and_q(&self, i: u32) -> Option<(DVec3, f64)> {
        let interpolated = self.start + self.span.parameter(i) * self.delta;
        if interpolated == DVec3::ZERO {
            return None;
        }
        let shortest = 0.5_f64.powi(LARGEST_GAIN_BITS.cast_signed());
        let alpha = pixel_angle(self.vertex_angles, self.span.weights(i));
        let q = match self.spec.curve {
            Curve::Rational => rational_q(alpha),
            Curve::Trigonometric => q(alpha),
        };
        Some((interpolated / interpolated.length().max(shortest), q))
    }

    fn diffuse(&self, normal: DVec3, q: f64, light: DVec3) -> f64 {
        match self.spec.diffuse {
            Diffuse::Lambert => lambert(normal, light),
            Diffuse::Consistent => consistent_cosine(normal, q, light),
        }
    }

    /// The highlight; Blinn's is 0 where L = -V leaves no H (extremes row 12).
    fn specular(&self, normal: DVec3, q: f64, light: DVec3) -> f64 {
        match (self.spec.highlight, halfway(light)) {
            (Highlight::Reflection, _) => {
                power(reflection(normal, EYE, q).dot(light).min(1.0), self.shininess)
            }
            (Highlight::Blinn, DVec3::ZERO) => 0.0,
            (Highlight::Blinn, halfway) => {
                power(consistent_cosine(normal, q, halfway), 4 * self.shininess)
            }
        }
    }
}

impl ShadeSpan for ConsistentSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let Some((normal, q)) = self.normal_and_q(i) else {
            return self.coefficients.sum(|_| Amounts::default());
        };
        self.coefficients.sum(|light| Amounts {
            diffuse: self.diffuse(normal, q, light.direction),
            specular: self.specular(normal, q, light.direction),
        })
    }
}

/// N_c·I, or 0 for an I below the horizon that α leaves: β + γ ≥ π, that is g + b ≤ 0.
pub fn consistent_cosine(normal: DVec3, q: f64, incoming: DVec3) -> f64 {
    let b = normal.dot(incoming);
    if cos_gamma(q, b) + b <= 0.0 { 0.0 } else { cosine(incoming, reflection(normal, incoming, q)) }
}
