//! Ways X to lights and to the eye at places by their components, bit for bit [Hast, Barrera and
//! Bengtsson, eq. 35; methods C15; `docs/arithmetic/ways.md`].
use std::fmt;

use specula_spec::ways::{VectorLight, VectorSpot, VectorWay};
use specula_spec::{CoreParameters, Format};

use super::error::PacketError;
use super::forward::Accumulator;
use super::method::Intensities;
use super::number::{Wide, round_to};
use super::observer::Observer;
use super::power::Power;
use super::span_extent::SpanExtent;
use super::vector::{Vector, dot};

/// Ways in one core's formats.
pub(super) struct VectorWays {
    accumulator: Accumulator,
    /// The cosine between a spot's axis and the way from it, and the share of it.
    base: Format,
    shape: Format,
    /// Of all spots.
    spot_power: Power,
}

impl VectorWays {
    pub fn new(
        core: &CoreParameters,
        accumulator: Format,
        vector: Format,
        [base, shape]: [Format; 2],
    ) -> VectorWays {
        let exponent_bits = u32::BITS - core.largest_spot_exponent().leading_zeros();
        let spot_power = Power::new(exponent_bits, shape.fraction_bits);
        let accumulator = Accumulator { exact: accumulator, rounded: vector };
        VectorWays { accumulator, base, shape, spot_power }
    }

    /// Whether the way to light number `index` stays where it can be.
    pub fn check_light(
        &self,
        index: usize,
        light: &VectorLight<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        self.check_way(format_args!("light{index}_way"), &light.way, extent)
    }

    /// Whether a way stays where it can be.
    pub fn check_way(
        &self,
        name: fmt::Arguments<'_>,
        way: &VectorWay<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        [&way.x, &way.y, &way.z].into_iter().try_for_each(|component| {
            extent.linear(name, component, self.accumulator.exact, (-1, 1))
        })
    }

    /// A way at pixel i.
    pub fn at(
        &self,
        observer: &mut impl Observer,
        name: &str,
        way: &VectorWay<Wide>,
        i: u32,
    ) -> Vector {
        [("x", &way.x), ("y", &way.y), ("z", &way.z)].map(|(axis, component)| {
            self.accumulator.linear(observer, &format!("{name}_{axis}"), component, i)
        })
    }

    /// What a spot leaves of a light from the direction `l`: max(S·L, 0)^p with S against its axis.
    pub fn spotted(
        &self,
        observer: &mut impl Observer,
        spot: Option<&VectorSpot<Wide>>,
        l: &Vector,
        Intensities { diffuse, specular }: Intensities<Wide>,
        formats: &Intensities<Format>,
    ) -> Intensities<Wide> {
        let Some(spot) = spot else { return Intensities { diffuse, specular } };
        let cosine = -dot(l, &spot.axis);
        let cosine = round_to(cosine, self.base.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        observer.see(format_args!("spot_base"), cosine, self.base);
        let share = self.spot_power.raise(cosine, spot.exponent.to_num());
        observer.see(format_args!("spot"), share, self.shape);
        let of = |amount: Wide, format: Format| round_to(share * amount, format.fraction_bits);
        Intensities {
            diffuse: of(diffuse, formats.diffuse),
            specular: of(specular, formats.specular),
        }
    }
}
