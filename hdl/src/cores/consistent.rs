//! The core for consistent normal interpolation.
use specula_spec::consistent::{
    ConsistentInputs, ConsistentLight, ConsistentSpec, Curve, Diffuse, Directions, Highlight,
};
use specula_spec::ways::{VectorLight, VectorWay};
use specula_spec::{CoreParameters, DirectionOutput, Format, InputPort};

use super::common::{Intensities, SHORTEST_NORMAL, codes, eye, time_slots, unit_vector};
use super::forward::Forward;
use super::vector_ways::{VectorWays, alike};
use crate::error;
use crate::error::consistent_reflection::highlight;
use crate::units::{
    self, ConsistentCosine, ExactNormalisation, Interpolation, SpanAngles, SpanNormals,
};
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
    let mut inputs = ports.map(|port| b.input(port));
    alike(&b, &slots, &mut inputs.lights, |light| light.way.as_mut());
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
    let forward = Forward { b: &b, first: &slots.first_pixel, steps };
    let ways = VectorWays::new(forward, parameters, [f.vector, f.base, f.shape], &slots);
    let view = match &inputs.span.eye {
        Some(eye) => direction(&ways, "eye", eye, to),
        None => (eye(&b), b.integer(1)),
    };
    let least_divisor = (1.0 + parameters.least_view_cosine).max(0.0);
    let of_eye = || units::consistent_reflection(&b, &n, &view.0, &q, f, least_divisor).0;
    let has_r = consistent.highlight == Highlight::Reflection || !consistent.directions.is_none();
    let r = has_r.then(of_eye);
    let pixel = Pixel {
        ways: &ways,
        to,
        view: &view,
        consistent,
        n: &n,
        has_direction: &has_direction,
        q: &q,
        r: r.as_ref().filter(|_| consistent.highlight == Highlight::Reflection),
    };
    let exponent = &inputs.span.exponent;
    let codes = codes(&b, parameters, &slots, &inputs, |i, light| pixel.shade(i, light, exponent));
    let directions = r.iter().flat_map(|r| directions(&b, consistent.directions, (r, &view.0), to));
    let directions: Vec<(String, Sig)> = directions.collect();
    let named = directions.iter().map(|(name, component)| (name.as_str(), component.clone()));
    let named: Vec<(&str, Sig)> = named.collect();
    b.clone().graph_beside(&slots.valid_in_last_slot, &codes, &named)
}

/// The components of the directions that leave beside the colour: of r, and of N_c half-way between
/// r and V.
fn directions(
    b: &Builder,
    asked: Directions,
    (r, view): (&Vector, &Vector),
    to: ExactNormalisation,
) -> Vec<(String, Sig)> {
    let normal = || {
        b.instance("consistent_normal", || {
            units::normalise_exactly(b, &units::half_sum(r, view), to).0
        })
    };
    let vectors = [asked.has_reflection().then(|| r.clone()), asked.has_normal().then(normal)];
    let components = |(vector, output): (Vector, &DirectionOutput)| {
        [("x", vector.x), ("y", vector.y), ("z", vector.z)]
            .map(|(axis, component)| (format!("{}_{axis}", output.name), component))
    };
    vectors.into_iter().flatten().zip(asked.outputs()).flat_map(components).collect()
}

/// q at the largest angle that a vertex has.
fn least_contraction(parameters: &CoreParameters, curve: Curve) -> f64 {
    let t = curve.quarter_turns(parameters.least_cone_cosine).min(1.0);
    match curve {
        Curve::Rational => (1.0 - t).powi(2) / (1.0 + (std::f64::consts::PI - 2.0) * t),
        Curve::Trigonometric => (std::f64::consts::FRAC_PI_4 * (1.0 - t)).tan().powi(2),
    }
}

/// The direction of a way, and whether there is one.
fn direction(
    ways: &VectorWays,
    name: &str,
    way: &VectorWay<Sig>,
    to: ExactNormalisation,
) -> (Vector, Sig) {
    let (b, vector) = (ways.forward.b, ways.way(name, way));
    b.instance(&format!("{name}_normalise"), || units::normalise_exactly(b, &vector, to))
}

/// What the lights have in common.
struct Pixel<'a> {
    ways: &'a VectorWays<'a>,
    /// Where directions are rounded.
    to: ExactNormalisation,
    /// V, and whether there is one.
    view: &'a (Vector, Sig),
    consistent: &'a ConsistentSpec,
    n: &'a Vector,
    has_direction: &'a Sig,
    q: &'a Sig,
    /// The eye's reflection, where the highlight asks for it.
    r: Option<&'a Vector>,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &ConsistentLight<Sig>, exponent: &Sig) -> Intensities {
        match (&light.way, &light.direction) {
            (Some(way), _) => self.arriving(index, way, exponent),
            (None, Some(direction)) => {
                let sent = |vector: &[Sig; 3]| unit_vector(vector, self.consistent.formats.vector);
                let halfway = light.halfway.as_ref().map(sent);
                self.intensities(index, &sent(direction), halfway.as_ref(), exponent)
            }
            (None, None) => unreachable!("`ConsistentSpec` gives each light one of both"),
        }
    }

    /// The intensities of a light whose way is followed.
    fn arriving(&self, index: usize, light: &VectorLight<Sig>, exponent: &Sig) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        let (b, zero) = (self.ways.forward.b, self.ways.forward.b.integer(0));
        let (view, is_seen) = self.view;
        let (l, exists) = direction(self.ways, &called("way"), &light.way, self.to);
        let halfway = (self.consistent.highlight == Highlight::Blinn).then(|| {
            b.instance(&called("halfway_normalise"), || {
                let half = self.ways.half_sum(&l, view);
                units::normalise_exactly(b, &half, self.to).0
            })
        });
        let Intensities { diffuse, specular } =
            self.intensities(index, &l, halfway.as_ref(), exponent);
        let intensities = Intensities {
            diffuse: exists.choose(&diffuse, &zero),
            specular: exists.and(is_seen).choose(&specular, &zero),
        };
        let formats = [self.consistent.formats.diffuse, self.consistent.power_unit().format()];
        let bits = formats.map(|format| format.fraction_bits);
        self.ways.spotted(index, light, &l, (intensities, bits))
    }

    fn intensities(
        &self,
        index: usize,
        direction: &Vector,
        halfway: Option<&Vector>,
        exponent: &Sig,
    ) -> Intensities {
        let (b, f) = (self.ways.forward.b, &self.consistent.formats);
        let called = |unit: &str| format!("light{index}_{unit}");
        let diffuse = || match self.consistent.diffuse {
            Diffuse::Lambert => units::clamped_cosine(b, self.n, direction, f.diffuse),
            Diffuse::Consistent => self.consistent_cosine(direction, f.diffuse).gated(b),
        };
        let diffuse = b.instance(&called("diffuse"), diffuse);
        let raised = |base: &Sig| {
            b.instance(&called("power"), || {
                units::raised(b, base, exponent, self.consistent.power_unit())
            })
        };
        let specular = match (self.r, halfway) {
            (_, Some(halfway)) => {
                let cosine =
                    b.instance(&called("base"), || self.consistent_cosine(halfway, f.base));
                let least = 1 << Highlight::Blinn.log2_exponent_factor();
                cosine.gated_power(b, &raised(&cosine.cosine), least)
            }
            (Some(r), None) => {
                raised(&b.instance(&called("base"), || self.reflected_cosine(r, direction)))
            }
            (None, None) => unreachable!("there is H where there is no r"),
        };
        Intensities { diffuse, specular }
    }

    /// N_c·I of any I.
    fn consistent_cosine(&self, incoming: &Vector, to: Format) -> ConsistentCosine {
        let mirror = (self.n, self.q, self.has_direction);
        units::consistent_cosine(
            self.ways.forward.b,
            mirror,
            incoming,
            (&self.consistent.formats, to),
        )
    }

    /// r·L, kept within 0 to 1, and 0 where the normal has no direction.
    fn reflected_cosine(&self, r: &Vector, light: &Vector) -> Sig {
        let (b, format) = (self.ways.forward.b, self.consistent.formats.base);
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
