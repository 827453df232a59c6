//! Set-up of a span for `direct`.
use glam::DVec3;
use specula_scene::frame::{EYE, Frame, Span};

use super::{DirectLight, DirectSpan, DirectSpec, Ends};
use crate::method_set_up::MethodSetUp;

/// Sets up the spans of a frame.
pub(super) struct DirectSetUp<'a> {
    pub direct: &'a DirectSpec,
    pub frame: &'a Frame,
}

impl MethodSetUp for DirectSetUp<'_> {
    type SpanGroup = DirectSpan<i64>;
    type LightGroup = DirectLight<i64>;
    /// A and B.
    type Geometry = [DVec3; 2];

    fn geometry(&self, span: &Span) -> [DVec3; 2] {
        self.frame.unit_end_normals(span)
    }

    fn span_inputs(&self, span: &Span, normals: &[DVec3; 2]) -> DirectSpan<i64> {
        let f = &self.direct.formats;
        DirectSpan {
            weight_step: f.weight_accumulator.quantise(span.weight_step()),
            spread: f.spread.quantise((normals[1] - normals[0]).length_squared()),
            view: self.ends(normals, EYE),
            exponent: self.direct.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, _span: &Span, normals: &[DVec3; 2], index: usize) -> DirectLight<i64> {
        let l = self.frame.lights[index].direction;
        let l_dot_v = if normals[0] == DVec3::ZERO { 1.0 } else { l.dot(EYE) };
        DirectLight {
            light: self.ends(normals, l),
            light_dot_view: self.direct.formats.component.quantise(l_dot_v),
        }
    }
}

impl DirectSetUp<'_> {
    /// N·`x` at both ends, each rounded, so that what lies between never leaves what they are.
    fn ends(&self, normals: &[DVec3; 2], x: DVec3) -> Ends<i64> {
        let component = self.direct.formats.component;
        let [start, end] = normals.map(|n| component.quantise(n.dot(x).clamp(-1.0, 1.0)));
        Ends { start, delta: end - start }
    }
}
