//! Set-up of a span for `hybrid`.
use glam::DVec3;
use specula_scene::frame::{EYE, Frame, Span};

use super::{HybridLight, HybridSpan, HybridSpec};
use crate::method_set_up::MethodSetUp;
use crate::quadratic::Quadratic;

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
        HybridSpan {
            denominator: Quadratic::squared_length(span, m, k)
                .quantised(self.hybrid.formats.accumulator),
            exponent: self.hybrid.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, span: &Span, normal: &[DVec3; 2], index: usize) -> HybridLight<i64> {
        let (f, l) = (&self.hybrid.formats, self.frame.lights[index].direction);
        let [start, step] = self.frame.gouraud(span, l).map(|x| f.diffuse_accumulator.quantise(x));
        HybridLight {
            numerator: Quadratic::reflected(span, *normal, EYE, l).quantised(f.accumulator),
            intensity_start: start,
            intensity_step: step,
        }
    }
}
