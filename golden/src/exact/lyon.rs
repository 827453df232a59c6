//! Lyon's method without rounding [Lyon, TR 43; METHODS.md B].
use glam::DVec3;
use specula_scene::spec::LyonSpec;
use specula_scene::spec::lyon::{Difference, Halfway};
use specula_scene::{Frame, Span};

use super::coefficients::{Amounts, Coefficients};
use super::diffuse::lambert;
use super::method::ShadePixel;
use super::normalisation::{g2, gain, unit};
use super::reflection::{halfway, halfway_cross_normal, light_reflection, projection, reflection_minus_light};
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
        let about_unit = unit_halfway(self.spec.halfway, light);
        let (difference, half_exponent) = match (self.spec.difference, about_unit) {
            (Difference::ReflectionMinusLight, _) => (reflection_minus_light(normal, light), self.half_shininess),
            (Difference::LightReflection, _) => (light_reflection(normal, light), self.half_shininess),
            (Difference::HalfwayProjection, _) => (projection(normal, halfway(light)), self.half_shininess),
            (Difference::HalfwayCrossNormal, _) => (halfway_cross_normal(normal, light), self.half_shininess),
            (Difference::UnitHalfwayMinusNormal, Some(h)) => (h - normal, 4.0 * self.half_shininess),
            (Difference::UnitHalfwayProjection, Some(h)) => (projection(normal, h), 4.0 * self.half_shininess),
            (Difference::UnitHalfwayMinusNormal | Difference::UnitHalfwayProjection, None) => return 0.0,
        };
        f_k(half_exponent * difference.length_squared(), self.spec.squarings)
    }
}

/// A half-way vector of about unit length [METHODS.md B6, B7]; `None` where it has no direction, L = -V (EXTREMES row 12).
fn unit_halfway(kind: Halfway, light: DVec3) -> Option<DVec3> {
    let h = halfway(light) / 2.0;
    match kind {
        Halfway::Unit => unit(h),
        Halfway::Half => Some(h),
        Halfway::HalfG2 => Some(g2(h.length_squared()) * h),
    }
}

impl ShadePixel for LyonSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let normal = self.normal(i);
        self.coefficients
            .sum(|light| Amounts { diffuse: lambert(normal, light.direction), specular: self.highlight(normal, light.direction) })
    }
}
