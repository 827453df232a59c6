//! Set-up of a span for `duff`.
use glam::DVec3;
use specula_scene::frame::{EYE, Frame, Span, halfway};

use super::{DuffLight, DuffSpan, DuffSpec, Highlight};
use crate::linear::Linear;
use crate::method_set_up::MethodSetUp;
use crate::quadratic::Quadratic;
use crate::ways::{LightCosine, Ways};

/// Sets up the spans of a frame.
pub(super) struct DuffSetUp<'a> {
    pub duff: &'a DuffSpec,
    pub frame: &'a Frame,
}

impl MethodSetUp for DuffSetUp<'_> {
    type SpanGroup = DuffSpan<i64>;
    type LightGroup = DuffLight<i64>;
    /// m and k of N = m + k i.
    type Geometry = [DVec3; 2];

    fn geometry(&self, span: &Span) -> [DVec3; 2] {
        self.frame.normal_and_step(span)
    }

    fn span_inputs(&self, span: &Span, normal: &[DVec3; 2]) -> DuffSpan<i64> {
        let [m, k] = *normal;
        let sends_ways = self.duff.places.sends_ways(self.frame);
        let has_eye = sends_ways && self.frame.eye.is_some();
        let looks_at_the_eye = self.duff.specular.looks_at_the_eye() || sends_ways;
        DuffSpan {
            denominator: Quadratic::squared_length(span, m, k)
                .quantised(self.duff.formats.accumulator),
            view: (looks_at_the_eye && !has_eye).then(|| self.linear(span, normal, EYE)),
            eye: has_eye.then(|| self.ways(span).eye_cosine(*normal)).flatten(),
            exponent: self.duff.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, span: &Span, normal: &[DVec3; 2], index: usize) -> DuffLight<i64> {
        if self.duff.places.sends_ways(self.frame) {
            let way = Some(self.way(span, *normal, index));
            return DuffLight { cosine: None, way, halfway: None, numerator: None, dot_view: None };
        }
        let (f, l) = (&self.duff.formats, self.frame.lights[index].direction);
        let highlight = self.duff.specular;
        let numerator = || Quadratic::reflected(span, *normal, EYE, l).quantised(f.accumulator);
        DuffLight {
            cosine: Some(self.linear(span, normal, l)),
            way: None,
            halfway: (highlight == Highlight::Blinn).then(|| self.linear(span, normal, halfway(l))),
            numerator: (highlight == Highlight::Quotient).then(numerator),
            dot_view: highlight.looks_at_the_eye().then(|| f.cosine.quantise(l.dot(EYE))),
        }
    }
}

impl DuffSetUp<'_> {
    fn ways<'a>(&'a self, span: &'a Span) -> Ways<'a> {
        Ways { frame: self.frame, span, accumulator: self.duff.formats.accumulator }
    }

    fn way(&self, span: &Span, normal: [DVec3; 2], index: usize) -> LightCosine<i64> {
        let ways = self.ways(span);
        ways.light_cosine(normal, index, ways.way_to_light(index))
    }

    /// (m + k i)·u.
    fn linear(&self, span: &Span, [m, k]: &[DVec3; 2], u: DVec3) -> Linear<i64> {
        Linear::new(span, m.dot(u), k.dot(u)).quantised(self.duff.formats.linear_accumulator)
    }
}
