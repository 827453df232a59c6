//! Duff's core, with Hast's highlights.
use specula_spec::duff::{DuffInputs, DuffLight, DuffSpec, Highlight};
use specula_spec::{CoreParameters, InputPort};

use super::common::{Intensities, finish, squared_normal, time_slots};
use super::forward::Forward;
use super::ways::{Arrival, Ways, alike};
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
    let mut inputs = ports.map(|port| b.input(port));
    alike(&b, &slots, &mut inputs.lights, |light| light.way.as_mut().map(|to| &mut to.way));
    let f = &duff.formats;
    let forward = Forward { b: &b, first: &slots.first_pixel, steps: parameters.longest_span - 1 };
    let q = forward
        .quadratic("denominator", &inputs.span.denominator, (0.0, 1.0), f.operand.fraction_bits)
        .named("q");
    let q = squared_normal(q, parameters);
    let length = b.instance("root", || units::root(&b, &q, f.root));
    let ways = Ways::new(forward, parameters, duff.ways(), &slots);
    let (view, eye) = ways.view(inputs.span.view.as_ref(), inputs.span.eye.as_ref());
    let view = view.map(|view| view.named("n_dot_v"));
    let of_unit = matches!(duff.specular, Highlight::Eq34 | Highlight::Blinn);
    let view_cosine = view.as_ref().filter(|_| of_unit).map(|view| {
        b.instance("view_cosine", || units::cosine(&b, view, &length, f.cosine.fraction_bits))
    });
    let exponent = &inputs.span.exponent;
    let pixel = Pixel {
        ways: &ways,
        eye: eye.as_ref(),
        duff,
        length: &length,
        view: view.as_ref(),
        view_cosine: view_cosine.as_ref(),
        exponent,
    };
    finish(&b, parameters, &slots, &inputs, |i, light| pixel.shade(i, light))
}

/// What the lights have in common.
struct Pixel<'a> {
    ways: &'a Ways<'a>,
    /// What divides by the way to an eye at a place.
    eye: Option<&'a Length>,
    duff: &'a DuffSpec,
    length: &'a Length,
    /// N·V, where the highlight asks for it.
    view: Option<&'a Sig>,
    /// That of the unit normal, where the highlight asks for it.
    view_cosine: Option<&'a Sig>,
    exponent: &'a Sig,
}

/// N·L of a light, that of the unit normal, and the way to the light if that is followed.
struct Lit {
    p: Sig,
    cosine: Sig,
    arrival: Option<Arrival>,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &DuffLight<Sig>) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        let (b, f) = (self.ways.forward.b, &self.duff.formats);
        let lit = self.lit(index, light);
        let base = match &lit.arrival {
            Some(arrival) => self.base_to_place(index, arrival, &lit),
            None => self.base(&called, light, &lit),
        };
        let power = || units::raised(b, &base, self.exponent, self.duff.power_unit());
        let intensities = Intensities {
            diffuse: b.instance(&called("diffuse"), || {
                units::clamp_nonnegative(b, &lit.cosine, f.diffuse.fraction_bits)
            }),
            specular: b.instance(&called("power"), power),
        };
        match &lit.arrival {
            Some(arrival) => {
                let formats = [self.duff.formats.diffuse, self.duff.power_unit().format()];
                arrival.spotted(intensities, formats.map(|format| format.fraction_bits))
            }
            None => intensities,
        }
    }

    fn lit(&self, index: usize, light: &DuffLight<Sig>) -> Lit {
        let called = |unit: &str| format!("light{index}_{unit}");
        let (b, f, forward) = (self.ways.forward.b, &self.duff.formats, self.ways.forward);
        let (p, arrival) = match (&light.cosine, &light.way) {
            (_, Some(way)) => {
                let (p, arrival) = self.ways.light(index, way, self.eye);
                (p, Some(arrival))
            }
            (Some(cosine), None) => {
                (forward.linear(&called("p"), cosine, f.operand.fraction_bits), None)
            }
            (None, None) => unreachable!("`DuffSpec::light_inputs` gives each light one of both"),
        };
        let p = p.named(&called("p"));
        let cosine = b.instance(&called("cosine"), || {
            units::cosine(b, &p, self.length, f.cosine.fraction_bits)
        });
        Lit { p, cosine, arrival }
    }

    fn base(&self, called: &impl Fn(&str) -> String, light: &DuffLight<Sig>, lit: &Lit) -> Sig {
        let (b, f, forward) = (self.ways.forward.b, &self.duff.formats, self.ways.forward);
        let fraction_bits = f.base.fraction_bits;
        match self.duff.specular {
            Highlight::Blinn => {
                let r = forward
                    .linear(
                        &called("halfway"),
                        light.halfway.as_ref().expect(GIVEN),
                        f.operand.fraction_bits,
                    )
                    .named(&called("r"));
                let cosine = || units::cosine(b, &r, self.length, f.cosine.fraction_bits);
                let cosine = b.instance(&called("halfway_cosine"), cosine);
                b.instance(&called("base"), || units::clamp_nonnegative(b, &cosine, fraction_bits))
            }
            Highlight::Quotient => {
                let p = forward.quadratic(
                    &called("numerator"),
                    light.numerator.as_ref().expect(GIVEN),
                    (-1.0, 1.0),
                    f.operand.fraction_bits,
                );
                let divider = || units::divider(b, &p, &self.length.squared, fraction_bits);
                b.instance(&called("divider"), divider)
            }
            Highlight::Eq33 => self.eq33(called, lit, light.dot_view.as_ref().expect(GIVEN)),
            Highlight::Eq34 => self.eq34(called, lit, light.dot_view.as_ref().expect(GIVEN)),
        }
    }

    /// The same of a light or for an eye at a place.
    fn base_to_place(&self, index: usize, arrival: &Arrival, lit: &Lit) -> Sig {
        let called = |unit: &str| format!("light{index}_{unit}");
        let (b, fraction_bits) = (self.ways.forward.b, self.duff.formats.base.fraction_bits);
        match self.duff.specular {
            Highlight::Blinn => {
                let cosines = [self.view_cosine.expect(GIVEN), &lit.cosine];
                self.ways.halfway(index, cosines, arrival, self.eye)
            }
            Highlight::Quotient => {
                let (q, view) = (&self.length.squared, self.view.expect(GIVEN));
                let p =
                    self.ways.reflected(&called("numerator"), [view, &lit.p], &arrival.dot_view, q);
                b.instance(&called("divider"), || units::divider(b, &p, q, fraction_bits))
            }
            Highlight::Eq33 => self.eq33(&called, lit, &arrival.dot_view),
            Highlight::Eq34 => self.eq34(&called, lit, &arrival.dot_view),
        }
    }

    fn eq33(&self, called: &impl Fn(&str) -> String, lit: &Lit, dot_view: &Sig) -> Sig {
        let (b, f) = (self.ways.forward.b, &self.duff.formats);
        let view = self.view.expect(GIVEN);
        let to = QuotientFormat {
            integer_bits: f.root.integer_bits,
            fraction_bits: f.quotient.fraction_bits,
        };
        let quotient = b.instance(&called("quotient"), || {
            units::signed_quotient(b, &lit.p, &self.length.squared, to)
        });
        let error =
            self.length.proven.quotient_error(lit.p.bound(), view.bound(), f.quotient.ulp());
        self.reflected(called, [view, &quotient], dot_view, error)
    }

    fn eq34(&self, called: &impl Fn(&str) -> String, lit: &Lit, dot_view: &Sig) -> Sig {
        let view = self.view_cosine.expect(GIVEN);
        self.reflected(called, [view, &lit.cosine], dot_view, f64::INFINITY)
    }

    fn reflected(
        &self,
        called: &impl Fn(&str) -> String,
        [view, cosine]: [&Sig; 2],
        dot_view: &Sig,
        product_error: f64,
    ) -> Sig {
        let b = self.ways.forward.b;
        let to = Base { fraction_bits: self.duff.formats.base.fraction_bits, product_error };
        b.instance(&called("base"), || {
            units::reflected_base(b, (view, cosine), dot_view, &self.length.has_direction, to)
        })
    }
}

const GIVEN: &str = "inputs are those that the highlight asks for";
