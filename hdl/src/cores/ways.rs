//! Ways X to lights and to the eye at places: cosines are scalars along the span over √(X·X).
use specula_spec::ways::{EyeCosine, LightCosine, LightWay, SpotWay, WayFormats};
use specula_spec::{CoreParameters, LightInputs, Linear, Quadratic};

use super::common::Intensities;
use super::forward::Forward;
use crate::units::{self, Length, ReciprocalRoot};
use specula_datapath::bound::Interval;
use specula_datapath::builder::{Builder, Sig, TimeSlots};

/// What a scene's needs say of the ways along spans.
pub(super) const SHORTEST_WAY: &str = "no way between two ends is shorter than in any span";

/// The ways of a core.
#[derive(Clone)]
pub(super) struct Ways<'a> {
    pub forward: Forward<'a>,
    pub parameters: &'a CoreParameters,
    pub formats: WayFormats,
    /// Whether the light of each pipeline is a spot.
    spots: Vec<Sig>,
}

/// What a way to a light makes of it.
pub(super) struct Arrival {
    /// What divides by its length.
    pub length: Length,
    /// L·V.
    pub dot_view: Sig,
    /// Whether it is a spot, and what that leaves of the light.
    share: Option<[Sig; 2]>,
}

impl<'a> Ways<'a> {
    pub fn new(
        forward: Forward<'a>,
        parameters: &'a CoreParameters,
        formats: WayFormats,
        slots: &TimeSlots,
    ) -> Ways<'a> {
        Ways { forward, parameters, formats, spots: spots(forward.b, parameters, slots) }
    }

    /// A quadratic from -1 to 1 at the pixel, as an operand.
    pub fn quadratic(&self, instance: &str, quadratic: &Quadratic<Sig>) -> Sig {
        let bits = self.formats.operand.fraction_bits;
        self.forward.quadratic(instance, quadratic, (-1.0, 1.0), bits)
    }

    /// Something linear from -1 to 1 at the pixel, as an operand.
    pub fn linear(&self, instance: &str, linear: &Linear<Sig>) -> Sig {
        self.forward.linear(instance, linear, self.formats.operand.fraction_bits)
    }

    /// What divides by the length of a way.
    pub fn length(&self, name: &str, squared: &Quadratic<Sig>) -> Length {
        let (b, f) = (self.forward.b, &self.formats);
        let bits = f.operand.fraction_bits;
        let q = self
            .forward
            .quadratic(&format!("{name}_squared"), squared, (0.0, 1.0), bits)
            .named(&format!("{name}_squared"));
        let least = self.parameters.shortest_way * self.parameters.shortest_way;
        let q = q.real_within(Interval::at_least(least), SHORTEST_WAY);
        b.instance(&format!("{name}_root"), || units::root(b, &q, f.root))
    }

    /// A scalar over the length of a way, kept within -1 to 1.
    pub fn cosine(&self, instance: &str, scalar: &Sig, length: &Length) -> Sig {
        self.cosine_to(instance, scalar, length, self.formats.operand.fraction_bits)
    }

    fn cosine_to(&self, instance: &str, scalar: &Sig, length: &Length, fraction_bits: u32) -> Sig {
        let b = self.forward.b;
        b.instance(instance, || units::cosine(b, scalar, length, fraction_bits))
    }

    /// N·V of an eye at a place, and what divides by the way to it.
    pub fn eye(&self, eye: &EyeCosine<Sig>) -> (Sig, Length) {
        let length = self.length("eye", &eye.squared);
        let normal = self.quadratic("eye_normal", &eye.normal);
        (self.cosine("eye_cosine", &normal, &length), length)
    }

    /// N·L, and what else the way to a light makes of it.
    pub fn light(
        &self,
        index: usize,
        light: &LightCosine<Sig>,
        eye: Option<&Length>,
    ) -> (Sig, Arrival) {
        let called = |part: &str| format!("light{index}_{part}");
        let arrival = self.arrival(index, &light.way, eye);
        let normal = self.quadratic(&called("way_normal"), &light.normal);
        (self.cosine(&called("way_cosine"), &normal, &arrival.length), arrival)
    }

    /// What the way to a light makes of it, whatever the normal is.
    pub fn arrival(&self, index: usize, way: &LightWay<Sig>, eye: Option<&Length>) -> Arrival {
        let called = |part: &str| format!("light{index}_{part}");
        let cosine_bits = self.formats.cosine.fraction_bits;
        let length = self.length(&called("way"), &way.squared);
        let dot_view = self.quadratic(&called("way_dot_view"), &way.dot_view);
        let dot_view = match eye {
            None => self.cosine_to(&called("dot_view"), &dot_view, &length, cosine_bits),
            Some(eye) => {
                let of_light = self.cosine(&called("way_view"), &dot_view, &length);
                self.cosine_to(&called("dot_view"), &of_light, eye, cosine_bits)
            }
        };
        let share = way.spot.as_ref().map(|spot| self.share(index, spot, &length));
        Arrival { length, dot_view, share }
    }

    /// Whether a light is a spot, and max(S·L, 0)^p.
    fn share(&self, index: usize, spot: &SpotWay<Sig>, length: &Length) -> [Sig; 2] {
        let called = |part: &str| format!("light{index}_{part}");
        let (b, base_bits) = (self.forward.b, self.formats.base.fraction_bits);
        let axis = self.linear(&called("spot_axis"), &spot.axis);
        let cosine = b.instance(&called("spot_cosine"), || {
            units::positive_cosine(b, &axis, length, base_bits)
        });
        let largest = self.parameters.largest_spot_exponent().into();
        let bits = self.formats.shape.fraction_bits;
        let share = b.instance(&called("spot"), || {
            units::any_power_up_to(b, &cosine, &spot.exponent, largest, bits)
        });
        [self.spots[index].clone(), share]
    }

    /// H·n = (n·L + n·V)/|L + V|, kept within 0 to 1; 0 where one of them has no direction.
    pub fn halfway(
        &self,
        index: usize,
        [n_dot_v, n_dot_l]: [&Sig; 2],
        arrival: &Arrival,
        eye: Option<&Length>,
    ) -> Sig {
        let called = |part: &str| format!("light{index}_{part}");
        let (b, f) = (self.forward.b, &self.formats);
        let to = ReciprocalRoot::from(f.halfway_gain());
        let gain = b.instance(&called("halfway_gain"), || {
            units::halfway_gain(b, &arrival.dot_view, f.cosine.fraction_bits, to)
        });
        let base = b.instance(&called("halfway_cosine"), || {
            units::halfway_cosine(b, n_dot_v, n_dot_l, &gain, f.base.fraction_bits)
        });
        let of_light = arrival.length.has_direction.choose(&base, &b.integer(0));
        eye.map_or(of_light.clone(), |eye| eye.has_direction.choose(&of_light, &b.integer(0)))
    }

    /// 2 x y - d q, as an operand: what is reflected about a vector with the square q.
    pub fn reflected(&self, instance: &str, factors: [&Sig; 2], d: &Sig, q: &Sig) -> Sig {
        let (b, bits) = (self.forward.b, self.formats.operand.fraction_bits);
        b.instance(instance, || units::reflected_numerator(b, factors, d, q, bits))
    }
}

impl Arrival {
    /// What a spot leaves of an amount of light, with as many fraction bits.
    pub fn share_of(&self, amount: Sig) -> Sig {
        let Some([is_spot, share]) = &self.share else { return amount };
        let bits = amount.format().fraction_bits;
        is_spot.choose(&(&amount * share).rounded(bits), &amount)
    }

    /// The same of both.
    pub fn spotted(&self, Intensities { diffuse, specular }: Intensities) -> Intensities {
        Intensities { diffuse: self.share_of(diffuse), specular: self.share_of(specular) }
    }
}

/// Whether the light of each pipeline is a spot.
pub(super) fn spots(b: &Builder, parameters: &CoreParameters, slots: &TimeSlots) -> Vec<Sig> {
    let is_spot = |index| i64::from(parameters.spot_exponent(index).is_some());
    let spots: Vec<Sig> = (0..parameters.lights).map(|index| b.integer(is_spot(index))).collect();
    if slots.count() == 1 { spots } else { vec![slots.multiplexed(&spots)] }
}

/// Gives lights that share a pipeline the inputs of spots if one of them is a spot, 0 where they
/// are none; `way` finds a light's.
pub(super) fn alike<L>(
    b: &Builder,
    slots: &TimeSlots,
    lights: &mut [LightInputs<L, Sig>],
    way: impl Fn(&mut L) -> Option<&mut LightWay<Sig>>,
) {
    let mut ways: Vec<&mut LightWay<Sig>> =
        lights.iter_mut().filter_map(|inputs| way(&mut inputs.light)).collect();
    if slots.count() == 1 || ways.iter().all(|way| way.spot.is_none()) {
        return;
    }
    let zero = || b.integer(0);
    for way in &mut ways {
        way.spot.get_or_insert_with(|| SpotWay {
            axis: Linear { start: zero(), step: zero() },
            exponent: zero(),
        });
    }
}
