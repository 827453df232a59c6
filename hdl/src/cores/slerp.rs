//! The core of spherical interpolation.
use specula_spec::slerp::{
    Basis, OnArc, SlerpFormats, SlerpInputs, SlerpLight, SlerpSpan, SlerpSpec,
};
use specula_spec::{CoreParameters, InputPort};

use super::common::{Intensities, eye, finish, time_slots, unit_vector};
use crate::error;
use crate::error::turned_normal::Weighing;
use crate::units::{self, Turn};
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
    let inputs = ports.map(|port| b.input(port));
    let (formats, steps) = (&slerp.formats, parameters.longest_span - 1);
    let [u, v] = weights(&b, &slots.first_pixel, &inputs.span, slerp, steps);
    let weights = [&u, &v];
    let normal = inputs.span.normal.as_ref().map(|axes| {
        let known = match slerp.frame {
            Basis::Orthonormal => Weighing::orthonormal(formats, steps),
            Basis::Ends => Weighing::between_ends(formats, steps, parameters.shortest_normal),
        };
        let [start, other] =
            [&axes.start, &axes.other].map(|axis| unit_vector(axis, formats.vector));
        units::turned_normal(&b, weights, [&start, &other], formats, known)
    });
    let n_dot_v = match &normal {
        Some(n) => b.instance("n_dot_v", || {
            units::cosine_between(&b, n, &eye(&b), formats.cosine.fraction_bits)
        }),
        None => {
            let n_dot_v = b.instance("n_dot_v", || {
                on_arc(&b, weights, inputs.span.view.as_ref(), formats, steps)
            });
            units::corrected(&b, &n_dot_v, weights, formats, steps)
        }
    };
    let base = error::turned::base(formats, steps, parameters.shortest_normal);
    let pixel = Pixel {
        b: &b,
        parameters,
        slerp,
        weights,
        normal: normal.as_ref(),
        n_dot_v: &n_dot_v,
        exponent: &inputs.span.exponent,
        base,
    };
    finish(&b, &slots, &inputs, |i, light| pixel.shade(i, light))
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

/// What the lights have in common.
struct Pixel<'a> {
    b: &'a Builder,
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
        let (b, formats) = (self.b, &self.slerp.formats);
        let called = |unit: &str| format!("light{index}_{unit}");
        let n_dot_l = b.instance(&called("n_dot_l"), || self.n_dot_l(light));
        let base = b.instance(&called("base"), || self.base(&n_dot_l, light));
        let power = || units::raised(b, &base, self.exponent, self.slerp.power_unit());
        Intensities {
            diffuse: b.instance(&called("diffuse"), || {
                units::clamp_unit(b, &n_dot_l, formats.diffuse.fraction_bits)
            }),
            specular: b.instance(&called("power"), power),
        }
    }

    fn n_dot_l(&self, light: &SlerpLight<Sig>) -> Sig {
        let (b, formats) = (self.b, &self.slerp.formats);
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

    fn base(&self, n_dot_l: &Sig, light: &SlerpLight<Sig>) -> Sig {
        let (b, formats) = (self.b, &self.slerp.formats);
        match self.normal {
            Some(_) => units::reflected_cosine(
                b,
                self.n_dot_v,
                n_dot_l,
                &light.light_dot_view,
                formats.base.fraction_bits,
            ),
            None => units::specular_base(
                b,
                n_dot_l,
                self.n_dot_v,
                &light.light_dot_view,
                self.base,
                formats,
            ),
        }
    }
}
