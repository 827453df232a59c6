//! The fast Phong formulas, without rounding [lecture, eq. 4.3 to 4.6; methods A6, A7].
use glam::DVec3;
use specula_scene::frame::EYE;
use specula_scene::{Frame, Span};
use specula_spec::DirectSpec;
use specula_spec::direct::Root;

use super::ShadeSpan;
use super::coefficients::{Amounts, Coefficients};
use crate::exact::formula::newton;
use crate::exact::formula::shape::power;

/// One span, shaded by `direct`.
pub struct DirectSpan<'a> {
    span: &'a Span,
    ends: [DVec3; 2],
    /// |N| by Newton's method at each pixel, if the spec asks for it.
    lengths: Option<Vec<f64>>,
    shininess: u32,
    coefficients: Coefficients,
}

impl<'a> DirectSpan<'a> {
    /// Sets up a span of a frame.
    pub fn new(direct: &DirectSpec, frame: &Frame, span: &'a Span) -> Self {
        let (ends, shininess) = (frame.unit_end_normals(span), frame.material(span).shininess);
        let lengths = match direct.root {
            Root::Exact => None,
            Root::Newton => {
                Some(newton::lengths(ends, span.steps(), direct.newton_steps).collect())
            }
        };
        DirectSpan { span, ends, lengths, shininess, coefficients: Coefficients::new(frame, span) }
    }
}

impl ShadeSpan for DirectSpan<'_> {
    fn pixel(&self, i: u32) -> [f64; 3] {
        let normal = self.ends[0] + self.span.parameter(i) * (self.ends[1] - self.ends[0]);
        let q = normal.length_squared();
        if q <= 0.0 {
            return self.coefficients.sum(|_| Amounts::default());
        }
        let length = self.lengths.as_ref().map_or(q.sqrt(), |lengths| lengths[i as usize]);
        self.coefficients.sum(|light| {
            let (p, k) = (normal.dot(light.direction), normal.dot(EYE));
            let base = 2.0 * p * k / q - light.direction.dot(EYE);
            Amounts {
                diffuse: (p / length).clamp(0.0, 1.0),
                specular: power(base.min(1.0), self.shininess),
            }
        })
    }
}
