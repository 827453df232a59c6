//! Ways X to lights and to the eye at places by their components, bit for bit [Hast, Barrera and
//! Bengtsson, eq. 35; methods C15; `docs/arithmetic/ways.md`].
use std::fmt;

use specula_spec::ways::{VectorLight, VectorSpot, VectorWay};
use specula_spec::{CoreParameters, Format};

use super::error::PacketError;
use super::forward::Accumulator;
use super::number::Wide;
use super::observer::Observer;
use super::span_extent::SpanExtent;
use super::spot::Spots;
use super::vector::{Vector, dot};

/// Ways in one core's formats.
pub(super) struct VectorWays {
    accumulator: Accumulator,
    spots: Option<Spots>,
}

impl VectorWays {
    pub fn new(
        core: &CoreParameters,
        accumulator: Format,
        vector: Format,
        [base, shape]: [Format; 2],
    ) -> VectorWays {
        let accumulator = Accumulator { exact: accumulator, rounded: vector };
        VectorWays { accumulator, spots: Spots::new(core, base, shape) }
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
        let [start, step] = &way.start_and_step();
        extent.vector(name, [start, step], self.accumulator.exact, 1)
    }

    /// A way at pixel i.
    pub fn at(
        &self,
        observer: &mut impl Observer,
        name: &str,
        way: &VectorWay<Wide>,
        i: u32,
    ) -> Vector {
        let [start, step] = &way.start_and_step();
        self.accumulator.vector(observer, name, [start, step], i)
    }

    /// The share of a spot in the direction `l`: max(S·L, 0)^p with S against its axis.
    pub fn share(
        &self,
        observer: &mut impl Observer,
        spot: Option<&VectorSpot<Wide>>,
        l: &Vector,
    ) -> Option<Wide> {
        let (spot, spots) = spot.zip(self.spots.as_ref())?;
        Some(spots.share(observer, -dot(l, &spot.axis), spot.exponent))
    }
}
