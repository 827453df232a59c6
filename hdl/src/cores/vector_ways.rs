//! Ways X to lights and to the eye at places by their components.
use specula_spec::ways::{VectorLight, VectorSpot, VectorWay};
use specula_spec::{CoreParameters, Format, LightInputs};

use super::common::{Intensities, unit_vector};
use super::forward::Forward;
use super::share::Share;
use super::spot;
use super::ways::SHORTEST_WAY;
use crate::units;
use specula_datapath::builder::{Builder, Sig, TimeSlots, Vector};

/// The ways of a core.
pub(super) struct VectorWays<'a> {
    pub forward: Forward<'a>,
    parameters: &'a CoreParameters,
    /// Components of ways and of directions.
    vector: Format,
    /// The cosine between a spot's axis and the way from it.
    base: Format,
    /// The share of a spot.
    shape: Format,
    /// Whether the light of each pipeline is a spot.
    spots: Vec<Sig>,
}

impl<'a> VectorWays<'a> {
    /// Those of a core, with components in the format `vector`, and cosines and shares of spots in
    /// `base` and `shape`.
    pub fn new(
        forward: Forward<'a>,
        parameters: &'a CoreParameters,
        [vector, base, shape]: [Format; 3],
        slots: &TimeSlots,
    ) -> VectorWays<'a> {
        let spots = spot::spots(forward.b, parameters, slots);
        VectorWays { forward, parameters, vector, base, shape, spots }
    }

    /// A way at the pixel, no longer than 1 but for what its components are off by.
    pub fn way(&self, name: &str, way: &VectorWay<Sig>) -> Vector {
        let [start, step] = &way.start_and_step();
        self.forward
            .vector(name, [start, step], 1.0, self.vector)
            .no_shorter_than(self.parameters.shortest_way, SHORTEST_WAY)
    }

    /// (L + V)/2 of the way to a light.
    pub fn half_sum(&self, l: &Vector, view: &Vector) -> Vector {
        let shortest = 0.5 * self.parameters.shortest_halfway;
        units::half_sum(l, view).no_shorter_than(shortest, units::SHORTEST_HALFWAY)
    }

    /// What a spot leaves of diffuse and specular light from the direction `l`, rounded to
    /// `fraction_bits`.
    pub fn spotted(
        &self,
        index: usize,
        light: &VectorLight<Sig>,
        l: &Vector,
        (intensities, fraction_bits): (Intensities, [u32; 2]),
    ) -> Intensities {
        let Some(VectorSpot { axis, exponent }) = &light.spot else { return intensities };
        let called = |part: &str| format!("light{index}_{part}");
        let (b, bits) = (self.forward.b, self.shape.fraction_bits);
        let axis = unit_vector(axis, self.vector);
        let cosine = b.instance(&called("spot_cosine"), || {
            units::spot_cosine(b, l, &axis, self.base.fraction_bits)
        });
        let largest = self.parameters.largest_spot_exponent().into();
        let share = b.instance(&called("spot"), || {
            units::any_power_up_to(b, &cosine, exponent, largest, bits)
        });
        Share { applies: self.spots[index].clone(), share }.of_both(intensities, fraction_bits)
    }
}

/// Gives lights that share a pipeline the same inputs; `way` finds a light's.
pub(super) fn alike<L>(
    b: &Builder,
    slots: &TimeSlots,
    lights: &mut [LightInputs<L, Sig>],
    way: impl Fn(&mut L) -> Option<&mut VectorLight<Sig>>,
) {
    let none = |zero: &Sig| VectorSpot {
        axis: [zero.clone(), zero.clone(), zero.clone()],
        exponent: zero.clone(),
    };
    spot::alike(b, slots, lights, |light| way(light).map(|way| &mut way.spot), none);
}
