//! The core for consistent normal interpolation.
use specula_spec::consistent::{
    ConsistentInputs, ConsistentLight, ConsistentSpec, Curve, Diffuse, Highlight,
};
use specula_spec::{CoreParameters, Format, InputPort};

use super::common::{Intensities, SHORTEST_NORMAL, eye, finish, time_slots};
use crate::error;
use crate::error::consistent_reflection::highlight;
use crate::units::{self, ExactNormalisation, Interpolation, SpanAngles, SpanNormals};
use specula_datapath::bound::Interval;
use specula_datapath::builder::{BuildError, Builder, Sig, Vector};
use specula_datapath::graph::Graph;

/// Exactly normalised normal, N·L or N_c·L, and the power of the eye's consistent reflection.
/// [Reshetov, Soupikov and Mark]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    consistent: &ConsistentSpec,
    ports: &ConsistentInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let inputs = ports.map(|port| b.input(port));
    let (f, steps) = (&consistent.formats, parameters.longest_span - 1);
    let span = SpanNormals {
        first: &slots.first_pixel,
        start: &Vector::new(inputs.span.normal_start.clone()),
        delta: &Vector::new(inputs.span.normal_delta.clone()),
        weight_step: &inputs.span.weight_step,
    };
    let normal = units::interpolate(
        &b,
        span,
        Interpolation {
            accumulator: f.weight_accumulator,
            weight: f.weight,
            vector: f.vector,
            longest: 1.0,
            apart: error::interpolate::chord(parameters.shortest_normal),
            steps,
        },
    );
    let to = ExactNormalisation {
        length_squared_fraction_bits: f.length_squared.fraction_bits,
        reciprocal: f.gain.into(),
        vector_fraction_bits: f.vector.fraction_bits,
    };
    let normal = normal.no_shorter_than(parameters.shortest_normal, SHORTEST_NORMAL);
    let (n, has_direction) = units::normalise_exactly(&b, &normal, to);
    let angles = SpanAngles {
        first: &slots.first_pixel,
        start: &inputs.span.angle_start,
        step: &inputs.span.angle_step,
    };
    let q = units::contraction(&b, angles, consistent.curve, f, steps);
    let least_q = Interval::at_least(least_contraction(parameters, consistent.curve));
    let q = q.real_within(least_q, "no angle is larger than that of a vertex");
    let least_divisor = (1.0 + parameters.least_view_cosine).max(0.0);
    let of_eye = || units::consistent_reflection(&b, &n, &eye(&b), &q, f, least_divisor).0;
    let r = (consistent.highlight == Highlight::Reflection).then(of_eye);
    let pixel =
        Pixel { b: &b, consistent, n: &n, has_direction: &has_direction, q: &q, r: r.as_ref() };
    let exponent = &inputs.span.exponent;
    finish(&b, &slots, &inputs, |i, light| pixel.shade(i, light, exponent))
}

/// q at the largest angle that a vertex has.
fn least_contraction(parameters: &CoreParameters, curve: Curve) -> f64 {
    let t = curve.quarter_turns(parameters.least_cone_cosine).min(1.0);
    match curve {
        Curve::Rational => (1.0 - t).powi(2) / (1.0 + (std::f64::consts::PI - 2.0) * t),
        Curve::Trigonometric => (std::f64::consts::FRAC_PI_4 * (1.0 - t)).tan().powi(2),
    }
}

/// What the lights have in common.
struct Pixel<'a> {
    b: &'a Builder,
    consistent: &'a ConsistentSpec,
    n: &'a Vector,
    has_direction: &'a Sig,
    q: &'a Sig,
    /// The eye's reflection, where the highlight asks for it.
    r: Option<&'a Vector>,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &ConsistentLight<Sig>, exponent: &Sig) -> Intensities {
        let (b, f) = (self.b, &self.consistent.formats);
        let called = |unit: &str| format!("light{index}_{unit}");
        let direction = Vector::new(light.direction.clone());
        let diffuse = || match self.consistent.diffuse {
            Diffuse::Lambert => units::clamped_cosine(b, self.n, &direction, f.diffuse),
            Diffuse::Consistent => self.consistent_cosine(&direction, f.diffuse),
        };
        let base = b.instance(&called("base"), || match (self.r, &light.halfway) {
            (_, Some(halfway)) => self.consistent_cosine(&Vector::new(halfway.clone()), f.base),
            (Some(r), None) => self.reflected_cosine(r, &direction),
            (None, None) => {
                unreachable!("`ConsistentSpec::light_inputs` has H where there is no r")
            }
        });
        let power = || units::raised(b, &base, exponent, self.consistent.power_unit());
        Intensities {
            diffuse: b.instance(&called("diffuse"), diffuse),
            specular: b.instance(&called("power"), power),
        }
    }

    /// N_c·I of any I.
    fn consistent_cosine(&self, incoming: &Vector, to: Format) -> Sig {
        let mirror = (self.n, self.q, self.has_direction);
        units::consistent_cosine(self.b, mirror, incoming, (&self.consistent.formats, to))
    }

    /// r·L, kept within 0 to 1, and 0 where the normal has no direction.
    fn reflected_cosine(&self, r: &Vector, light: &Vector) -> Sig {
        let (b, format) = (self.b, self.consistent.formats.base);
        let inputs = (("r", r), ("l", light), ("has_direction", self.has_direction));
        b.unit(
            "reflected_cosine",
            "b = r.L, clamped to [0, 1]",
            inputs,
            |b, (r, l, has_direction)| {
                let cosine = units::clamped_cosine(b, &r, &l, format).tighten_error(
                    "error::consistent_reflection::highlight",
                    highlight(r.bound(), l.bound(), format),
                );
                let base = has_direction.choose(&cosine, &b.integer(0)).clamped_above(1);
                units::gated(base, &has_direction).named("base")
            },
        )
    }
}
