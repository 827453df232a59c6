//! Set-up of a span for `reflection`.
use glam::DVec3;
use specula_scene::frame::{DirectionalLight, EYE, Frame, Span, halfway};

use super::{Highlight, ReflectionInputs, ReflectionLight, ReflectionSpec};
use crate::Quadratic;
use crate::set_up::{Coefficients, MaterialInputs, SetUpSpan};

/// Sets up the spans of a frame.
pub(super) struct ReflectionSetUp<'a> {
    pub reflection: &'a ReflectionSpec,
    pub frame: &'a Frame,
}

/// One span's H(i) = m + k i, and n; all of them 0 where there is no n.
struct Halfway<'a> {
    span: &'a Span,
    m: DVec3,
    k: DVec3,
    n: DVec3,
}

impl<'a> Halfway<'a> {
    fn new(reflection: &ReflectionSpec, frame: &Frame, span: &'a Span) -> Halfway<'a> {
        let [start, end] = frame.unit_end_normals(span);
        match reflection.bisector.of(frame, span) {
            Some(n) => Halfway {
                span,
                m: (start + n) / 2.0,
                k: (end - start) / (2.0 * f64::from(span.steps().max(1))),
                n,
            },
            None => Halfway { span, m: DVec3::ZERO, k: DVec3::ZERO, n: DVec3::ZERO },
        }
    }

    /// q N'·u = 2(H·n)(H·u) - (n·u) q.
    fn times(&self, u: DVec3) -> Quadratic<f64> {
        Quadratic::reflected(self.span, [self.m, self.k], self.n, u)
    }
}

impl SetUpSpan for ReflectionSetUp<'_> {
    fn append(&self, span: &Span, material: &MaterialInputs, out: &mut Vec<i64>) {
        let (spec, accumulator) = (self.reflection, self.reflection.formats.accumulator);
        let h = Halfway::new(spec, self.frame, span);
        let [m, k] = self.frame.normal_and_step(span);
        let lights = self.frame.lights.iter().zip(&material.lights);
        let inputs = ReflectionInputs {
            denominator: Quadratic::squared_length(span, h.m, h.k).quantised(accumulator),
            view: spec.only_with(Highlight::Eq34, || h.times(EYE).quantised(accumulator)),
            normal_squared: spec.only_with(Highlight::Hybrid, || {
                Quadratic::squared_length(span, m, k).quantised(accumulator)
            }),
            exponent: spec.power_unit().input(self.frame.material(span).shininess),
            ambient: material.ambient,
            lights: lights
                .map(|(light, coefficients)| self.light(&h, [m, k], light, coefficients))
                .collect(),
        };
        inputs.append_to(out);
    }
}

impl ReflectionSetUp<'_> {
    fn light(
        &self,
        h: &Halfway,
        normal: [DVec3; 2],
        light: &DirectionalLight,
        &Coefficients { diffuse, specular }: &Coefficients,
    ) -> ReflectionLight<i64> {
        let (spec, f, l) = (self.reflection, &self.reflection.formats, light.direction);
        let quantised = |quadratic: Quadratic<f64>| quadratic.quantised(f.accumulator);
        ReflectionLight {
            cosine: quantised(h.times(l)),
            halfway: spec.only_with(Highlight::Blinn, || quantised(h.times(halfway(l)))),
            numerator: spec.only_with(Highlight::Hybrid, || {
                quantised(Quadratic::reflected(h.span, normal, EYE, l))
            }),
            dot_view: spec.only_with(Highlight::Eq34, || f.cosine.quantise(l.dot(EYE))),
            diffuse,
            specular,
        }
    }
}
