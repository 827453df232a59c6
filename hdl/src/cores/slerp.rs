//! The core of spherical interpolation.
use specula_spec::slerp::{
    Basis, LightAlongArc, OnArc, SlerpFormats, SlerpInputs, SlerpLight, SlerpSpan, SlerpSpec,
    WayAlongArc,
};
use specula_spec::ways::VectorWay;
use specula_spec::{CoreParameters, InputPort, Linear};

use super::common::{Intensities, eye as infinite_eye, finish, time_slots, unit_vector};
use super::forward::Forward;
use super::ways::{Ways, alike};
use crate::error;
use crate::error::turned_normal::Weighing;
use crate::units::{self, Length, Turn};
use specula_datapath::bound::Angular;
use specula_datapath::builder::{BuildError, Builder, Sig, Vector};
use specula_datapath::graph::Graph;

/// One rotation, and what it makes of N·V and of each light's N·L, or of the normal; specular base
/// 2 J K - L·V, then its power. [lecture, eq. 4.5, 4.7 to 4.12]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    slerp: &SlerpSpec,
    ports: &SlerpInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let mut inputs = ports.map(|port| b.input(port));
    alike(&b, &slots, &mut inputs.lights, |light| light.way.as_mut().map(|to| &mut to.way));
    let (formats, steps) = (&slerp.formats, parameters.longest_span - 1);
    let shortest_chord = slerp.shortest_chord(parameters.shortest_normal);
    let [u, v] = weights(&b, &slots.first_pixel, &inputs.span, slerp, steps);
    let weights = [&u, &v];
    let normal = inputs.span.normal.as_ref().map(|axes| {
        let known = match slerp.frame {
            Basis::Orthonormal => Weighing::orthonormal(formats, steps),
            Basis::Ends => Weighing::between_ends(formats, steps, shortest_chord),
        };
        let [start, other] =
            [&axes.start, &axes.other].map(|axis| unit_vector(axis, formats.vector));
        units::turned_normal(&b, weights, [&start, &other], formats, known)
    });
    let forward = Forward { b: &b, first: &slots.first_pixel, steps };
    let ways = Ways::new(forward, parameters, slerp.ways(), &slots);
    let eye = inputs.span.eye.as_ref().map(|eye| ways.length("eye", &eye.squared));
    let to_eye = inputs.span.eye.as_ref().zip(eye.as_ref());
    let n_dot_v = match (to_eye, &normal) {
        (Some((to, length)), _) => {
            let along = along_way(&ways, "eye", &to.normal, (normal.as_ref(), weights));
            ways.cosine("n_dot_v", &along, length)
        }
        (None, Some(n)) => b.instance("n_dot_v", || {
            units::cosine_between(&b, n, &infinite_eye(&b), formats.cosine.fraction_bits)
        }),
        (None, None) => {
            b.instance("n_dot_v", || on_arc(&b, weights, inputs.span.view.as_ref(), formats, steps))
        }
    };
    let n_dot_v = match normal {
        Some(_) => n_dot_v,
        None => units::corrected(&b, &n_dot_v, weights, formats, steps),
    };
    let base = error::turned::base(formats, steps, shortest_chord);
    let pixel = Pixel {
        ways: &ways,
        eye: eye.as_ref(),
        parameters,
        slerp,
        weights,
        normal: normal.as_ref(),
        n_dot_v: &n_dot_v,
        exponent: &inputs.span.exponent,
        base,
    };
    finish(&b, parameters, &slots, &inputs, |i, light| pixel.shade(i, light))
}

/// The weights of what stands at the start and of what goes with it.
fn weights(
    b: &Builder,
    first: &Sig,
    inputs: &SlerpSpan<Sig>,
    slerp: &SlerpSpec,
    steps: u32,
) -> [Sig; 2] {
    let (formats, cosine, sine) = (&slerp.formats, &inputs.turn_cosine, &inputs.turn_sine);
    let turned = match (&inputs.turn_back, &inputs.rising_cosine, &inputs.falling_cosine) {
        (Some(back), Some(rising), Some(falling)) => {
            let turn = |name: &str, starts: [&Sig; 2], [down, up]: [&Sig; 2]| {
                let turn = Turn { cosine, down, up };
                b.instance(name, || units::scaled_rotation(b, first, starts, turn, formats, steps))
            };
            let [falling, _] = turn("falling", [&b.integer(1), falling], [sine, back]);
            let [_, rising] = turn("rising", [rising, &b.integer(0)], [back, sine]);
            [falling, rising]
        }
        _ => units::rotation(b, first, [cosine, sine], formats, steps),
    };
    turned.map(|x| x.rounded(formats.weight.fraction_bits).named("weight"))
}

/// N·X; scalars have ports wherever there is no normal.
fn on_arc(
    b: &Builder,
    weights: [&Sig; 2],
    scalars: Option<&OnArc<Sig>>,
    formats: &SlerpFormats,
    steps: u32,
) -> Sig {
    let zero = b.integer(0);
    let [start, across] =
        scalars.map_or([&zero, &zero], |scalars| [&scalars.start, &scalars.across]);
    units::along_arc(b, weights, [start, across], formats, steps)
}

/// N·X of a way X, as an operand: of its scalars, or of the way itself where there is a normal.
fn along_way(
    ways: &Ways,
    name: &str,
    way: &WayAlongArc<Sig>,
    (normal, weights): (Option<&Vector>, [&Sig; 2]),
) -> Sig {
    let b = ways.forward.b;
    let linear = |part: &str, linear: Option<&Linear<Sig>>| {
        linear.map_or_else(|| b.integer(0), |linear| ways.linear(&format!("{name}_{part}"), linear))
    };
    let bits = ways.formats.operand.fraction_bits;
    match (normal, &way.vector) {
        (Some(normal), Some(VectorWay { x, y, z })) => {
            let way = [("x", x), ("y", y), ("z", z)]
                .map(|(part, component)| linear(part, Some(component)));
            b.instance(&format!("{name}_normal"), || {
                units::product_with_way(b, normal, &Vector::new(way), bits)
            })
        }
        _ => {
            let scalars =
                [linear("start", way.start.as_ref()), linear("across", way.across.as_ref())];
            b.instance(&format!("{name}_normal"), || {
                units::way_along_arc(b, weights, scalars.each_ref(), bits)
            })
        }
    }
}

/// What the lights have in common.
struct Pixel<'a> {
    ways: &'a Ways<'a>,
    /// What divides by the way to an eye at a place.
    eye: Option<&'a Length>,
    parameters: &'a CoreParameters,
    slerp: &'a SlerpSpec,
    weights: [&'a Sig; 2],
    /// The normal, if that is what turns.
    normal: Option<&'a Vector>,
    n_dot_v: &'a Sig,
    exponent: &'a Sig,
    /// What is proven of the base of each highlight, if it is made of scalars.
    base: Angular,
}

impl Pixel<'_> {
    fn shade(&self, index: usize, light: &SlerpLight<Sig>) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        match (&light.way, &light.light_dot_view) {
            (Some(light), _) => self.arriving(index, light),
            (None, Some(dot_view)) => {
                let b = self.ways.forward.b;
                let n_dot_l = b.instance(&called("n_dot_l"), || self.n_dot_l(light));
                let base = b.instance(&called("base"), || self.base(&n_dot_l, dot_view));
                self.intensities(&called, &n_dot_l, &base)
            }
            (None, None) => unreachable!("`SlerpSpec::light_inputs` gives each light one of both"),
        }
    }

    /// The intensities of a light whose way is followed.
    fn arriving(&self, index: usize, light: &LightAlongArc<Sig>) -> Intensities {
        let called = |unit: &str| format!("light{index}_{unit}");
        let (b, ways) = (self.ways.forward.b, self.ways);
        let arrival = ways.arrival(index, &light.way, self.eye);
        let normal = (self.normal, self.weights);
        let along = along_way(ways, &called("way"), &light.normal, normal);
        let n_dot_l = ways.cosine(&called("n_dot_l"), &along, &arrival.length);
        let bits = self.slerp.formats.base.fraction_bits;
        let base = b.instance(&called("base"), || {
            units::reflected_cosine(b, self.n_dot_v, &n_dot_l, &arrival.dot_view, bits)
        });
        let formats = [self.slerp.formats.diffuse, self.slerp.power_unit().format()];
        arrival.spotted(
            self.intensities(&called, &n_dot_l, &base),
            formats.map(|format| format.fraction_bits),
        )
    }

    fn intensities(
        &self,
        called: &impl Fn(&str) -> String,
        n_dot_l: &Sig,
        base: &Sig,
    ) -> Intensities {
        let (b, formats) = (self.ways.forward.b, &self.slerp.formats);
        let power = || units::raised(b, base, self.exponent, self.slerp.power_unit());
        Intensities {
            diffuse: b.instance(&called("diffuse"), || {
                units::clamp_unit(b, n_dot_l, formats.diffuse.fraction_bits)
            }),
            specular: b.instance(&called("power"), power),
        }
    }

    fn n_dot_l(&self, light: &SlerpLight<Sig>) -> Sig {
        let (b, formats) = (self.ways.forward.b, &self.slerp.formats);
        match (self.normal, &light.direction) {
            (Some(n), Some(direction)) => units::cosine_between(
                b,
                n,
                &unit_vector(direction, formats.vector),
                formats.cosine.fraction_bits,
            ),
            _ => on_arc(
                b,
                self.weights,
                light.light.as_ref(),
                formats,
                self.parameters.longest_span - 1,
            ),
        }
    }

    fn base(&self, n_dot_l: &Sig, light_dot_view: &Sig) -> Sig {
        let (b, formats) = (self.ways.forward.b, &self.slerp.formats);
        match self.normal {
            Some(_) => units::reflected_cosine(
                b,
                self.n_dot_v,
                n_dot_l,
                light_dot_view,
                formats.base.fraction_bits,
            ),
            None => {
                units::specular_base(b, n_dot_l, self.n_dot_v, light_dot_view, self.base, formats)
            }
        }
    }
}
