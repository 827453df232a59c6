//! Hast's reflection shading without rounding [Hast, Barrera and Bengtsson, eq. 27 to 34;
//! methods C4 to C6 and C12 to C14].
use glam::DVec3;
use specula_scene::frame::{EYE, halfway};
use specula_scene::{Frame, Span};
use specula_spec::ReflectionSpec;
use specula_spec::reflection::Highlight;

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::hast::base;
use crate::exact::formula::shape::power;

/// One span, shaded by `reflection`.
pub struct ReflectionSpan<'a> {
    highlight: Highlight,
    span: &'a Span,
    /// Unit normals at the ends.
    units: [DVec3; 2],
    /// The fixed normal n, if there is one.
    fixed: Option<DVec3>,
    /// The interpolated normals, for the hybrid's highlight.
    normals: [DVec3; 2],
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> ReflectionSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(spec: &ReflectionSpec, frame: &'a Frame, span: &'a Span) -> Self {
        ReflectionSpan {
            highlight: spec.specular,
            span,
            units: frame.unit_end_normals(span),
            fixed: spec.bisector.fixed_normal(frame, span),
            normals: frame.end_normals(span),
            shininess: frame.material(span).shininess,
            coefficients: Coefficients::new(frame, span),
        }
    }

    fn highlight(&self, wrapped: Option<DVec3>, interpolated: DVec3, light: DVec3) -> f64 {
        let n = self.shininess;
        match (self.highlight, wrapped) {
            (Highlight::Hybrid, _) => power(base(interpolated, light), n),
            (_, None) => 0.0,
            (Highlight::Blinn, Some(normal)) => power(normal.dot(halfway(light)).min(1.0), 4 * n),
            (Highlight::Eq34, Some(normal)) => {
                power((2.0 * normal.dot(EYE) * normal.dot(light) - light.dot(EYE)).min(1.0), n)
            }
        }
    }
}

impl ShadeSpan for ReflectionSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let t = self.span.parameter(i);
        let at = |[start, end]: [DVec3; 2]| start + t * (end - start);
        let wrapped = self.fixed.map(|n| wrap(at(self.units), n));
        let interpolated = at(self.normals);
        self.coefficients.sum(|light| Amounts {
            diffuse: wrapped.map_or(0.0, |normal| normal.dot(light.direction).clamp(0.0, 1.0)),
            specular: self.highlight(wrapped, interpolated, light.direction),
        })
    }
}

/// N' = 2H(H·n)/(H·H) - n with H = n + N, a unit vector: n reflected about the direction half-way
/// to N [Hast et al., eq. 27].
pub fn wrap(normal: DVec3, fixed: DVec3) -> DVec3 {
    let h = normal + fixed;
    2.0 * h * (h.dot(fixed) / h.length_squared()) - fixed
}
