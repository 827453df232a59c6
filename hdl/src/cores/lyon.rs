//! Lyon's core.
use specula_spec::lyon::{
    Difference, Halfway, LyonFormats, LyonInputs, LyonLight, LyonSpan, LyonSpec, ShapeDatapath,
};
use specula_spec::ways::{VectorLight, VectorWay};
use specula_spec::{CoreParameters, InputPort, LightInputs};

use super::common::{Intensities, SHORTEST_NORMAL, eye, finish, time_slots, unit_vector};
use super::forward::Forward;
use super::vector_ways::{VectorWays, alike};
use crate::error;
use crate::units::{self, Follow, Interpolation, LengthError, SpanNormals, WrapFormats};
use specula_datapath::builder::{BuildError, Builder, Sig, Vector};
use specula_datapath::graph::Graph;

/// Interpolated normal, approximate normalisation, and for each light N·L and f_k of D. [Lyon, TR
/// 43, fig. 6 to 8]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    lyon: &LyonSpec,
    ports: &LyonInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let mut inputs = ports.map(|port| b.input(port));
    alike(&b, &slots, &mut inputs.lights, |light| light.way.as_mut());
    let forward = Forward { b: &b, first: &slots.first_pixel, steps: parameters.longest_span - 1 };
    let (n, has_direction) = normal(forward, &inputs.span, parameters, lyon);
    let apart = if slots.count() == 1 { least_distance(&inputs.lights) } else { 0.0 };
    let formats = &lyon.formats;
    let ways = VectorWays::new(
        forward,
        parameters,
        [formats.vector, formats.shape, formats.shape],
        &slots,
    );
    let view = match &inputs.span.eye {
        Some(eye) => direction(&ways, lyon, "eye", eye),
        None => (eye(&b), b.integer(1)),
    };
    let pixel = Pixel {
        ways: &ways,
        view: &view,
        lyon,
        n: &n,
        has_direction: &has_direction,
        shininess: &inputs.span.shininess,
        apart,
    };
    finish(&b, parameters, &slots, &inputs, |i, light| pixel.shade(i, light))
}

/// n at each pixel, and whether it has a direction.
fn normal(
    forward: Forward,
    inputs: &LyonSpan<Sig>,
    parameters: &CoreParameters,
    lyon: &LyonSpec,
) -> (Vector, Sig) {
    let (Forward { b, first, steps }, formats) = (forward, &lyon.formats);
    let unit = |components| unit_vector(components, formats.vector);
    let Some(delta) = &inputs.normal_delta else {
        let n = unit(&inputs.normal_start);
        let has_direction = units::has_direction(b, &n);
        return (n, has_direction);
    };
    let along = |longest| {
        let Some(weight_step) = &inputs.weight_step else {
            let sent = [&inputs.normal_start, delta];
            return forward.vector("interpolated", sent, longest, formats.vector);
        };
        let (start, delta) = (Vector::new(inputs.normal_start.clone()), Vector::new(delta.clone()));
        let span = SpanNormals { first, start: &start, delta: &delta, weight_step };
        let &LyonFormats { weight_accumulator: accumulator, weight, vector, .. } = formats;
        units::interpolate(
            b,
            span,
            Interpolation {
                accumulator,
                weight,
                vector,
                longest,
                apart: error::interpolate::chord(parameters.shortest_normal),
                steps,
            },
        )
    };
    let between_unit_ends =
        || along(1.0).no_shorter_than(parameters.shortest_normal, SHORTEST_NORMAL);
    let Some(axis) = inputs.wrap_axis.as_ref().map(unit) else {
        return units::normalise(b, &between_unit_ends(), lyon);
    };
    let n = match &inputs.wrap_follows {
        None => {
            let to = WrapFormats {
                operand: formats.wrap_operand,
                ratio: formats.wrap_ratio,
                vector: formats.vector,
            };
            units::wrapped(b, &along(2.0), &axis, to)
        }
        Some(follows) => {
            let of = Follow { first, follows, axis: &axis, normal: &between_unit_ends() };
            units::followed(b, of, formats)
        }
    };
    let has_direction = units::has_direction(b, &n);
    (n, has_direction)
}

/// A way brought near unit length as normals are, and whether it has a direction. [Lyon, TR 43, fig.
/// 6]
fn direction(
    ways: &VectorWays,
    lyon: &LyonSpec,
    name: &str,
    way: &VectorWay<Sig>,
) -> (Vector, Sig) {
    let (b, vector) = (ways.forward.b, ways.way(name, way));
    b.instance(&format!("{name}_normalise"), || units::normalise(b, &vector, lyon))
}

/// What the lights have in common.
struct Pixel<'a> {
    ways: &'a VectorWays<'a>,
    /// V, and whether there is one.
    view: &'a (Vector, Sig),
    lyon: &'a LyonSpec,
    n: &'a Vector,
    has_direction: &'a Sig,
    shininess: &'a Sig,
    /// See [`least_distance`].
    apart: f64,
}

/// How far the directions of two lights are apart at least, in the ranges that the core is made
/// for.
fn least_distance(lights: &[LightInputs<LyonLight<Sig>, Sig>]) -> f64 {
    // Nothing is known of directions to places.
    let distance = |a: &Option<[Sig; 3]>, b: &Option<[Sig; 3]>| {
        let (Some(a), Some(b)) = (a, b) else { return 0.0 };
        let gap = |(a, b): (&Sig, &Sig)| {
            let (a, b, ulp) = (a.range(), b.range(), a.ulp());
            (a.low - b.high).max(b.low - a.high).max(0) as f64 * ulp
        };
        let off = |components: &[Sig; 3]| Vector::new(components.clone()).bound().error.length;
        let gaps = a.iter().zip(b).map(gap).map(|gap| gap * gap).sum::<f64>().sqrt();
        (gaps - off(a) - off(b)).max(0.0)
    };
    let pairs =
        lights.iter().enumerate().flat_map(|(i, a)| lights[..i].iter().map(move |b| (a, b)));
    pairs
        .map(|(a, b)| distance(&a.light.direction, &b.light.direction))
        .fold(f64::INFINITY, f64::min)
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &LyonLight<Sig>) -> Intensities {
        let (b, formats) = (self.ways.forward.b, &self.lyon.formats);
        match (&light.way, &light.direction) {
            (Some(way), _) => self.arriving(index, way),
            (None, Some(direction)) => {
                let halfway = light.halfway.clone().map(|halfway| self.given_halfway(halfway));
                let l = unit_vector(direction, formats.vector);
                let d = b.instance(&format!("light{index}_difference"), || {
                    self.difference(&l, halfway.as_ref())
                });
                self.intensities(index, &l, d)
            }
            (None, None) => unreachable!("`LyonSpec::light_inputs` gives each light one of both"),
        }
    }

    /// The intensities of a light whose way is followed.
    fn arriving(&self, index: usize, light: &VectorLight<Sig>) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        let b = self.ways.forward.b;
        let (view, is_seen) = self.view;
        let (l, exists) = direction(self.ways, self.lyon, &called("way"), &light.way);
        let halfway = match (self.lyon.difference, self.lyon.halfway) {
            (difference, _) if difference.takes_halfway() => {
                Some((&l + view).no_longer_than(l.longest() + view.longest()))
            }
            (difference, halfway) if difference.takes_unit_halfway() => {
                let half = self.ways.half_sum(&l, view);
                Some(b.instance(&called("halfway_normalise"), || match halfway {
                    Halfway::Half => half.clone(),
                    Halfway::Unit => {
                        units::normalise_exactly(b, &half, (&self.lyon.formats).into()).0
                    }
                    Halfway::HalfG2 => units::normalise(b, &half, &self.lyon.with_g2()).0,
                }))
            }
            _ => None,
        };
        let d = b.instance(&called("difference"), || self.difference(&l, halfway.as_ref()));
        let Intensities { diffuse, specular } = self.intensities(index, &l, d);
        let is_lit = exists.and(is_seen);
        let specular = is_lit.choose(&specular, &b.integer(0));
        let formats = [self.lyon.formats.diffuse, self.lyon.formats.shape];
        let bits = formats.map(|format| format.fraction_bits);
        self.ways.spotted(index, light, &l, (Intensities { diffuse, specular }, bits))
    }

    fn intensities(
        &self,
        index: usize,
        direction: &Vector,
        (d, length_error): (Vector, LengthError),
    ) -> Intensities {
        let (b, formats) = (self.ways.forward.b, &self.lyon.formats);
        let called = |unit: &str| format!("light{index}_{unit}");
        let shape = || match self.lyon.shape {
            ShapeDatapath::FK => {
                let f = units::shape(
                    b,
                    (&d, length_error),
                    self.shininess,
                    self.has_direction,
                    self.lyon,
                );
                self.alone(f, &d, length_error)
            }
            ShapeDatapath::Root => {
                units::root_shape(b, &d, self.shininess, self.has_direction, self.lyon)
            }
        };
        Intensities {
            diffuse: b
                .instance(&called("diffuse"), || units::diffuse(b, self.n, direction, formats)),
            specular: b.instance(&called("shape"), shape),
        }
    }

    /// A half-way vector that the host sends.
    ///
    /// g2 makes h longer than 1 by 0.00176 at most (methods B9), and rounding any by √3/2 units of
    /// the last place.
    fn given_halfway(&self, halfway: [Sig; 3]) -> Vector {
        let longest = if self.lyon.difference.takes_unit_halfway() { 1.002 } else { 2.0 };
        Vector::new(halfway).no_longer_than(longest + self.lyon.formats.vector.ulp())
    }

    /// Says of f that no two lights are near the middle of their highlights at once, which is proven
    /// of reflections.
    fn alone(&self, f: Sig, d: &Vector, length_error: LengthError) -> Sig {
        let (d, n) = (d.bound(), self.shininess.bound());
        if self.lyon.difference != Difference::ReflectionMinusLight {
            return f;
        }
        match error::shape::alone(f.bound(), (d, length_error), n, self.apart, self.lyon) {
            Some(model) => f.tighten_error("error::shape::alone", model),
            None => f,
        }
    }

    /// D, and how far its length is off.
    fn difference(&self, l: &Vector, halfway: Option<&Vector>) -> (Vector, LengthError) {
        let (b, n, formats) = (self.ways.forward.b, self.n, &self.lyon.formats);
        let view = &self.view.0;
        let Some(h) = halfway else {
            return match self.lyon.difference {
                Difference::LightReflection => units::light_reflection(b, n, l, view, formats),
                _ => units::reflection_minus_light(b, n, view, l, formats),
            };
        };
        let d = match self.lyon.difference {
            Difference::HalfwayCrossNormal => units::halfway_cross_normal(b, h, n, formats),
            Difference::UnitHalfwayMinusNormal => units::halfway_minus_normal(b, h, n, formats),
            _ => units::halfway_projection(b, h, n, formats),
        };
        let length_error = LengthError::whole(d.bound().error.length);
        (d, length_error)
    }
}
