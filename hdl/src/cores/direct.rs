//! The core that evaluates fast Phong shading anew at every pixel.
use specula_spec::direct::{DirectFormats, DirectInputs, DirectLight, DirectSpec, Root};
use specula_spec::{CoreParameters, Format, InputPort};

use super::common::{Intensities, finish, squared_normal, time_slots};
use crate::error::direct::{Parameter, Product, normal_by_newton, unit_normal};
use crate::units::{self, DirectedBase, QuotientFormat};
use specula_datapath::bound::Angular;
use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::graph::Graph;

/// q from t, one reciprocal root for all lights, then J, K and 2 J K - L·V. [lecture, eq. 4.3 to
/// 4.6]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    direct: &DirectSpec,
    ports: &DirectInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let inputs = ports.map(|port| b.input(port));
    let formats = &direct.formats;
    let t = units::parameter(
        &b,
        &slots.first_pixel,
        &inputs.span.weight_step,
        formats,
        parameters.longest_span - 1,
    );
    let q = squared_normal(units::squared_length(&b, &t, &inputs.span.spread, formats), parameters);
    let view = [&inputs.span.view.start, &inputs.span.view.delta];
    let view = b.instance("view", || units::direct_scalar(&b, &t, view, formats));
    let length = length(
        &b,
        Squared {
            first: &slots.first_pixel,
            t: &t,
            q: &q,
            spread: &inputs.span.spread,
            view: &view,
        },
        direct,
    );
    let pixel =
        Pixel { b: &b, direct, t: &t, q: &q, length: &length, exponent: &inputs.span.exponent };
    finish(&b, &slots, &inputs, |i, light| pixel.shade(i, light))
}

/// What a pixel's length is made of.
#[derive(Clone, Copy)]
struct Squared<'a> {
    first: &'a Sig,
    t: &'a Sig,
    q: &'a Sig,
    spread: &'a Sig,
    /// N·V, not of the unit normal.
    view: &'a Sig,
}

/// What the length of N is divided out by.
struct Length {
    /// 1/√q, or 1/d.
    reciprocal: Sig,
    /// What is known of N times that.
    normal: Angular,
    highlight: Highlight,
}

/// What the base of the highlight is made of.
enum Highlight {
    /// J and this K.
    OfCosines(Sig),
    /// p_L and this p_V/q, whose product is known so well.
    OfQuotient(Sig, Option<Product>),
}

/// What divides by the length of N, and what that makes of N·V.
fn length(b: &Builder, of: Squared, direct: &DirectSpec) -> Length {
    let Squared { first, t, q, spread, view } = of;
    let formats = &direct.formats;
    let parameter = Parameter::new(t.bound(), spread.bound());
    match direct.root {
        Root::Exact => {
            let reciprocal = units::reciprocal_square_root(b, q, formats.reciprocal.into());
            let normal = unit_normal(parameter, q.bound(), formats);
            let k = b.instance("n_dot_v", || {
                units::direct_cosine(b, view, &reciprocal, formats, normal)
            });
            Length { reciprocal, normal, highlight: Highlight::OfCosines(k) }
        }
        Root::Newton => {
            let reciprocal = reciprocal_length(b, first, q, formats, direct.newton_steps);
            let normal = normal_by_newton(parameter, q.bound(), formats, direct.newton_steps);
            let quotient = units::over_square(b, view, q, formats);
            let known = Product::with_quotient(parameter, q.bound(), formats);
            Length { reciprocal, normal, highlight: Highlight::OfQuotient(quotient, known) }
        }
    }
}

/// 1/d, d by Newton's method from the pixel before.
fn reciprocal_length(
    b: &Builder,
    first: &Sig,
    q: &Sig,
    formats: &DirectFormats,
    steps: u32,
) -> Sig {
    let d = units::newton_root(b, first, q, formats, steps);
    let Format { integer_bits, fraction_bits, .. } = formats.reciprocal;
    units::quotient(b, &b.integer(1), &d, QuotientFormat { integer_bits, fraction_bits })
}

/// What the lights have in common.
struct Pixel<'a> {
    b: &'a Builder,
    direct: &'a DirectSpec,
    t: &'a Sig,
    q: &'a Sig,
    length: &'a Length,
    exponent: &'a Sig,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &DirectLight<Sig>) -> Intensities {
        let (b, formats, length) = (self.b, &self.direct.formats, self.length);
        let called = |unit: &str| format!("light{index}_{unit}");
        let ends = [&light.light.start, &light.light.delta];
        let p = b.instance(&called("scalar"), || units::direct_scalar(b, self.t, ends, formats));
        let j = b.instance(&called("n_dot_l"), || {
            units::direct_cosine(b, &p, &length.reciprocal, formats, length.normal)
        });
        let bits = formats.base.fraction_bits;
        let base =
            b.instance(&called("base"), || units::directed_base(b, self.base(&p, &j, light), bits));
        let power = || units::raised(b, &base, self.exponent, self.direct.power_unit());
        Intensities {
            diffuse: b.instance(&called("diffuse"), || {
                units::clamp_unit(b, &j, formats.diffuse.fraction_bits)
            }),
            specular: b.instance(&called("power"), power),
        }
    }

    fn base<'a>(&'a self, p: &'a Sig, j: &'a Sig, light: &'a DirectLight<Sig>) -> DirectedBase<'a> {
        let (factors, known) = match &self.length.highlight {
            Highlight::OfCosines(k) => ([j, k], Product::of_bounds([j.bound(), k.bound()])),
            Highlight::OfQuotient(k, known) => ([p, k], *known),
        };
        DirectedBase { factors, known, light_dot_view: &light.light_dot_view, q: self.q }
    }
}
