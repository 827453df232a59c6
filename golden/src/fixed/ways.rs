//! Ways X to lights and to the eye at places, bit for bit: cosines are scalars over √(X·X) [Hast,
//! Barrera and Bengtsson, eq. 35; methods C15; `docs/arithmetic/ways.md`].
use std::fmt;

use specula_spec::ways::{EyeCosine, LightCosine, LightWay, WayFormats};
use specula_spec::{CoreParameters, Linear, Quadratic};

use super::error::PacketError;
use super::forward::Accumulator;
use super::highlight::{cosine, root};
use super::number::{Wide, round_to};
use super::observer::{Observer, narrow};
use super::root::reciprocal_square_root;
use super::span_extent::SpanExtent;
use super::spot::Spots;

/// Ways in one core's formats.
pub(super) struct Ways {
    formats: WayFormats,
    spots: Option<Spots>,
}

/// What a way to a light makes of it at one pixel.
#[derive(Clone, Copy)]
pub(super) struct Arrival {
    /// 1/√(X·X); 0 for a light at the very pixel.
    pub root: Wide,
    /// L·V.
    pub dot_view: Wide,
    /// What a spot leaves of the light.
    pub share: Option<Wide>,
}

impl Ways {
    pub fn new(core: &CoreParameters, formats: WayFormats) -> Ways {
        Ways { formats, spots: Spots::new(core, formats.base, formats.shape) }
    }

    /// Whether the way to the eye stays where it can be.
    pub fn check_eye(&self, eye: &EyeCosine<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        self.check(format_args!("eye_normal"), &eye.normal, extent, -1)?;
        self.check(format_args!("eye_squared"), &eye.squared, extent, 0)
    }

    /// The same of light number `index`.
    pub fn check_light(
        &self,
        index: usize,
        light: &LightCosine<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        self.check(format_args!("light{index}_way_normal"), &light.normal, extent, -1)?;
        self.check_way(index, &light.way, extent)
    }

    /// The same of it without the normal.
    pub fn check_way(
        &self,
        index: usize,
        way: &LightWay<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        self.check(format_args!("light{index}_way_squared"), &way.squared, extent, 0)?;
        self.check(format_args!("light{index}_way_dot_view"), &way.dot_view, extent, -1)?;
        way.spot.iter().try_for_each(|spot| {
            self.check_linear(format_args!("light{index}_spot_axis"), &spot.axis, extent)
        })
    }

    /// Whether a quadratic stays within `low` and 1.
    pub fn check(
        &self,
        name: fmt::Arguments<'_>,
        quadratic: &Quadratic<Wide>,
        extent: SpanExtent,
        low: i32,
    ) -> Result<(), PacketError> {
        extent.quadratic(name, quadratic, self.formats.accumulator, (low, 1))
    }

    /// Whether something linear stays within -1 and 1.
    pub fn check_linear(
        &self,
        name: fmt::Arguments<'_>,
        linear: &Linear<Wide>,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        extent.linear(name, linear, self.formats.accumulator, (-1, 1))
    }

    fn accumulator(&self) -> Accumulator {
        Accumulator { exact: self.formats.accumulator, rounded: self.formats.operand }
    }

    /// A quadratic at pixel i.
    pub fn quadratic(
        &self,
        observer: &mut impl Observer,
        name: impl fmt::Display,
        quadratic: &Quadratic<Wide>,
        i: u32,
    ) -> Wide {
        self.accumulator().quadratic(observer, name, quadratic, i)
    }

    /// Something linear at pixel i.
    pub fn linear(
        &self,
        observer: &mut impl Observer,
        name: impl fmt::Display,
        linear: &Linear<Wide>,
        i: u32,
    ) -> Wide {
        self.accumulator().linear(observer, name, linear, i)
    }

    /// 1/√max(X·X, 4^-m), and 0 where X·X ≤ 0.
    pub fn root(
        &self,
        observer: &mut impl Observer,
        name: &str,
        squared: &Quadratic<Wide>,
        i: u32,
    ) -> Wide {
        let q = self.quadratic(observer, format_args!("{name}_squared"), squared, i);
        root(observer, format_args!("{name}_root"), q, self.formats.root)
    }

    /// A scalar over the length of a way, as an operand, kept within -1 to 1.
    pub fn cosine(
        &self,
        observer: &mut impl Observer,
        name: impl fmt::Display,
        scalar: Wide,
        root: Wide,
    ) -> Wide {
        cosine(observer, name, scalar * root, self.formats.operand)
    }

    /// N·V of an eye at a place, and 1/√(E·E).
    pub fn eye(&self, observer: &mut impl Observer, eye: &EyeCosine<Wide>, i: u32) -> (Wide, Wide) {
        let root = self.root(observer, "eye", &eye.squared, i);
        let normal = self.quadratic(observer, "eye_normal", &eye.normal, i);
        (self.cosine(observer, "view", normal, root), root)
    }

    /// N·L, and what else the way to a light makes of it.
    pub fn light(
        &self,
        observer: &mut impl Observer,
        light: &LightCosine<Wide>,
        eye: Option<Wide>,
        i: u32,
    ) -> (Wide, Arrival) {
        let arrival = self.arrival(observer, &light.way, eye, i);
        let normal = self.quadratic(observer, "way_normal", &light.normal, i);
        (self.cosine(observer, "p", normal, arrival.root), arrival)
    }

    /// What the way to a light makes of it; `eye` is 1/√(E·E) of an eye at a place.
    pub fn arrival(
        &self,
        observer: &mut impl Observer,
        way: &LightWay<Wide>,
        eye: Option<Wide>,
        i: u32,
    ) -> Arrival {
        let root = self.root(observer, "way", &way.squared, i);
        let dot_view = self.quadratic(observer, "way_dot_view", &way.dot_view, i);
        let dot_view = match eye {
            None => dot_view * root,
            Some(eye) => self.cosine(observer, "way_view", dot_view, root) * eye,
        };
        let dot_view = cosine(observer, "dot_view", dot_view, self.formats.cosine);
        let share = way.spot.as_ref().zip(self.spots.as_ref()).map(|(spot, spots)| {
            let axis = self.linear(observer, "spot_axis", &spot.axis, i);
            spots.share(observer, axis * root, spot.exponent)
        });
        Arrival { root, dot_view, share }
    }

    /// H·n = (n·L + n·V)/|L + V| with H half-way between L and V, kept within 0 to 1; 0 where one
    /// of them has no direction.
    pub fn halfway(
        &self,
        observer: &mut impl Observer,
        sum: Wide,
        arrival: &Arrival,
        eye: Option<Wide>,
    ) -> Wide {
        let (gain, base) = (self.formats.halfway_gain(), self.formats.base);
        let squared = Wide::from_num(2) + (arrival.dot_view << 1);
        let g = reciprocal_square_root(squared, gain.integer_bits, gain.fraction_bits);
        observer.see(format_args!("halfway_gain"), g, gain);
        let cosine = round_to(sum * g, base.fraction_bits).clamp(Wide::ZERO, Wide::ONE);
        let exists = arrival.root > Wide::ZERO && eye.is_none_or(|eye| eye > Wide::ZERO);
        let cosine = if exists { cosine } else { Wide::ZERO };
        observer.see(format_args!("base"), cosine, base);
        cosine
    }

    /// 2 a b - d q, as an operand: what is reflected about a vector with the square q.
    pub fn reflected(
        &self,
        observer: &mut impl Observer,
        [a, b]: [Wide; 2],
        d: Wide,
        q: Wide,
    ) -> Wide {
        let exact = ((a * b) << 1) - d * q;
        narrow(observer, format_args!("numerator"), exact, self.formats.operand)
    }
}
