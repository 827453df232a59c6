//! Set-up of a span for `reflection`.
use glam::DVec3;
use specula_scene::frame::{EYE, Frame, Span, halfway};

use super::{
    Highlight, ReflectedEye, ReflectedLight, ReflectionLight, ReflectionSpan, ReflectionSpec,
};
use crate::method_set_up::MethodSetUp;
use crate::quadratic::Quadratic;
use crate::ways::Ways;

/// Sets up the spans of a frame.
pub(super) struct ReflectionSetUp<'a> {
    pub reflection: &'a ReflectionSpec,
    pub frame: &'a Frame,
}

/// One span's N, H(i) = m + k i, and n; H and n are 0 where there is no n.
pub(super) struct Halfway {
    /// m and k of N.
    normal: [DVec3; 2],
    m: DVec3,
    k: DVec3,
    n: DVec3,
}

impl Halfway {
    fn new(reflection: &ReflectionSpec, frame: &Frame, span: &Span) -> Halfway {
        let normal = frame.normal_and_step(span);
        let [start, end] = frame.unit_end_normals(span);
        match reflection.bisector.fixed_normal(frame, span) {
            Some(n) => Halfway {
                normal,
                m: (start + n) / 2.0,
                k: (end - start) / (2.0 * f64::from(span.steps().max(1))),
                n,
            },
            None => Halfway { normal, m: DVec3::ZERO, k: DVec3::ZERO, n: DVec3::ZERO },
        }
    }

    /// q N'·u = 2(H·n)(H·u) - (n·u) q.
    fn cosine_numerator(&self, span: &Span, u: DVec3) -> Quadratic<f64> {
        Quadratic::reflected(span, [self.m, self.k], self.n, u)
    }
}

impl MethodSetUp for ReflectionSetUp<'_> {
    type SpanGroup = ReflectionSpan<i64>;
    type LightGroup = ReflectionLight<i64>;
    type Geometry = Halfway;

    fn geometry(&self, span: &Span) -> Halfway {
        Halfway::new(self.reflection, self.frame, span)
    }

    fn span_inputs(&self, span: &Span, h: &Halfway) -> ReflectionSpan<i64> {
        let (spec, accumulator) = (self.reflection, self.reflection.formats.accumulator);
        let [m, k] = h.normal;
        let (sends_ways, ways) = (spec.places.sends_ways(self.frame), self.ways(span));
        let has_eye = sends_ways && self.frame.eye.is_some();
        let is_hybrid = spec.specular == Highlight::Hybrid;
        let looks_at_the_eye = spec.specular == Highlight::Eq34 || (sends_ways && !is_hybrid);
        ReflectionSpan {
            denominator: Quadratic::squared_length(span, h.m, h.k).quantised(accumulator),
            h_dot_n: sends_ways.then(|| ways.linear([h.m, h.k], h.n)),
            view: (looks_at_the_eye && !has_eye)
                .then(|| h.cosine_numerator(span, EYE).quantised(accumulator)),
            eye: has_eye.then(|| {
                let way = ways.way_to_eye();
                ReflectedEye {
                    bisecting: ways.product([h.m, h.k], way),
                    fixed: ways.linear(way, h.n),
                    normal: is_hybrid.then(|| ways.product(h.normal, way)),
                    squared: ways.product(way, way),
                }
            }),
            normal_view: (sends_ways && is_hybrid && !has_eye).then(|| ways.linear(h.normal, EYE)),
            normal_squared: spec.only_with(Highlight::Hybrid, || {
                Quadratic::squared_length(span, m, k).quantised(accumulator)
            }),
            exponent: spec.power_unit().exponent(self.frame.material(span).shininess),
        }
    }

    fn light_inputs(&self, span: &Span, h: &Halfway, index: usize) -> ReflectionLight<i64> {
        let (spec, f) = (self.reflection, &self.reflection.formats);
        if spec.places.sends_ways(self.frame) {
            return ReflectionLight::of_way(self.way(span, h, index));
        }
        let l = self.frame.lights[index].direction;
        let quantised = |quadratic: Quadratic<f64>| quadratic.quantised(f.accumulator);
        ReflectionLight {
            cosine: Some(quantised(h.cosine_numerator(span, l))),
            way: None,
            halfway: spec
                .only_with(Highlight::Blinn, || quantised(h.cosine_numerator(span, halfway(l)))),
            numerator: spec.only_with(Highlight::Hybrid, || {
                quantised(Quadratic::reflected(span, h.normal, EYE, l))
            }),
            dot_view: spec.only_with(Highlight::Eq34, || f.cosine.quantise(l.dot(EYE))),
        }
    }
}

impl ReflectionSetUp<'_> {
    fn ways<'a>(&'a self, span: &'a Span) -> Ways<'a> {
        Ways { frame: self.frame, span, accumulator: self.reflection.formats.accumulator }
    }

    fn way(&self, span: &Span, h: &Halfway, index: usize) -> ReflectedLight<i64> {
        let ways = self.ways(span);
        let way = ways.way_to_light(index);
        ReflectedLight {
            bisecting: ways.product([h.m, h.k], way),
            fixed: ways.linear(way, h.n),
            normal: self.reflection.only_with(Highlight::Hybrid, || ways.product(h.normal, way)),
            way: ways.light(index, way),
        }
    }
}
