//! Set-up of a span for `direct`.
use glam::DVec3;
use specula_scene::frame::{EYE, Frame, Span};

use super::{DirectLight, DirectSpan, DirectSpec, Ends};
use crate::increments::Increments;
use crate::linear::Linear;
use crate::method_set_up::MethodSetUp;
use crate::ways::Ways;

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
        let has_eye = self.direct.places.sends_ways(self.frame) && self.frame.eye.is_some();
        let f = &self.direct.formats;
        DirectSpan {
            weight_step: f.weight_accumulator.quantise(span.weight_step()),
            spread: f.spread.quantise((normals[1] - normals[0]).length_squared()),
            view: (!has_eye).then(|| self.ends(span, normals, EYE)),
            eye: has_eye
                .then(|| self.ways(span).eye_cosine(span.start_and_step(*normals)))
                .flatten(),
            exponent: self.direct.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, span: &Span, normals: &[DVec3; 2], index: usize) -> DirectLight<i64> {
        if self.direct.places.sends_ways(self.frame) {
            let ways = self.ways(span);
            // Without a normal there is no light, nor a highlight of L·V alone.
            let is_dark = normals[0] == DVec3::ZERO;
            let to_light = if is_dark { [DVec3::ZERO; 2] } else { ways.way_to_light(index) };
            let way = ways.light_cosine(span.start_and_step(*normals), index, to_light);
            return DirectLight { light: None, way: Some(way), light_dot_view: None };
        }
        let l = self.frame.lights[index].direction;
        let l_dot_v = if normals[0] == DVec3::ZERO { 1.0 } else { l.dot(EYE) };
        DirectLight {
            light: Some(self.ends(span, normals, l)),
            way: None,
            light_dot_view: Some(self.direct.formats.component.quantise(l_dot_v)),
        }
    }
}

impl DirectSetUp<'_> {
    fn ways<'a>(&'a self, span: &'a Span) -> Ways<'a> {
        Ways { frame: self.frame, span, accumulator: self.direct.formats.way_accumulator }
    }

    /// What is sent of N·`x`.
    fn ends(&self, span: &Span, normals: &[DVec3; 2], x: DVec3) -> Ends<i64> {
        let [start, end] = normals.map(|n| n.dot(x).clamp(-1.0, 1.0));
        match self.direct.increments {
            // Both ends are rounded, so that what lies between never leaves what they are.
            Increments::Multiplied => {
                let [start, end] =
                    [start, end].map(|value| self.direct.formats.component.quantise(value));
                Ends { start, change: end - start }
            }
            Increments::Added => {
                let [_, step] = span.start_and_step(*normals);
                let Linear { start, step } = Linear::new(span, start, step.dot(x))
                    .quantised(self.direct.formats.scalar_accumulator);
                Ends { start, change: step }
            }
        }
    }
}
