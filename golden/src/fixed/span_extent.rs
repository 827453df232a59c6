//! Whether what grows along a span stays where it can be: beyond that it would wrap around in
//! hardware [`docs/arithmetic.md`, Packets].
use std::fmt;

use specula_spec::attenuation::OVERSHOOT;
use specula_spec::{Format, Linear, Quadratic};

use super::error::PacketError;
use super::number::Wide;
use super::packet;
use super::vector::{AXES, Vector};

/// What f64 may add to a value that the host rounds: 2^-48.
const HOST_ERROR: Wide = Wide::from_bits(1 << (Wide::FRAC_NBITS - 48));

/// A span that goes in, and the longest that may.
#[derive(Clone, Copy)]
pub(super) struct SpanExtent {
    /// Its pixels.
    pub length: u32,
    /// Pixels of the longest span.
    pub longest: u32,
}

/// Between what a value stays.
#[derive(Clone, Copy)]
struct Limits {
    low: Wide,
    high: Wide,
}

impl SpanExtent {
    /// start + step i within `limits`, where both were rounded to nearest into `format`: half a
    /// unit of the last place for each of S + 1.
    pub fn linear(
        self,
        name: fmt::Arguments<'_>,
        linear: &Linear<Wide>,
        format: Format,
        limits: (i32, i32),
    ) -> Result<(), PacketError> {
        let slack = half_units(u64::from(self.longest), format) + HOST_ERROR;
        self.check(name, Limits::around(limits, slack), self.ends(), |i| linear_at(linear, i))
    }

    /// A vector start + step i no longer than `longest`, its components as in
    /// [`SpanExtent::linear`], and so off by √3/2 units for each of S + 1 as a whole.
    pub fn vector(
        self,
        name: fmt::Arguments<'_>,
        [start, step]: [&Vector; 2],
        format: Format,
        longest: i32,
    ) -> Result<(), PacketError> {
        let components: [_; 3] = std::array::from_fn(|c| Linear { start: start[c], step: step[c] });
        for (axis, component) in AXES.iter().zip(&components) {
            let limits = (-longest, longest);
            self.linear(format_args!("{name}_{axis}"), component, format, limits)?;
        }
        let off = half_units(2 * u64::from(self.longest), format) + 2 * HOST_ERROR;
        ["first", "last"].into_iter().zip(self.ends()).try_for_each(|(which, i)| {
            let vector = std::array::from_fn(|c| linear_at(&components[c], i));
            let longest = Wide::from_num(longest) + off;
            packet::check_no_longer(format_args!("{name} at the {which} pixel"), &vector, longest)
        })
    }

    /// start + first i + second i(i - 1)/2 within `limits`, all three rounded to nearest into
    /// `format`: half a unit for each of 1 + S + S(S - 1)/2 (numerics N3b).
    pub fn quadratic(
        self,
        name: fmt::Arguments<'_>,
        quadratic: &Quadratic<Wide>,
        format: Format,
        limits: (i32, i32),
    ) -> Result<(), PacketError> {
        let limits = Limits::around(limits, self.slack_of_quadratics(format));
        self.quadratic_within(name, quadratic, limits)
    }

    /// The same of a quadratic through values from 0 to 1 at both ends and half-way, which goes an
    /// eighth beyond them.
    pub fn share(
        self,
        name: fmt::Arguments<'_>,
        quadratic: &Quadratic<Wide>,
        format: Format,
    ) -> Result<(), PacketError> {
        let beyond = Wide::from_num(OVERSHOOT) + self.slack_of_quadratics(format);
        self.quadratic_within(name, quadratic, Limits::around((0, 1), beyond))
    }

    fn slack_of_quadratics(self, format: Format) -> Wide {
        let steps = u64::from(self.longest - 1);
        half_units(1 + steps + steps * steps.saturating_sub(1) / 2, format) + HOST_ERROR
    }

    fn quadratic_within(
        self,
        name: fmt::Arguments<'_>,
        quadratic: &Quadratic<Wide>,
        limits: Limits,
    ) -> Result<(), PacketError> {
        let pixels = self.ends().into_iter().chain(self.turning_points(quadratic));
        self.check(name, limits, pixels, |i| quadratic_at(quadratic, i))
    }

    /// The weight i/S, from 0 to 1 and a unit of the last place for each step: 1/S was rounded into
    /// `format`.
    pub fn weight(self, step: Wide, format: Format) -> Result<(), PacketError> {
        let high = Wide::ONE + half_units(2 * u64::from(self.longest - 1), format);
        let linear = Linear { start: Wide::ZERO, step };
        self.check(format_args!("weight"), Limits { low: Wide::ZERO, high }, self.ends(), |i| {
            linear_at(&linear, i)
        })
    }

    /// start + step i from 0 to `high`, where both were rounded up into `format`: a unit for each
    /// of S + 1.
    pub fn rounded_up(
        self,
        name: fmt::Arguments<'_>,
        linear: &Linear<Wide>,
        format: Format,
        high: Wide,
    ) -> Result<(), PacketError> {
        let high = high + half_units(2 * u64::from(self.longest), format) + HOST_ERROR;
        self.check(name, Limits { low: Wide::ZERO, high }, self.ends(), |i| linear_at(linear, i))
    }

    fn ends(self) -> [u32; 2] {
        [0, self.length - 1]
    }

    /// The pixels beside the vertex of a quadratic, i = 1/2 - first/second, if it is on the span.
    fn turning_points(self, quadratic: &Quadratic<Wide>) -> impl Iterator<Item = u32> {
        let vertex = quadratic.first_difference.checked_div(-quadratic.second_difference);
        let before = vertex.map(|vertex| (vertex + Wide::ONE / 2).floor());
        let on_span = move |i: &Wide| *i >= 0 && *i < self.length;
        before.into_iter().flat_map(|i| [i, i + Wide::ONE]).filter(on_span).map(|i| i.to_num())
    }

    fn check(
        self,
        name: fmt::Arguments<'_>,
        Limits { low, high }: Limits,
        pixels: impl IntoIterator<Item = u32>,
        value: impl Fn(u32) -> Wide,
    ) -> Result<(), PacketError> {
        let outside = |&(_, value): &(u32, Wide)| value < low || value > high;
        match pixels.into_iter().map(|i| (i, value(i))).find(outside) {
            None => Ok(()),
            Some((pixel, value)) => {
                let [value, low, high] = [value, low, high].map(|x| x.to_num());
                Err(PacketError::Outgrown { name: name.to_string(), pixel, value, low, high })
            }
        }
    }
}

impl Limits {
    fn around((low, high): (i32, i32), slack: Wide) -> Limits {
        Limits { low: Wide::from_num(low) - slack, high: Wide::from_num(high) + slack }
    }
}

fn half_units(count: u64, format: Format) -> Wide {
    Wide::from_num(count) >> (format.fraction_bits + 1)
}

fn linear_at(linear: &Linear<Wide>, i: u32) -> Wide {
    linear.start + linear.step * Wide::from_num(i)
}

/// The value of a quadratic at pixel i.
pub(super) fn quadratic_at(quadratic: &Quadratic<Wide>, i: u32) -> Wide {
    let pairs = Wide::from_num(u64::from(i) * u64::from(i).saturating_sub(1) / 2);
    quadratic.start
        + quadratic.first_difference * Wide::from_num(i)
        + quadratic.second_difference * pairs
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMAT: Format = Format::signed(3, 40);

    #[test]
    fn a_quadratic_is_looked_at_where_it_turns() {
        let extent = SpanExtent { length: 9, longest: 16 };
        for (start, first, second) in
            (-4..=4).flat_map(|s| (-8..=8).flat_map(move |f| (-8..=8).map(move |d| (s, f, d))))
        {
            // Quarters, so that no value is near a limit but on the other side of it.
            let [start, first_difference, second_difference] =
                [start, first, second].map(|q| Wide::from_num(q) / 4);
            let quadratic = Quadratic { start, first_difference, second_difference };
            let beyond = (0..9).any(|i| quadratic_at(&quadratic, i).abs() > 1);
            let checked = extent.quadratic(format_args!("x"), &quadratic, FORMAT, (-1, 1));
            assert_eq!(
                checked.is_err(),
                beyond,
                "{start} {first_difference} {second_difference}: {checked:?}"
            );
        }
    }

    #[test]
    fn roundings_of_the_host_are_no_fault() {
        for longest in [1, 2, 3, 640, 8192] {
            let extent = SpanExtent { length: longest, longest };
            let step = FORMAT.quantise(f64::from(longest.max(2) - 1).recip());
            assert_eq!(extent.weight(Wide::from_num(step) >> FORMAT.fraction_bits, FORMAT), Ok(()));
        }
        let extent = SpanExtent { length: 3, longest: 3 };
        let error = extent.weight(Wide::from_num(0.6), FORMAT);
        assert!(matches!(error, Err(PacketError::Outgrown { pixel: 2, .. })), "{error:?}");
    }
}
