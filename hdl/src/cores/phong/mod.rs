//! Phong's core.
mod direction;
mod lamp;

use specula_spec::phong::{Highlight, PhongInputs, PhongLight, PhongSpec, Places};
use specula_spec::{CoreInputs, CoreParameters, InputPort};

use super::common::{Intensities, eye, finish, time_slots, unit_vector};
use super::forward::Forward;
use crate::error;
use crate::units::{self, HalfwayGain, Interpolation};
use specula_datapath::builder::{BuildError, Builder, Sig, TimeSlots};
use specula_datapath::graph::Graph;

use direction::Direction;
use lamp::{Kinds, Lamp, alike};

/// Interpolated vectors, true normalisation or wraps, and for each light N·L and a power or a
/// distribution. [lecture, eq. 2.1, 4.1, 4.2; Hast et al., eq. 35 to 38]
pub(super) fn core(
    b: Builder,
    parameters: &CoreParameters,
    phong: &PhongSpec,
    ports: &PhongInputs<InputPort>,
) -> Result<Graph, BuildError> {
    let slots = time_slots(&b, parameters);
    let inputs = ports.map(|port| b.input(port));
    let f = &phong.formats;
    let interpolation = Interpolation {
        accumulator: f.weight_accumulator,
        weight: f.weight,
        vector: f.vector,
        longest: 1.0,
        apart: error::interpolate::chord(parameters.shortest_normal.min(parameters.shortest_way)),
        steps: parameters.longest_span - 1,
    };
    let step = inputs.span.weight_step.as_ref();
    let pixel = Pixel {
        b: &b,
        parameters,
        phong,
        interpolation,
        weight: step.map(|step| units::weight(&b, &slots.first_pixel, step, interpolation)),
        forward: Forward { b: &b, first: &slots.first_pixel, steps: parameters.longest_span - 1 },
        shininess: &inputs.span.shininess,
    };
    pixel.finish(&slots, &inputs)
}

/// What the vectors of a pixel have in common.
struct Pixel<'a> {
    b: &'a Builder,
    parameters: &'a CoreParameters,
    phong: &'a PhongSpec,
    interpolation: Interpolation,
    /// a, where increments are multiplied.
    weight: Option<Sig>,
    forward: Forward<'a>,
    shininess: &'a Sig,
}

/// A light at the pixel.
struct Arrival<'a> {
    index: usize,
    lamp: &'a Lamp<'a>,
    direction: &'a Direction,
    view: &'a Direction,
    n_dot_v: &'a Sig,
    n_dot_l: Sig,
}

impl Pixel<'_> {
    fn finish(&self, slots: &TimeSlots, inputs: &PhongInputs<Sig>) -> Result<Graph, BuildError> {
        let b = self.b;
        let normal = self.along("normal", &inputs.span.normal, self.parameters.shortest_normal);
        let view = match &inputs.span.eye {
            Some(way) => self.to_place("eye", way, &b.integer(0)),
            None => Direction::new(eye(b), b.integer(1)),
        };
        let n_dot_v = self.cosine("n_dot_v", &normal, &view);
        let kinds = Kinds::new(b, &inputs.lights);
        let shade = |index: usize, light: &PhongLight<Sig>| {
            let lamp = &kinds.lamp(slots, index, light);
            let direction = self.direction(index, lamp);
            let n_dot_l = self.cosine(&format!("light{index}_n_dot_l"), &normal, &direction);
            let arrival = Arrival {
                index,
                lamp,
                direction: &direction,
                view: &view,
                n_dot_v: &n_dot_v,
                n_dot_l,
            };
            self.shade(&arrival, &normal.exists.and(&direction.exists))
        };
        if slots.count() == 1 {
            return finish(b, self.parameters, slots, inputs, shade);
        }
        let ambient = inputs.ambient.clone();
        let inputs = CoreInputs { span: (), ambient, lights: alike(b, &inputs.lights).collect() };
        finish(b, self.parameters, slots, &inputs, shade)
    }

    fn cosine(&self, name: &str, x: &Direction, y: &Direction) -> Sig {
        let fraction_bits = self.phong.formats.cosine.fraction_bits;
        self.b.instance(name, || units::cosine_between(self.b, &x.vector, &y.vector, fraction_bits))
    }

    fn shade(&self, at: &Arrival, lit: &Sig) -> Intensities {
        let zero = self.b.integer(0);
        let diffuse = at.n_dot_l.at_least_zero();
        let specular = at.view.exists.choose(&self.highlight(at), &zero);
        let most_at_edge = at.direction.wrap.as_ref().map_or(0.0, |wrap| wrap.most_at_edge);
        let where_lit = |amount: Sig| at_edge(lit.choose(&amount, &zero), most_at_edge);
        let [diffuse, specular] = self.spotted(at, [diffuse, specular]).map(where_lit);
        Intensities { diffuse, specular }
    }

    fn highlight(&self, at: &Arrival) -> Sig {
        let (b, f) = (self.b, &self.phong.formats);
        let called = |unit: &str| format!("light{}_{unit}", at.index);
        let base_bits = f.base.fraction_bits;
        let cosines = [at.n_dot_v, &at.n_dot_l];
        let gain = || match at.lamp.light.halfway_gain.as_ref() {
            None => self.halfway_gain(at),
            sent => HalfwayGain::given(self.unless_sent(at, sent, || self.halfway_gain(at).gain)),
        };
        let base = match self.phong.highlight {
            Highlight::Reflection => {
                let l_dot_v = self
                    .unless_sent(at, at.lamp.light.light_dot_view.as_ref(), || self.l_dot_v(at));
                let base =
                    || units::reflected_cosine(b, at.n_dot_v, &at.n_dot_l, &l_dot_v, base_bits);
                b.instance(&called("reflected_cosine"), base)
            }
            Highlight::Blinn | Highlight::TrowbridgeReitz => {
                let base = || units::halfway_cosine(b, cosines, &gain(), base_bits);
                b.instance(&called("halfway_cosine"), base)
            }
            Highlight::TorranceSparrow => {
                let base = || units::halfway_versine(b, cosines, &gain(), base_bits);
                b.instance(&called("halfway_versine"), base)
            }
        };
        let shape_bits = f.shape.fraction_bits;
        match self.phong.highlight {
            Highlight::Reflection | Highlight::Blinn => b.instance(&called("power"), || {
                units::any_power(b, &base, self.shininess, shape_bits)
            }),
            Highlight::TorranceSparrow => b.instance(&called("distribution"), || {
                units::gaussian(b, &base, self.shininess, shape_bits)
            }),
            Highlight::TrowbridgeReitz => {
                let distribution =
                    || units::trowbridge_reitz(b, &base, self.shininess, base_bits, shape_bits);
                b.instance(&called("distribution"), distribution)
            }
        }
    }

    /// What the host sends of lights at infinity, and what is worked out here of those at places.
    fn unless_sent(
        &self,
        at: &Arrival,
        sent: Option<&Sig>,
        worked_out: impl FnOnce() -> Sig,
    ) -> Sig {
        match sent {
            Some(sent) if at.lamp.light.way.is_none() => sent.clone(),
            Some(sent) => at.lamp.local.choose(&worked_out(), sent),
            None => worked_out(),
        }
    }

    fn l_dot_v(&self, at: &Arrival) -> Sig {
        self.cosine(&format!("light{}_l_dot_v", at.index), at.direction, at.view)
    }

    fn halfway_gain(&self, at: &Arrival) -> HalfwayGain {
        let l_dot_v = self.l_dot_v(at);
        let bits = self.phong.formats.length_squared.fraction_bits;
        // Wrapped directions are others than those that the scene's needs know.
        let shortest = match self.phong.places {
            Places::Exact => self.parameters.shortest_halfway,
            Places::Wrapped => 0.0,
        };
        let gain = || units::halfway_gain(self.b, &l_dot_v, shortest, bits, self.reciprocal());
        self.b.instance(&format!("light{}_halfway_gain", at.index), gain)
    }

    /// What a spot leaves of a light.
    fn spotted(&self, at: &Arrival, amounts: [Sig; 2]) -> [Sig; 2] {
        let Some(exponent) = &at.lamp.light.exponent else { return amounts };
        let (b, shape_bits, largest) = (
            self.b,
            self.phong.formats.shape.fraction_bits,
            self.parameters.largest_spot_exponent(),
        );
        let cosine = self.spot_cosine(at);
        let share = || units::any_power_up_to(b, &cosine, exponent, largest.into(), shape_bits);
        let share = b.instance(&format!("light{}_spot", at.index), share);
        amounts.map(|amount| at.lamp.spot.choose(&(&amount * &share).rounded(shape_bits), &amount))
    }

    /// The cosine between a spot's axis and the way from it.
    fn spot_cosine(&self, at: &Arrival) -> Sig {
        let (b, f) = (self.b, &self.phong.formats);
        match (&at.direction.wrap, &at.lamp.light.axis) {
            (Some(wrap), _) => wrap.cosine.clone(),
            (None, Some(axis)) => {
                let axis = unit_vector(axis, f.vector);
                let cosine =
                    || units::spot_cosine(b, &at.direction.vector, &axis, f.base.fraction_bits);
                b.instance(&format!("light{}_spot_cosine", at.index), cosine)
            }
            (None, None) => {
                unreachable!("`PhongSpec::light_inputs` gives each spot an axis or a wrap")
            }
        }
    }
}

/// What a light gives where rounding decides whether a spot is seen: it may be off by `most`.
fn at_edge(amount: Sig, most: f64) -> Sig {
    if most == 0.0 {
        return amount;
    }
    let bound = error::wrapped::at_edge(amount.bound(), most);
    amount.override_error("error::wrapped::at_edge", bound)
}
