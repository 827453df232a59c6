//! The places where values are rounded, and which formats they may have.
use specula_datapath::Format;

use crate::error::SpecError;

/// The most fraction bits a user may ask for at any narrowing point, accumulators apart.
pub(crate) const MOST_FRACTION_BITS: u32 = 24;
/// The most integer bits of a reciprocal root: 2^12 is that of the last place of an operand with
/// the most fraction bits.
pub(crate) const LARGEST_ROOT_REACH: u32 = MOST_FRACTION_BITS / 2;
/// The fewest fraction bits at any narrowing point.
pub(crate) const FEWEST_FRACTION_BITS: u32 = 4;
/// The most fraction bits of an accumulator: with sign and three integer bits, 60 bits wide.
pub(crate) const MOST_ACCUMULATOR_FRACTION_BITS: u32 = 56;

/// `U1`, of whatever fraction bits: 0 to 1 and a little more.
pub(crate) const UNIT: Format = Format::unsigned(1, 0);
/// `S1`, of whatever fraction bits.
pub(crate) const SIGNED_UNIT: Format = Format::signed(1, 0);

/// What the weight is that vectors are interpolated with, for [`NarrowingPoint::weight`].
pub(crate) const INTERPOLATION_WEIGHT: [&str; 2] =
    ["step of the interpolation weight, rounded by the host", "interpolation weight a"];

/// A place where values are rounded, in the core or by the host.
#[derive(Clone, Debug, PartialEq)]
pub struct NarrowingPoint {
    /// Its name in the spec.
    pub name: &'static str,
    /// What it is rounded to.
    pub format: Format,
    /// What is rounded, in words and in the formulas of docs/arithmetic.md.
    pub value: &'static str,
    /// The fewest fraction bits the format may have, given the others.
    pub fewest_fraction_bits: u32,
    /// The most fraction bits the format may have, given the others.
    pub most_fraction_bits: u32,
    /// The fraction bits that a search for formats begins with, where the format has more than ever
    /// matter.
    pub search_begins_with: Option<u32>,
    /// Signedness and integer bits that it must have.
    shape: Format,
    /// Why it needs more fraction bits than others.
    because: &'static str,
}

impl NarrowingPoint {
    /// A value that the core rounds; `shape` has the sign and the integer bits it needs.
    pub(crate) fn rounded(
        name: &'static str,
        format: Format,
        shape: Format,
        value: &'static str,
    ) -> NarrowingPoint {
        NarrowingPoint {
            name,
            format,
            value,
            fewest_fraction_bits: FEWEST_FRACTION_BITS,
            most_fraction_bits: MOST_FRACTION_BITS,
            search_begins_with: None,
            shape,
            because: "",
        }
    }

    /// An accumulator that the host rounds start value and steps into. `span_bits` number the
    /// pixels of the longest span, and errors grow with it to the power of `order`: S steps, each
    /// off by half a unit of the last place, add up to S/2 units, second differences to S²/4
    /// (numerics N3b), which must stay well below 1.
    pub(crate) fn accumulated(
        name: &'static str,
        format: Format,
        shape: Format,
        (order, span_bits): (u32, u32),
        value: &'static str,
    ) -> NarrowingPoint {
        NarrowingPoint {
            most_fraction_bits: MOST_ACCUMULATOR_FRACTION_BITS,
            fewest_fraction_bits: (order * span_bits + 3).max(FEWEST_FRACTION_BITS),
            because: ", since the longest span adds up its error",
            ..NarrowingPoint::rounded(name, format, shape, value)
        }
    }

    /// A weight that grows from 0 to 1 along a span, and before it its accumulator, whose step 1/S the
    /// host rounds; `values` say what both are.
    pub(crate) fn weight(
        [accumulator, weight]: [Format; 2],
        span_bits: u32,
        values: [&'static str; 2],
    ) -> [NarrowingPoint; 2] {
        let [step, value] = values;
        let linear = (1, span_bits);
        [
            NarrowingPoint::accumulated("weight_accumulator", accumulator, UNIT, linear, step),
            NarrowingPoint::rounded("weight", weight, UNIT, value).no_finer_than(accumulator),
        ]
    }

    /// One that has no more fraction bits than it was `from`.
    pub(crate) fn no_finer_than(mut self, from: Format) -> NarrowingPoint {
        self.most_fraction_bits = self.most_fraction_bits.min(from.fraction_bits);
        self
    }

    /// One with more fraction bits at least, so that what is made of it can be told from 0.
    pub(crate) fn with_at_least(mut self, fraction_bits: u32) -> NarrowingPoint {
        self.fewest_fraction_bits = self.fewest_fraction_bits.max(fraction_bits);
        self
    }

    /// One with fewer fraction bits at most, so that what is made of it fits 63 bits.
    pub(crate) fn with_at_most(mut self, fraction_bits: u32) -> NarrowingPoint {
        self.most_fraction_bits = self.most_fraction_bits.min(fraction_bits);
        self
    }

    /// One that may do with fewer fraction bits than others.
    pub(crate) fn down_to(mut self, fraction_bits: u32) -> NarrowingPoint {
        self.fewest_fraction_bits = fraction_bits;
        self
    }

    /// One with more fraction bits at most, since it enters no product.
    pub(crate) fn up_to(mut self, fraction_bits: u32) -> NarrowingPoint {
        self.most_fraction_bits = fraction_bits;
        self
    }

    /// One for which a search begins with fewer fraction bits than it has.
    pub(crate) fn searched_from(mut self, fraction_bits: u32) -> NarrowingPoint {
        self.search_begins_with = Some(fraction_bits.min(self.format.fraction_bits));
        self
    }

    /// Whether its format is one it may have.
    ///
    /// # Errors
    /// [`SpecError::WrongFormat`] if not.
    pub(crate) fn check(&self) -> Result<(), SpecError> {
        let (given, shape) = (self.format, self.shape);
        let fits = given.signed == shape.signed
            && given.integer_bits == shape.integer_bits
            && (self.fewest_fraction_bits..=self.most_fraction_bits).contains(&given.fraction_bits);
        if fits {
            return Ok(());
        }
        let fraction_bits = 14.clamp(
            self.fewest_fraction_bits,
            self.most_fraction_bits.max(self.fewest_fraction_bits),
        );
        Err(SpecError::WrongFormat {
            name: self.name,
            given,
            wanted: format!("{}{}", Format { fraction_bits, ..shape }, self.because),
            fewest_fraction_bits: self.fewest_fraction_bits,
            most_fraction_bits: self.most_fraction_bits,
        })
    }
}
