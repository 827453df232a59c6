//! The core of Hast's reflection shading.
use specula_scene::spec::reflection::{Highlight, ReflectionLight, ReflectionSpec};
use specula_scene::spec::{CoreSpec, Quadratic};

use super::finish;
use super::forward::Forward;
use crate::builder::{Builder, Sig, TooWide};
use crate::design::Design;
use crate::units::{self, Base, Light, QuotientFormat};

/// |H|² is no smaller along any span, except those where it and all numerators are 0.
const SMALLEST_SQUARE: f64 = 0.25;

/// Quotients of quadratics by forward differences, all by one reciprocal. [Hast et al., eq. 27 to 34]
pub(super) fn core(b: Builder, spec: &CoreSpec, reflection: &ReflectionSpec) -> Result<Design, TooWide> {
    let control = b.control();
    let inputs = reflection.inputs(spec).map(|port| b.input(port));
    let f = &reflection.formats;
    let forward = Forward { b: &b, first: &control.start, steps: spec.longest_span - 1 };
    let q = forward.quadratic("denominator", &inputs.denominator, (0.0, 1.0), f.operand.fraction_bits).named("q");
    let to = QuotientFormat { integer_bits: 2, fraction_bits: f.reciprocal.fraction_bits };
    let reciprocal = b.instance("reciprocal", || units::quotient(&b, &b.integer(1), &q, to, SMALLEST_SQUARE)).named("w");
    let has_direction = b.integer(0).less_than(&q).named("has_direction");
    let exponent = &inputs.exponent;
    let mut pixel = Pixel { forward, spec, reflection, q, reciprocal, has_direction, view: None, normal_squared: None, exponent };
    pixel.view = inputs.view.as_ref().map(|view| pixel.cosine("view", view));
    let normal_squared =
        |square| pixel.forward.quadratic("normal_squared", square, (0.0, 1.0), f.operand.fraction_bits).named("normal_squared");
    pixel.normal_squared = inputs.normal_squared.as_ref().map(normal_squared);
    let lights: Vec<Light> = inputs.lights.iter().enumerate().map(|(i, light)| pixel.shade(i, light)).collect();
    finish(&b, &control, &inputs.ambient, &lights)
}

/// What the lights have in common.
struct Pixel<'a> {
    forward: Forward<'a>,
    spec: &'a CoreSpec,
    reflection: &'a ReflectionSpec,
    q: Sig,
    /// 1/q.
    reciprocal: Sig,
    has_direction: Sig,
    /// N'·V, where the highlight asks for it.
    view: Option<Sig>,
    /// N·N, where the highlight asks for it.
    normal_squared: Option<Sig>,
    exponent: &'a Sig,
}

impl Pixel<'_> {
    fn operand(&self, instance: &str, numerator: &Quadratic<Sig>) -> Sig {
        self.forward.quadratic(instance, numerator, (-1.0, 1.0), self.reflection.formats.operand.fraction_bits)
    }

    /// N'·u, of its numerator.
    fn cosine(&self, called: &str, numerator: &Quadratic<Sig>) -> Sig {
        let p = self.operand(&format!("{called}_numerator"), numerator);
        let (b, fraction_bits) = (self.forward.b, self.reflection.formats.cosine.fraction_bits);
        b.instance(&format!("{called}_cosine"), || {
            units::cosine_by_reciprocal(b, &p, &self.q, &self.reciprocal, SMALLEST_SQUARE, fraction_bits)
        })
    }

    fn shade(&self, index: usize, light: &ReflectionLight<Sig>) -> Light {
        let called = |unit: &str| format!("light{index}_{unit}");
        let (b, f) = (self.forward.b, &self.reflection.formats);
        let cosine = self.cosine(&format!("light{index}"), &light.cosine);
        let base = self.base(&called, light, &cosine);
        let power = || units::raised(b, &base, self.exponent, self.reflection.power_unit());
        Light {
            diffuse: b.instance(&called("diffuse"), || units::amount(b, &cosine, f.diffuse.fraction_bits)),
            specular: b.instance(&called("power"), power),
            diffuse_coefficients: light.diffuse.clone(),
            specular_coefficients: light.specular.clone(),
        }
    }

    fn base(&self, called: &impl Fn(&str) -> String, light: &ReflectionLight<Sig>, cosine: &Sig) -> Sig {
        let (b, fraction_bits) = (self.forward.b, self.reflection.formats.base.fraction_bits);
        let given = "inputs are those that the highlight asks for";
        match self.reflection.specular {
            Highlight::Blinn => {
                let cosine = self.cosine(&called("halfway"), light.halfway.as_ref().expect(given));
                b.instance(&called("base"), || units::amount(b, &cosine, fraction_bits))
            }
            Highlight::Hybrid => {
                let p = self.operand(&called("hybrid_numerator"), light.numerator.as_ref().expect(given));
                let smallest_q = self.spec.shortest_normal * self.spec.shortest_normal;
                let q = self.normal_squared.as_ref().expect(given);
                b.instance(&called("divider"), || units::divider(b, &p, q, fraction_bits, smallest_q))
            }
            Highlight::Eq34 => {
                let (v, dot_view) = (self.view.as_ref().expect(given), light.dot_view.as_ref().expect(given));
                let to = Base { fraction_bits, product_error: f64::INFINITY };
                b.instance(&called("base"), || units::reflected_base(b, (v, cosine), dot_view, &self.has_direction, to))
            }
        }
    }
}
