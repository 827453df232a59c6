//! Set-up of a span for `phong`.
use glam::DVec3;
use specula_scene::Wrap;
use specula_scene::frame::{DirectionalLight, EYE, Frame, LocalLight, Span};

use super::{
    Highlight, PhongFormats, PhongInputs, PhongLight, PhongSpec, Places, Way, wrap_to_eye,
    wrap_to_light,
};
use crate::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct PhongSetUp<'a> {
    pub phong: &'a PhongSpec,
    pub frame: &'a Frame,
}

impl SetUpSpan for PhongSetUp<'_> {
    fn append(&self, span: &Span, material: &MaterialInputs, out: &mut Vec<i64>) {
        let (f, frame) = (&self.phong.formats, self.frame);
        let step = span.weight_step();
        let (at_infinity, local) = material.lights.split_at(frame.lights.len());
        let at_infinity =
            frame.lights.iter().zip(at_infinity).map(|(light, c)| self.at_infinity(light, c));
        let local =
            frame.local_lights.iter().zip(local).map(|(light, c)| self.at_a_place(span, light, c));
        let inputs = PhongInputs {
            normal: straight(f, frame.end_normals(span)),
            weight_step: f.weight_accumulator.quantise(step),
            shininess: i64::from(
                frame.material(span).shininess * self.phong.highlight.exponent_factor(),
            ),
            eye: frame.eye.map(|eye| self.to_eye(span, eye)),
            ambient: material.ambient,
            lights: at_infinity.chain(local).collect(),
        };
        inputs.append_to(out);
    }
}

impl PhongSetUp<'_> {
    fn at_infinity(
        &self,
        light: &DirectionalLight,
        &Coefficients { diffuse, specular }: &Coefficients,
    ) -> PhongLight<i64> {
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
            diffuse,
            specular,
        }
    }

    fn to_eye(&self, span: &Span, eye: DVec3) -> Way<i64> {
        let (f, frame) = (&self.phong.formats, self.frame);
        match self.phong.places {
            Places::Exact => straight(f, frame.end_vectors_to(span, eye)),
            Places::Wrapped => wrapped(f, wrap_to_eye(frame, span, eye)),
        }
    }

    fn at_a_place(
        &self,
        span: &Span,
        light: &LocalLight,
        &Coefficients { diffuse, specular }: &Coefficients,
    ) -> PhongLight<i64> {
        let (f, frame) = (&self.phong.formats, self.frame);
        let exact = self.phong.places == Places::Exact;
        PhongLight {
            direction: None,
            way: Some(match self.phong.places {
                Places::Exact => straight(f, frame.end_vectors_to(span, light.position)),
                Places::Wrapped => wrapped(f, wrap_to_light(frame, span, light)),
            }),
            axis: light
                .spot
                .as_ref()
                .filter(|_| exact)
                .map(|spot| f.vector.quantise_vector(spot.axis)),
            exponent: light.spot.as_ref().map(|spot| i64::from(spot.exponent)),
            light_dot_view: None,
            halfway_gain: None,
            diffuse,
            specular,
        }
    }
}

/// A vector along the span, by its values at the ends.
fn straight(formats: &PhongFormats, ends: [DVec3; 2]) -> Way<i64> {
    let [start, end] = ends.map(|v| formats.vector.quantise_vector(v));
    Way { start, delta: std::array::from_fn(|i| end[i] - start[i]), axis: None }
}

/// H along the span, and what it is wrapped around.
fn wrapped(formats: &PhongFormats, Wrap { ends, axis }: Wrap) -> Way<i64> {
    let [start, end] = ends.map(|v| formats.vector_sum().quantise_vector(v + axis));
    Way {
        start,
        delta: std::array::from_fn(|i| end[i] - start[i]),
        axis: Some(formats.vector.quantise_vector(axis)),
    }
}
