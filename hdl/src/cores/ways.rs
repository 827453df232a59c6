//! Ways X to lights and to the eye at places: cosines are scalars along the span over √(X·X).
use specula_spec::ways::{EyeCosine, LightCosine, LightWay, SpotWay, WayFormats};
use specula_spec::{CoreParameters, LightInputs, Linear, Quadratic};

use super::common::Intensities;
use super::forward::Forward;
use super::share::Share;
use super::spot;
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
    /// What a spot leaves of the light.
    share: Option<Share>,
}

impl<'a> Ways<'a> {
    pub fn new(
        forward: Forward<'a>,
        parameters: &'a CoreParameters,
        formats: WayFormats,
        slots: &TimeSlots,
    ) -> Ways<'a> {
        Ways { forward, parameters, formats, spots: spot::spots(forward.b, parameters, slots) }
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

    /// N·V where it is asked for, and what divides by the way to an eye at a place.
    pub fn view(
        &self,
        view: Option<&Linear<Sig>>,
        eye: Option<&EyeCosine<Sig>>,
    ) -> (Option<Sig>, Option<Length>) {
        match eye.map(|eye| self.eye(eye)) {
            Some((view, length)) => (Some(view), Some(length)),
            None => (view.map(|view| self.linear("view", view)), None),
        }
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

    /// The share of a spot, max(S·L, 0)^p.
    fn share(&self, index: usize, spot: &SpotWay<Sig>, length: &Length) -> Share {
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
        Share { applies: self.spots[index].clone(), share }
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
            let shortest = self.parameters.shortest_halfway;
            units::halfway_gain(b, &arrival.dot_view, shortest, f.cosine.fraction_bits, to)
        });
        let base = b.instance(&called("halfway_cosine"), || {
            units::halfway_cosine(b, [n_dot_v, n_dot_l], &gain, f.base.fraction_bits)
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
    /// What a spot leaves of an amount of light, rounded to `fraction_bits`.
    pub fn share_of(&self, amount: Sig, fraction_bits: u32) -> Sig {
        self.share.as_ref().map_or(amount.clone(), |share| share.of(&amount, fraction_bits))
    }

    /// What a spot leaves of diffuse and specular light, rounded to `fraction_bits`.
    pub fn spotted(&self, intensities: Intensities, fraction_bits: [u32; 2]) -> Intensities {
        match &self.share {
            Some(share) => share.of_both(intensities, fraction_bits),
            None => intensities,
        }
    }
}

/// Gives lights that share a pipeline the same inputs; `way` finds a light's.
pub(super) fn alike<L>(
    b: &Builder,
    slots: &TimeSlots,
    lights: &mut [LightInputs<L, Sig>],
    way: impl Fn(&mut L) -> Option<&mut LightWay<Sig>>,
) {
    let none = |zero: &Sig| SpotWay {
        axis: Linear { start: zero.clone(), step: zero.clone() },
        exponent: zero.clone(),
    };
    spot::alike(b, slots, lights, |light| way(light).map(|way| &mut way.spot), none);
}
