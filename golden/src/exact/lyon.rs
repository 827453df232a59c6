//! Lyon's method without rounding [Lyon, TR 43; METHODS.md B].
use glam::DVec3;
use specula_scene::spec::LyonSpec;
use specula_scene::spec::lyon::Difference;
use specula_scene::{Frame, Span};

use super::coefficients::{Amounts, Coefficients};
use super::diffuse::lambert;
use super::method::ShadePixel;
use super::normalisation::gain;
use super::reflection::{halfway_cross_normal, reflection_minus_light};
use super::shape::f_k;

/// One span, shaded by `lyon`.
pub struct LyonSpan<'a> {
    spec: &'a LyonSpec,
    span: &'a Span,
    start: DVec3,
    delta: DVec3,
    half_shininess: f64,
    coefficients: Coefficients,
}

impl<'a> LyonSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &'a LyonSpec, frame: &Frame, span: &'a Span) -> Self {
        let [start, end] = frame.end_normals(span);
        LyonSpan {
            spec,
            span,
            start,
            delta: end - start,
            half_shininess: f64::from(frame.material(span).shininess) / 2.0,
            coefficients: Coefficients::new(frame, span),
        }
    }

    /// n = g N' with N' = N0 + t(N1 - N0), about 1 long.
    pub fn normal(&self, i: u32) -> DVec3 {
        let interpolated = self.start + self.span.parameter(i) * self.delta;
        gain(self.spec, interpolated.length_squared()) * interpolated
    }

    /// f_k of D; none where the normal vanishes and has no direction (EXTREMES row 1).
    fn highlight(&self, normal: DVec3, light: DVec3) -> f64 {
        if normal == DVec3::ZERO {
            return 0.0;
        }
        let difference = match self.spec.difference {
            Difference::ReflectionMinusLight => reflection_minus_light(normal, light),
            Difference::HalfwayCrossNormal => halfway_cross_normal(normal, light),
        };
        f_k(self.half_shininess * difference.length_squared(), self.spec.squarings)
    }
}

impl ShadePixel for LyonSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let normal = self.normal(i);
        self.coefficients
            .sum(|light| Amounts { diffuse: lambert(normal, light.direction), specular: self.highlight(normal, light.direction) })
    }
}
