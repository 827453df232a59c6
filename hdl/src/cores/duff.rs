//! Duff's core, with Hast's highlights.
use specula_spec::duff::{DuffInputs, DuffLight, DuffSpec, Highlight};
use specula_spec::{CoreParameters, InputPort};

use super::common::{Intensities, finish, squared_normal, time_slots};
use super::forward::Forward;
use crate::units::{self, Base, Length, QuotientFormat};
use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::graph::Graph;

/// Diffuse p/√q by forward differences, and a highlight of the same q and root. [Hast et al., eq. 3
/// to 8, 17, 33 and 34]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    duff: &DuffSpec,
    ports: &DuffInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let inputs = ports.map(|port| b.input(port));
    let f = &duff.formats;
    let forward = Forward { b: &b, first: &slots.first_pixel, steps: parameters.longest_span - 1 };
    let q = forward
        .quadratic("denominator", &inputs.span.denominator, (0.0, 1.0), f.operand.fraction_bits)
        .named("q");
    let q = squared_normal(q, parameters);
    let length = b.instance("root", || units::root(&b, &q, f.root));
    let view = inputs
        .span
        .view
        .as_ref()
        .map(|view| forward.linear("view", view, f.operand.fraction_bits).named("n_dot_v"));
    let view_cosine = view.as_ref().filter(|_| duff.specular == Highlight::Eq34).map(|view| {
        b.instance("view_cosine", || units::cosine(&b, view, &length, f.cosine.fraction_bits))
    });
    let exponent = &inputs.span.exponent;
    let pixel = Pixel {
        forward,
        duff,
        length: &length,
        view: view.as_ref(),
        view_cosine: view_cosine.as_ref(),
        exponent,
    };
    finish(&b, &slots, &inputs, |i, light| pixel.shade(i, light))
}

/// What the lights have in common.
struct Pixel<'a> {
    forward: Forward<'a>,
    duff: &'a DuffSpec,
    length: &'a Length,
    /// N·V, where the highlight asks for it.
    view: Option<&'a Sig>,
    /// That of the unit normal, where the highlight asks for it.
    view_cosine: Option<&'a Sig>,
    exponent: &'a Sig,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &DuffLight<Sig>) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        let (b, f) = (self.forward.b, &self.duff.formats);
        let p = self
            .forward
            .linear(&called("p"), &light.cosine, f.operand.fraction_bits)
            .named(&called("p"));
        let cosine = b.instance(&called("cosine"), || {
            units::cosine(b, &p, self.length, f.cosine.fraction_bits)
        });
        let base = self.base(&called, light, (&p, &cosine));
        let power = || units::raised(b, &base, self.exponent, self.duff.power_unit());
        Intensities {
            diffuse: b.instance(&called("diffuse"), || {
                units::clamp_nonnegative(b, &cosine, f.diffuse.fraction_bits)
            }),
            specular: b.instance(&called("power"), power),
        }
    }

    fn base(
        &self,
        called: &impl Fn(&str) -> String,
        light: &DuffLight<Sig>,
        (p, cosine): (&Sig, &Sig),
    ) -> Sig {
        let (b, f) = (self.forward.b, &self.duff.formats);
        let given = "inputs are those that the highlight asks for";
        let fraction_bits = f.base.fraction_bits;
        let reflected = |c: &Sig, v: Option<&Sig>, product_error| {
            let (v, dot_view) = (v.expect(given), light.dot_view.as_ref().expect(given));
            let to = Base { fraction_bits, product_error };
            b.instance(&called("base"), || {
                units::reflected_base(b, (v, c), dot_view, &self.length.has_direction, to)
            })
        };
        match self.duff.specular {
            Highlight::Blinn => {
                let halfway = light.halfway.as_ref().expect(given);
                let r = self
                    .forward
                    .linear(&called("halfway"), halfway, f.operand.fraction_bits)
                    .named(&called("r"));
                let cosine = || units::cosine(b, &r, self.length, f.cosine.fraction_bits);
                let cosine = b.instance(&called("halfway_cosine"), cosine);
                b.instance(&called("base"), || units::clamp_nonnegative(b, &cosine, fraction_bits))
            }
            Highlight::Quotient => {
                let numerator = light.numerator.as_ref().expect(given);
                let p = self.forward.quadratic(
                    &called("numerator"),
                    numerator,
                    (-1.0, 1.0),
                    f.operand.fraction_bits,
                );
                let divider = || units::divider(b, &p, &self.length.squared, fraction_bits);
                b.instance(&called("divider"), divider)
            }
            Highlight::Eq33 => {
                let to = QuotientFormat {
                    integer_bits: f.root.integer_bits,
                    fraction_bits: f.quotient.fraction_bits,
                };
                let quotient = || units::signed_quotient(b, p, &self.length.squared, to);
                let error = self.length.proven.quotient_error(
                    p.bound(),
                    self.view.expect(given).bound(),
                    f.quotient.ulp(),
                );
                reflected(&b.instance(&called("quotient"), quotient), self.view, error)
            }
            Highlight::Eq34 => reflected(cosine, self.view_cosine, f64::INFINITY),
        }
    }
}
