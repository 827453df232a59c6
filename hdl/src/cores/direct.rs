//! The core that evaluates fast Phong shading anew at every pixel.
use specula_spec::direct::{DirectFormats, DirectInputs, DirectLight, DirectSpec, Root};
use specula_spec::{CoreParameters, Format, InputPort};

use super::{Intensities, finish, time_slots};
use crate::error::direct::{Product, normal_by_newton, unit_normal};
use crate::units::{self, DirectedBase, NewtonRoot, QuotientFormat};
use specula_datapath::bound::Angular;
use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::design::Design;

/// q from t, one reciprocal root for all lights, then J, K and 2 J K - L·V. [lecture, eq. 4.3 to
/// 4.6]
pub(super) fn core(
    b: Builder,
    spec: &CoreParameters,
    direct: &DirectSpec,
    ports: &DirectInputs<InputPort>,
) -> Result<Design, BuildError> {
    let slots = time_slots(&b, spec);
    let inputs = ports.map(|port| b.input(port));
    let formats = &direct.formats;
    let t = units::parameter(
        &b,
        &slots.first_pixel,
        &inputs.span.weight_step,
        formats,
        spec.longest_span - 1,
    );
    let q = units::squared_length(&b, &t, &inputs.span.spread, formats);
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
        spec,
        direct,
    );
    let smallest_q = spec.shortest_normal * spec.shortest_normal;
    let pixel = Pixel {
        b: &b,
        direct,
        t: &t,
        q: &q,
        length: &length,
        smallest_q,
        exponent: &inputs.span.exponent,
    };
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
    Angulars(Sig),
    /// p_L and this p_V/q, whose product is known so well.
    OfQuotient(Sig, Option<Product>),
}

/// Unit ends are no closer to each other's middle than those of which the longer alone is a unit
/// vector.
fn length(b: &Builder, of: Squared, spec: &CoreParameters, direct: &DirectSpec) -> Length {
    let Squared { first, t, q, spread, view } = of;
    let (formats, shortest) = (&direct.formats, spec.shortest_normal);
    let smallest_q = shortest * shortest;
    let parameter = units::known_parameter(t, spread);
    match direct.root {
        Root::Exact => {
            let reciprocal =
                units::reciprocal_square_root(b, q, formats.reciprocal.into(), smallest_q);
            let normal = unit_normal(parameter, formats, shortest);
            let k = b.instance("n_dot_v", || {
                units::direct_cosine(b, view, &reciprocal, formats, normal)
            });
            Length { reciprocal, normal, highlight: Highlight::Angulars(k) }
        }
        Root::Newton => {
            let newton = NewtonRoot { steps: direct.newton_steps, shortest };
            let reciprocal = reciprocal_length(b, first, q, formats, newton);
            let of_root = newton.bound(q, formats);
            let normal = normal_by_newton(parameter, formats, shortest, of_root);
            let quotient = units::over_square(b, view, q, smallest_q, formats);
            let known = Product::with_quotient(parameter, formats, shortest);
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
    newton: NewtonRoot,
) -> Sig {
    let d = units::newton_root(b, first, q, formats, newton);
    let Format { integer_bits, fraction_bits, .. } = formats.reciprocal;
    units::quotient(
        b,
        &b.integer(1),
        &d,
        QuotientFormat { integer_bits, fraction_bits },
        newton.shortest,
    )
}

/// What the lights have in common.
struct Pixel<'a> {
    b: &'a Builder,
    direct: &'a DirectSpec,
    t: &'a Sig,
    q: &'a Sig,
    length: &'a Length,
    smallest_q: f64,
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
            Highlight::Angulars(k) => ([j, k], units::product_of_cosines([j, k])),
            Highlight::OfQuotient(k, known) => ([p, k], *known),
        };
        DirectedBase {
            factors,
            known,
            light_dot_view: &light.light_dot_view,
            q: self.q,
            smallest_q: self.smallest_q,
        }
    }
}
