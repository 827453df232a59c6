//! The core that evaluates fast Phong shading anew at every pixel.
use specula_spec::direct::{DirectFormats, DirectInputs, DirectLight, DirectSpec, Ends, Root};
use specula_spec::{CoreParameters, Format, Increments, InputPort, Linear};

use super::common::{Intensities, finish, squared_normal, time_slots};
use super::forward::Forward;
use super::ways::{Arrival, Ways, alike};
use crate::error::cosine::InverseLength;
use crate::error::direct::{Parameter, Product, normal_by_newton, unit_normal};
use crate::units::{self, DirectedBase, KnownProduct, QuotientFormat, ReciprocalRoot};
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
    let mut inputs = ports.map(|port| b.input(port));
    alike(&b, &slots, &mut inputs.lights, |light| light.way.as_mut().map(|to| &mut to.way));
    let formats = &direct.formats;
    let t = units::parameter(
        &b,
        &slots.first_pixel,
        &inputs.span.weight_step,
        formats,
        parameters.longest_span - 1,
    );
    let q = squared_normal(units::squared_length(&b, &t, &inputs.span.spread, formats), parameters);
    let forward = Forward { b: &b, first: &slots.first_pixel, steps: parameters.longest_span - 1 };
    let ways = Ways::new(forward, parameters, direct.ways(), &slots);
    let ((view, scalar), eye) = match (&inputs.span.view, &inputs.span.eye) {
        (_, Some(eye)) => {
            let (view, length) = ways.eye(eye);
            ((view, Scalar::Independent), Some(length))
        }
        (Some(view), None) => (along(forward, &t, direct, "view", view), None),
        (None, None) => unreachable!("`DirectSpec::span_inputs` gives one of both"),
    };
    let length = length(
        &b,
        Squared {
            first: &slots.first_pixel,
            t: &t,
            q: &q,
            spread: &inputs.span.spread,
            view: &view,
            scalar,
        },
        direct,
    );
    let pixel = Pixel {
        ways: &ways,
        eye: eye.as_ref(),
        direct,
        t: &t,
        q: &q,
        length: &length,
        exponent: &inputs.span.exponent,
    };
    finish(&b, parameters, &slots, &inputs, |i, light| pixel.shade(i, light))
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
    scalar: Scalar,
}

/// What a scalar N·X is.
#[derive(Clone, Copy)]
enum Scalar {
    /// Between those of the ends, for which much is proven.
    BetweenEnds,
    /// Made without t, as those that are added up or are over the length of a way: off by what it
    /// is off by itself.
    Independent,
}

/// N·X of a light or an eye at infinity. [lecture, eq. 4.3]
fn along(
    forward: Forward,
    t: &Sig,
    direct: &DirectSpec,
    instance: &str,
    Ends { start, change }: &Ends<Sig>,
) -> (Sig, Scalar) {
    let (b, formats) = (forward.b, &direct.formats);
    match direct.increments {
        Increments::Multiplied => {
            let p = b.instance(instance, || units::direct_scalar(b, t, [start, change], formats));
            (p, Scalar::BetweenEnds)
        }
        Increments::Added => {
            let linear = Linear { start: start.clone(), step: change.clone() };
            let p = forward.linear(instance, &linear, formats.cosine.fraction_bits);
            (p.named("linear"), Scalar::Independent)
        }
    }
}

/// What the length of N is divided out by.
struct Length {
    /// 1/√q, or 1/d.
    reciprocal: Sig,
    /// What is known of N times that.
    normal: Angular,
    /// What is known of 1/√q.
    proven: Option<InverseLength>,
    highlight: Highlight,
}

/// What the base of the highlight is made of.
enum Highlight {
    /// J and this K.
    OfCosines(Sig),
    /// p_L and this p_V/q, whose product is known so well.
    OfQuotient(Sig, KnownProduct),
}

/// What divides by the length of N, and what that makes of N·V.
fn length(b: &Builder, of: Squared, direct: &DirectSpec) -> Length {
    let Squared { first, t, q, spread, view, scalar } = of;
    let formats = &direct.formats;
    let parameter = Parameter::new(t.bound(), spread.bound());
    match direct.root {
        Root::Exact => {
            let reciprocal = units::reciprocal_square_root(b, q, formats.reciprocal.into());
            let normal = unit_normal(parameter, q.bound(), formats);
            let least = ReciprocalRoot::from(formats.reciprocal).least_operand();
            let proven = Some(InverseLength::new(q.bound(), least));
            let mut length = Length {
                reciprocal,
                normal,
                proven,
                highlight: Highlight::OfCosines(view.clone()),
            };
            let k = b.instance("n_dot_v", || length.cosine(b, view, scalar, formats));
            length.highlight = Highlight::OfCosines(k);
            length
        }
        Root::Newton => {
            let reciprocal = reciprocal_length(b, first, q, formats, direct.newton_steps);
            let normal = normal_by_newton(parameter, q.bound(), formats, direct.newton_steps);
            let quotient = units::over_square(b, view, q, formats);
            let known = match scalar {
                Scalar::BetweenEnds => Product::with_quotient(parameter, q.bound(), formats).into(),
                Scalar::Independent => KnownProduct::Propagated,
            };
            let highlight = Highlight::OfQuotient(quotient, known);
            Length { reciprocal, normal, proven: None, highlight }
        }
    }
}

impl Length {
    /// A scalar over the length of N.
    fn cosine(&self, b: &Builder, p: &Sig, scalar: Scalar, formats: &DirectFormats) -> Sig {
        let s = &self.reciprocal;
        match scalar {
            Scalar::BetweenEnds => units::direct_cosine(b, p, s, formats, self.normal),
            Scalar::Independent => {
                units::cosine_of_scalar(b, p, s, formats.cosine.fraction_bits, self.proven)
            }
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
    ways: &'a Ways<'a>,
    /// What divides by the way to an eye at a place.
    eye: Option<&'a units::Length>,
    direct: &'a DirectSpec,
    t: &'a Sig,
    q: &'a Sig,
    length: &'a Length,
    exponent: &'a Sig,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &DirectLight<Sig>) -> Intensities {
        let (b, formats, length) = (self.ways.forward.b, &self.direct.formats, self.length);
        let called = |unit: &str| format!("light{index}_{unit}");
        let (p, scalar, arrival) = self.scalar(index, light);
        let j = b.instance(&called("n_dot_l"), || length.cosine(b, &p, scalar, formats));
        let dot_view = match (&arrival, &light.light_dot_view) {
            (Some(arrival), _) => &arrival.dot_view,
            (None, Some(dot_view)) => dot_view,
            (None, None) => unreachable!("lights without ways have L.V"),
        };
        let bits = formats.base.fraction_bits;
        let base = b.instance(&called("base"), || {
            units::directed_base(b, self.base((&p, &j), scalar, dot_view), bits)
        });
        let power = || units::raised(b, &base, self.exponent, self.direct.power_unit());
        let intensities = Intensities {
            diffuse: b.instance(&called("diffuse"), || {
                units::clamp_unit(b, &j, formats.diffuse.fraction_bits)
            }),
            specular: b.instance(&called("power"), power),
        };
        match arrival {
            Some(arrival) => {
                let formats = [self.direct.formats.diffuse, self.direct.power_unit().format()];
                arrival.spotted(intensities, formats.map(|format| format.fraction_bits))
            }
            None => intensities,
        }
    }

    /// N·L, not of the unit normal, and the way to the light if that is followed.
    fn scalar(&self, index: usize, light: &DirectLight<Sig>) -> (Sig, Scalar, Option<Arrival>) {
        match (&light.light, &light.way) {
            (_, Some(way)) => {
                let (p, arrival) = self.ways.light(index, way, self.eye);
                (p, Scalar::Independent, Some(arrival))
            }
            (Some(light), None) => {
                let instance = format!("light{index}_scalar");
                let (p, scalar) = along(self.ways.forward, self.t, self.direct, &instance, light);
                (p, scalar, None)
            }
            (None, None) => unreachable!("`DirectSpec::light_inputs` gives each light one of both"),
        }
    }

    fn base<'a>(
        &'a self,
        (p, j): (&'a Sig, &'a Sig),
        scalar: Scalar,
        light_dot_view: &'a Sig,
    ) -> DirectedBase<'a> {
        let (factors, known) = match (&self.length.highlight, scalar) {
            (Highlight::OfCosines(k), Scalar::BetweenEnds) => {
                ([j, k], Product::of_bounds([j.bound(), k.bound()]).into())
            }
            (Highlight::OfCosines(k), Scalar::Independent) => ([j, k], KnownProduct::Propagated),
            (Highlight::OfQuotient(k, known), Scalar::BetweenEnds) => ([p, k], *known),
            (Highlight::OfQuotient(k, _), Scalar::Independent) => {
                ([p, k], KnownProduct::Propagated)
            }
        };
        DirectedBase { factors, known, light_dot_view, q: self.q }
    }
}
