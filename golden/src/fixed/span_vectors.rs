//! Vectors along a span, bit for bit: N0 + a (N1 - N0), or N ← N + ΔN [methods B12;
//! `docs/arithmetic.md`].
use std::fmt;

use specula_spec::{Format, Increments};

use super::error::PacketError;
use super::forward::Accumulator;
use super::number::Wide;
use super::observer::{Observer, narrow, narrow_vector};
use super::packet;
use super::span_extent::SpanExtent;
use super::vector::Vector;

/// Those of one core, in its formats.
pub(super) struct SpanVectors {
    pub increments: Increments,
    /// The weight's accumulator.
    pub weight_accumulator: Format,
    /// The weight.
    pub weight: Format,
    /// Components, where increments are added; what they are rounded to, in either case.
    pub components: Accumulator,
}

/// A pixel of a span.
#[derive(Clone, Copy)]
pub(super) struct SpanPixel {
    i: u32,
    /// a; 0 where increments are added.
    weight: Wide,
}

impl SpanVectors {
    /// Whether a vector stays no longer than `longest`, but for rounding; start and change as they
    /// are sent.
    pub fn check(
        &self,
        name: fmt::Arguments<'_>,
        vector: [&Vector; 2],
        longest: i32,
        extent: SpanExtent,
    ) -> Result<(), PacketError> {
        match self.increments {
            Increments::Multiplied => {
                let longest = Wide::from_num(longest);
                packet::check_ends(name, vector.into(), longest, self.components.rounded)
            }
            Increments::Added => extent.vector(name, vector, self.components.exact, longest),
        }
    }

    /// Whether the weight stays between 0 and 1.
    pub fn check_weight(&self, step: Option<Wide>, extent: SpanExtent) -> Result<(), PacketError> {
        step.map_or(Ok(()), |step| extent.weight(step, self.weight_accumulator))
    }

    /// Pixel i, with the step of the weight if there is one.
    pub fn pixel(&self, observer: &mut impl Observer, i: u32, step: Option<Wide>) -> SpanPixel {
        let weight = step.map_or(Wide::ZERO, |step| {
            let accumulated = Wide::from_num(i) * step;
            observer.see(format_args!("weight_accumulator"), accumulated, self.weight_accumulator);
            narrow(observer, format_args!("weight"), accumulated, self.weight)
        });
        SpanPixel { i, weight }
    }

    /// A vector at a pixel.
    pub fn at(
        &self,
        observer: &mut impl Observer,
        name: impl fmt::Display,
        [start, change]: [&Vector; 2],
        SpanPixel { i, weight }: SpanPixel,
    ) -> Vector {
        match self.increments {
            Increments::Multiplied => {
                let lerp: Vector = std::array::from_fn(|c| start[c] + weight * change[c]);
                narrow_vector(observer, name, lerp, self.components.rounded)
            }
            Increments::Added => self.components.vector(observer, name, [start, change], i),
        }
    }
}
