//! Spherical interpolation along the scan line, without rounding [lecture, eq. 4.7; methods A8
//! to A11].
use glam::DVec3;
use specula_scene::frame::EYE;
use specula_scene::{Arc, Frame, Span};
use specula_spec::SlerpSpec;

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::diffuse::lambert;
use crate::exact::formula::shape::power;

/// One span, shaded by `slerp`.
pub struct SlerpSpan<'a> {
    span: &'a Span,
    arc: Arc,
    /// The ends between which the normal is interpolated linearly, if slerp cannot be used.
    chord: Option<[DVec3; 2]>,
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> SlerpSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(slerp: &SlerpSpec, frame: &Frame, span: &'a Span) -> Self {
        let shininess = frame.material(span).shininess;
        let rotation = slerp.arc_rotation(frame, span);
        let chord = rotation.is_linear.then_some(rotation.axes);
        SlerpSpan {
            span,
            arc: slerp.arc(frame, span),
            chord,
            shininess,
            coefficients: Coefficients::new(frame, span),
        }
    }

    /// N = cos(tf) A + sin(tf) T, of unit length, or N (3 - N·N)/2 of the chord's normal; 0 where
    /// the span has no normal.
    pub fn normal(&self, i: u32) -> DVec3 {
        if let Some([start, end]) = self.chord {
            let normal = start.lerp(end, self.span.parameter(i));
            return (3.0 - normal.length_squared()) / 2.0 * normal;
        }
        let (sin, cos) = (self.span.parameter(i) * self.arc.angle).sin_cos();
        cos * self.arc.start + sin * self.arc.across
    }
}

impl ShadeSpan for SlerpSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let normal = self.normal(i);
        if normal == DVec3::ZERO {
            return self.coefficients.sum(|_| Amounts::default());
        }
        self.coefficients.sum(|light| {
            let base =
                2.0 * normal.dot(light.direction) * normal.dot(EYE) - light.direction.dot(EYE);
            Amounts {
                diffuse: lambert(normal, light.direction),
                specular: power(base.min(1.0), self.shininess),
            }
        })
    }
}
