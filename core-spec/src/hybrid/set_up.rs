//! Set-up of a span for `hybrid`.
use glam::DVec3;
use specula_scene::frame::{EYE, Frame, Span};

use super::{HybridLight, HybridSpan, HybridSpec};
use crate::gouraud::LitPoint;
use crate::method_set_up::MethodSetUp;
use crate::quadratic::Quadratic;
use crate::ways::Ways;

/// Sets up the spans of a frame.
pub(super) struct HybridSetUp<'a> {
    pub hybrid: &'a HybridSpec,
    pub frame: &'a Frame,
}

impl MethodSetUp for HybridSetUp<'_> {
    type SpanGroup = HybridSpan<i64>;
    type LightGroup = HybridLight<i64>;
    /// m and k of N = m + k i.
    type Geometry = [DVec3; 2];

    fn geometry(&self, span: &Span) -> [DVec3; 2] {
        self.frame.normal_and_step(span)
    }

    fn span_inputs(&self, span: &Span, &[m, k]: &[DVec3; 2]) -> HybridSpan<i64> {
        let (sends_ways, ways) = (self.hybrid.places.sends_ways(self.frame), self.ways(span));
        HybridSpan {
            denominator: Quadratic::squared_length(span, m, k)
                .quantised(self.hybrid.formats.accumulator),
            view: (sends_ways && self.frame.eye.is_none()).then(|| ways.linear([m, k], EYE)),
            eye: ways.eye_cosine([m, k]).filter(|_| sends_ways),
            exponent: self.hybrid.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, span: &Span, normal: &[DVec3; 2], index: usize) -> HybridLight<i64> {
        let sends_ways = self.hybrid.places.sends_ways(self.frame);
        let ways = self.ways(span);
        let format = self.hybrid.formats.diffuse_accumulator;
        let [start, step] = self.intensity(span, index).map(|x| format.quantise(x));
        HybridLight {
            numerator: (!sends_ways).then(|| self.numerator(span, normal, index)),
            way: sends_ways.then(|| ways.light_cosine(*normal, index, ways.way_to_light(index))),
            intensity_start: start,
            intensity_step: step,
        }
    }
}

impl HybridSetUp<'_> {
    fn ways<'a>(&'a self, span: &'a Span) -> Ways<'a> {
        Ways { frame: self.frame, span, accumulator: self.hybrid.formats.accumulator }
    }

    fn numerator(&self, span: &Span, normal: &[DVec3; 2], index: usize) -> Quadratic<i64> {
        let l = self.frame.lights[index].direction;
        Quadratic::reflected(span, *normal, EYE, l).quantised(self.hybrid.formats.accumulator)
    }

    /// Gouraud's intensity at the first pixel and its step, of what each vertex sees.
    fn intensity(&self, span: &Span, index: usize) -> [f64; 2] {
        let triangle = &self.frame.triangles[span.triangle];
        let at_vertex = |v: usize| {
            LitPoint::new(self.frame, triangle.normals[v], triangle.positions[v]).diffuse(index)
        };
        self.frame.interpolated(span, [0, 1, 2].map(at_vertex))
    }
}
