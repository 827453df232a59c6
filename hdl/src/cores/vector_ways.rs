//! Ways X to lights and to the eye at places by their components.
use specula_spec::ways::{VectorLight, VectorSpot, VectorWay};
use specula_spec::{CoreParameters, Format, LightInputs};

use super::common::{Intensities, unit_vector};
use super::forward::Forward;
use super::ways::SHORTEST_WAY;
use crate::error;
use crate::units;
use specula_datapath::builder::{Builder, Sig, TimeSlots, Vector};

/// The ways of a core.
pub(super) struct VectorWays<'a> {
    pub forward: Forward<'a>,
    pub parameters: &'a CoreParameters,
    /// Components of ways and of directions.
    pub vector: Format,
    /// The cosine between a spot's axis and the way from it.
    pub base: Format,
    /// The share of a spot.
    pub shape: Format,
    /// Whether the light of each pipeline is a spot.
    pub spots: Vec<Sig>,
}

impl VectorWays<'_> {
    /// A way at the pixel, no longer than 1 but for what its components are off by.
    pub fn way(&self, name: &str, way: &VectorWay<Sig>) -> Vector {
        let bits = self.vector.fraction_bits;
        let components = [("x", &way.x), ("y", &way.y), ("z", &way.z)].map(|(axis, component)| {
            self.forward.linear(&format!("{name}_{axis}"), component, bits)
        });
        let off = error::linear::bound(self.forward.steps, way.x.start.ulp()) + self.vector.ulp();
        Vector::new(components)
            .no_longer_than(1.0 + 3f64.sqrt() * off)
            .no_shorter_than(self.parameters.shortest_way, SHORTEST_WAY)
    }

    /// What a spot leaves of a light from the direction `l`.
    pub fn spotted(
        &self,
        index: usize,
        light: &VectorLight<Sig>,
        l: &Vector,
        intensities: Intensities,
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
        let is_spot = &self.spots[index];
        let of = |amount: Sig| {
            let bits = amount.format().fraction_bits;
            is_spot.choose(&(&amount * &share).rounded(bits), &amount)
        };
        Intensities { diffuse: of(intensities.diffuse), specular: of(intensities.specular) }
    }
}

/// Gives lights that share a pipeline the inputs of spots if one of them is a spot, 0 where they
/// are none; `way` finds a light's.
pub(super) fn alike<L>(
    b: &Builder,
    slots: &TimeSlots,
    lights: &mut [LightInputs<L, Sig>],
    way: impl Fn(&mut L) -> Option<&mut VectorLight<Sig>>,
) {
    let mut ways: Vec<&mut VectorLight<Sig>> =
        lights.iter_mut().filter_map(|inputs| way(&mut inputs.light)).collect();
    if slots.count() == 1 || ways.iter().all(|way| way.spot.is_none()) {
        return;
    }
    let zero = || b.integer(0);
    for way in &mut ways {
        way.spot
            .get_or_insert_with(|| VectorSpot { axis: [zero(), zero(), zero()], exponent: zero() });
    }
}
