//! The core of Hast's reflection shading.
use specula_spec::reflection::{
    Bisector, Highlight, ReflectedLight, ReflectionInputs, ReflectionLight, ReflectionSpec,
};
use specula_spec::{CoreParameters, InputPort, Linear, Quadratic};

use super::common::{Intensities, finish, squared_normal, time_slots};
use super::forward::Forward;
use super::ways::{Ways, alike};
use crate::error;
use crate::units::{self, Base, Length, QuotientFormat};
use specula_datapath::bound::Interval;
use specula_datapath::builder::{BuildError, Builder, Sig};
use specula_datapath::graph::Graph;

/// What is known of q. Where it and all numerators are 0, nothing is lit, whatever q is.
const SMALLEST_SQUARE: &str = "|H|^2 is no smaller, or it and all numerators are 0";

/// |H|² of H = (N + n)/2 is no smaller along any span, except those where it and all numerators are 0.
///
/// n is no more than a right angle from N, so H·n ≥ 1/2. Where it halves the angle f between the
/// ends, N·n = cos(f/2) all along, and that is no less than s = `shortest_normal`, so that H·n ≥
/// (1 + s)/2: let the end normals have lengths 1 and β ≤ 1. Where the foot of the perpendicular on
/// their chord lies between them, s is its length, and the ends are acos s and acos(s/β) ≤ acos s
/// from it; elsewhere it is β ≤ cos f. So f ≤ 2 acos s.
fn smallest_square(bisector: Bisector, shortest_normal: f64) -> f64 {
    match bisector {
        Bisector::Span => ((1.0 + shortest_normal) / 2.0).powi(2),
        Bisector::Triangle => 0.25,
    }
}

/// Quotients of quadratics by forward differences, all by one reciprocal. [Hast et al., eq. 27 to
/// 34]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    reflection: &ReflectionSpec,
    ports: &ReflectionInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let mut inputs = ports.map(|port| b.input(port));
    alike(&b, &slots, &mut inputs.lights, |light| light.way.as_mut().map(|to| &mut to.way));
    let f = &reflection.formats;
    let forward = Forward { b: &b, first: &slots.first_pixel, steps: parameters.longest_span - 1 };
    let q = forward
        .quadratic("denominator", &inputs.span.denominator, (0.0, 1.0), f.operand.fraction_bits)
        .named("q");
    let smallest = smallest_square(reflection.bisector, parameters.shortest_normal);
    let q = q.real_within(Interval::at_least(smallest), SMALLEST_SQUARE);
    let to = QuotientFormat { integer_bits: 2, fraction_bits: f.reciprocal.fraction_bits };
    let reciprocal =
        b.instance("reciprocal", || units::quotient(&b, &b.integer(1), &q, to)).named("w");
    let unsure = error::cosine::direction_error(q.bound());
    let has_direction = b
        .integer(0)
        .less_than(&q)
        .named("has_direction")
        .override_error("error::cosine::direction_error", unsure);
    let exponent = &inputs.span.exponent;
    let ways = Ways::new(forward, parameters, reflection.ways(), &slots);
    let linear =
        |name: &str, linear: Option<&Linear<Sig>>| linear.map(|linear| ways.linear(name, linear));
    let mut pixel = Pixel {
        ways: &ways,
        h_dot_n: linear("h_dot_n", inputs.span.h_dot_n.as_ref()),
        normal_view: linear("normal_view", inputs.span.normal_view.as_ref()),
        eye: None,
        reflection,
        q,
        reciprocal,
        has_direction,
        view: None,
        normal_squared: None,
        exponent,
    };
    pixel.view = inputs.span.view.as_ref().map(|view| pixel.cosine("view", view));
    if let Some(eye) = &inputs.span.eye {
        let length = ways.length("eye", &eye.squared);
        pixel.view = Some(pixel.of_way("view", (&eye.bisecting, &eye.fixed), &length));
        pixel.normal_view = eye.normal.as_ref().map(|normal| {
            let normal = ways.quadratic("eye_normal", normal);
            ways.cosine("normal_view_cosine", &normal, &length)
        });
        pixel.eye = Some(length);
    }
    let normal_squared = |square| {
        let squared = forward
            .quadratic("normal_squared", square, (0.0, 1.0), f.operand.fraction_bits)
            .named("normal_squared");
        squared_normal(squared, parameters)
    };
    pixel.normal_squared = inputs.span.normal_squared.as_ref().map(normal_squared);
    finish(&b, parameters, &slots, &inputs, |i, light| pixel.shade(i, light))
}

/// What the lights have in common.
struct Pixel<'a> {
    ways: &'a Ways<'a>,
    /// H·n, with ways to places.
    h_dot_n: Option<Sig>,
    /// N·V, with ways to places where the highlight asks for it.
    normal_view: Option<Sig>,
    /// What divides by the way to an eye at a place.
    eye: Option<Length>,
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
        self.ways.quadratic(instance, numerator)
    }

    /// N'·u, of its numerator.
    fn cosine(&self, called: &str, numerator: &Quadratic<Sig>) -> Sig {
        let p = self.operand(&format!("{called}_numerator"), numerator);
        let fraction_bits = self.reflection.formats.cosine.fraction_bits;
        self.over_square(&format!("{called}_cosine"), &p, fraction_bits)
    }

    /// P/q.
    fn over_square(&self, instance: &str, p: &Sig, fraction_bits: u32) -> Sig {
        let b = self.ways.forward.b;
        b.instance(instance, || {
            units::cosine_by_reciprocal(b, p, &self.q, &self.reciprocal, fraction_bits)
        })
    }

    /// N'·X over the length of a way X, of H·X and n·X.
    fn of_way(
        &self,
        called: &str,
        (bisecting, fixed): (&Quadratic<Sig>, &Linear<Sig>),
        length: &Length,
    ) -> Sig {
        let (ways, f) = (self.ways, &self.reflection.formats);
        let h_dot_n = self.h_dot_n.as_ref().expect("ways come with H.n");
        let h = ways.quadratic(&format!("{called}_bisecting"), bisecting);
        let n = ways.linear(&format!("{called}_fixed"), fixed);
        let p = ways.reflected(&format!("{called}_numerator"), [&h, h_dot_n], &n, &self.q);
        let along = self.over_square(&format!("{called}_along"), &p, f.operand.fraction_bits);
        let b = ways.forward.b;
        b.instance(&format!("{called}_cosine"), || {
            units::cosine(b, &along, length, f.cosine.fraction_bits)
        })
    }

    fn shade(&self, index: usize, light: &ReflectionLight<Sig>) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        match (&light.cosine, &light.way) {
            (_, Some(way)) => self.arriving(index, way),
            (Some(cosine), None) => {
                let cosine = self.cosine(&format!("light{index}"), cosine);
                let base = self.base(&called, light, &cosine);
                self.intensities(&called, &cosine, &base)
            }
            (None, None) => unreachable!("`ReflectionSpec` gives each light one of both"),
        }
    }

    /// The intensities of a light whose way is followed.
    fn arriving(&self, index: usize, way: &ReflectedLight<Sig>) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        let (b, ways) = (self.ways.forward.b, self.ways);
        let fraction_bits = self.reflection.formats.base.fraction_bits;
        let arrival = ways.arrival(index, &way.way, self.eye.as_ref());
        let cosine = self.of_way(&called("way"), (&way.bisecting, &way.fixed), &arrival.length);
        let base = match (self.reflection.specular, &way.normal) {
            (Highlight::Blinn, _) => {
                let cosines = [self.view.as_ref().expect(GIVEN), &cosine];
                ways.halfway(index, cosines, &arrival, self.eye.as_ref())
            }
            (Highlight::Hybrid, Some(normal)) => {
                let normal = ways.quadratic(&called("way_normal"), normal);
                let l = ways.cosine(&called("normal_light"), &normal, &arrival.length);
                let (v, q) = (
                    self.normal_view.as_ref().expect(GIVEN),
                    self.normal_squared.as_ref().expect(GIVEN),
                );
                let p = ways.reflected(&called("hybrid_numerator"), [v, &l], &arrival.dot_view, q);
                b.instance(&called("divider"), || units::divider(b, &p, q, fraction_bits))
            }
            _ => self.eq34(&called, &cosine, &arrival.dot_view),
        };
        let formats = [self.reflection.formats.diffuse, self.reflection.power_unit().format()];
        arrival.spotted(
            self.intensities(&called, &cosine, &base),
            formats.map(|format| format.fraction_bits),
        )
    }

    fn intensities(
        &self,
        called: &impl Fn(&str) -> String,
        cosine: &Sig,
        base: &Sig,
    ) -> Intensities {
        let (b, f) = (self.ways.forward.b, &self.reflection.formats);
        let power = || units::raised(b, base, self.exponent, self.reflection.power_unit());
        Intensities {
            diffuse: b.instance(&called("diffuse"), || {
                units::clamp_nonnegative(b, cosine, f.diffuse.fraction_bits)
            }),
            specular: b.instance(&called("power"), power),
        }
    }

    fn eq34(&self, called: &impl Fn(&str) -> String, cosine: &Sig, dot_view: &Sig) -> Sig {
        let (b, v) = (self.ways.forward.b, self.view.as_ref().expect(GIVEN));
        let fraction_bits = self.reflection.formats.base.fraction_bits;
        let to = Base { fraction_bits, product_error: f64::INFINITY };
        b.instance(&called("base"), || {
            units::reflected_base(b, (v, cosine), dot_view, &self.has_direction, to)
        })
    }

    fn base(
        &self,
        called: &impl Fn(&str) -> String,
        light: &ReflectionLight<Sig>,
        cosine: &Sig,
    ) -> Sig {
        let b = self.ways.forward.b;
        let fraction_bits = self.reflection.formats.base.fraction_bits;
        match self.reflection.specular {
            Highlight::Blinn => {
                let cosine = self.cosine(&called("halfway"), light.halfway.as_ref().expect(GIVEN));
                b.instance(&called("base"), || units::clamp_nonnegative(b, &cosine, fraction_bits))
            }
            Highlight::Hybrid => {
                let p = self
                    .operand(&called("hybrid_numerator"), light.numerator.as_ref().expect(GIVEN));
                let q = self.normal_squared.as_ref().expect(GIVEN);
                b.instance(&called("divider"), || units::divider(b, &p, q, fraction_bits))
            }
            Highlight::Eq34 => self.eq34(called, cosine, light.dot_view.as_ref().expect(GIVEN)),
        }
    }
}

const GIVEN: &str = "inputs are those that the highlight asks for";

#[cfg(test)]
mod tests {
    use specula_spec::reflection::Bisector;

    use super::smallest_square;

    /// Ends of lengths 1 and β, an angle f apart, in the plane: N between the unit ends, n in their
    /// middle.
    #[test]
    fn halfway_vectors_are_no_shorter_than_stated() {
        let mut closest = f64::INFINITY;
        for degrees in (1..180).step_by(7) {
            let f = f64::from(degrees).to_radians();
            for beta in [0.05, 0.3, 0.7, 0.95, 1.0] {
                let points = (0..=1000).map(|i| f64::from(i) / 1000.0);
                let length =
                    |t: f64, end: f64| (1.0 - t + t * end * f.cos()).hypot(t * end * f.sin());
                let shortest = points.clone().map(|t| length(t, beta)).fold(1.0, f64::min);
                let (c, s) = ((f / 2.0).cos(), (f / 2.0).sin());
                let square = |t: f64| ((c + 1.0) / 2.0).powi(2) + (s * (t - 0.5)).powi(2);
                let smallest = points.map(square).fold(1.0, f64::min);
                // The shortest of a thousand points is a little longer than the foot of the
                // perpendicular.
                let stated = smallest_square(Bisector::Span, shortest - 1e-3);
                assert!(
                    stated <= smallest,
                    "{degrees} degrees, {beta}: {stated} against {smallest}"
                );
                closest = closest.min(smallest / stated);
            }
        }
        assert!(closest < 1.002, "{closest}");
    }
}
