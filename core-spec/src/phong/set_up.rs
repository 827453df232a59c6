//! Set-up of a span for `phong`.
use glam::DVec3;
use specula_scene::Wrap;
use specula_scene::frame::{DirectionalLight, EYE, Frame, LocalLight, Span};

use super::{Highlight, PhongLight, PhongSpan, PhongSpec, Places, Way};
use crate::increments::Increments;
use crate::method_set_up::MethodSetUp;

/// Sets up the spans of a frame.
pub(super) struct PhongSetUp<'a> {
    pub phong: &'a PhongSpec,
    pub frame: &'a Frame,
}

impl MethodSetUp for PhongSetUp<'_> {
    type SpanGroup = PhongSpan<i64>;
    type LightGroup = PhongLight<i64>;
    type Geometry = ();

    fn geometry(&self, _span: &Span) {}

    fn span_inputs(&self, span: &Span, (): &()) -> PhongSpan<i64> {
        let (f, frame) = (&self.phong.formats, self.frame);
        let shininess = frame.material(span).shininess;
        PhongSpan {
            normal: self.straight(span, frame.end_normals(span)),
            weight_step: (self.phong.increments == Increments::Multiplied)
                .then(|| f.weight_accumulator.quantise(span.weight_step())),
            shininess: i64::from(shininess * self.phong.highlight.exponent_factor()),
            eye: frame.eye.map(|eye| self.to_eye(span, eye)),
        }
    }

    fn light_inputs(&self, span: &Span, (): &(), index: usize) -> PhongLight<i64> {
        match index.checked_sub(self.frame.lights.len()) {
            None => self.at_infinity(&self.frame.lights[index]),
            Some(local) => self.at_a_place(span, &self.frame.local_lights[local]),
        }
    }
}

impl PhongSetUp<'_> {
    fn at_infinity(&self, light: &DirectionalLight) -> PhongLight<i64> {
        let (f, l) = (&self.phong.formats, light.direction);
        let constant = self.frame.eye.is_none();
        let in_reflection = self.phong.highlight == Highlight::Reflection;
        PhongLight {
            direction: Some(f.vector.quantise_vector(l)),
            way: None,
            axis: None,
            exponent: None,
            light_dot_view: (constant && in_reflection).then(|| f.cosine.quantise(l.dot(EYE))),
            // Where L = -V the gain saturates, and H = 0 makes nothing of it (extremes row 12).
            halfway_gain: (constant && !in_reflection)
                .then(|| f.gain.quantise((l + EYE).length().recip())),
        }
    }

    fn to_eye(&self, span: &Span, eye: DVec3) -> Way<i64> {
        match self.phong.places {
            Places::Exact => self.straight(span, self.frame.end_vectors_to(span, eye)),
            Places::Wrapped => self.wrapped(span, Wrap::to_eye(self.frame, span, eye)),
        }
    }

    fn at_a_place(&self, span: &Span, light: &LocalLight) -> PhongLight<i64> {
        let (f, frame) = (&self.phong.formats, self.frame);
        let exact = self.phong.places == Places::Exact;
        PhongLight {
            direction: None,
            way: Some(match self.phong.places {
                Places::Exact => self.straight(span, frame.end_vectors_to(span, light.position)),
                Places::Wrapped => self.wrapped(span, Wrap::to_light(frame, span, light)),
            }),
            axis: light
                .spot
                .as_ref()
                .filter(|_| exact)
                .map(|spot| f.vector.quantise_vector(spot.axis)),
            exponent: light.spot.as_ref().map(|spot| i64::from(spot.exponent)),
            light_dot_view: None,
            halfway_gain: None,
        }
    }

    /// A vector along the span, by its values at the ends.
    fn straight(&self, span: &Span, ends: [DVec3; 2]) -> Way<i64> {
        let [start, delta] = self.phong.span_vectors().quantised(span, ends);
        Way { start, delta, axis: None }
    }

    /// H along the span, and what it is wrapped around.
    fn wrapped(&self, span: &Span, Wrap { ends, axis }: Wrap) -> Way<i64> {
        Way {
            axis: Some(self.phong.formats.vector.quantise_vector(axis)),
            ..self.straight(span, ends.map(|end| end + axis))
        }
    }
}
