//! Intervals of raw values, from which widths are derived.
use crate::format::WIDEST_SIGNAL;

/// Every raw value that a signal can take lies in `low..=high`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Range {
    /// Smallest raw value.
    pub low: i64,
    /// Largest raw value.
    pub high: i64,
}

/// An interval with room for the exact result of any operator on two [`Range`]s.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WideRange {
    low: i128,
    high: i128,
}

impl Range {
    /// The interval from `low` to `high`.
    pub const fn new(low: i64, high: i64) -> Range {
        Range { low, high }
    }

    /// The interval of one value.
    pub const fn single(value: i64) -> Range {
        Range { low: value, high: value }
    }

    /// Every value of a signal `width` bits wide.
    pub const fn whole(width: u32, signed: bool) -> Range {
        if signed {
            Range { low: i64::MIN >> (64 - width), high: i64::MAX >> (64 - width) }
        } else {
            Range { low: 0, high: i64::MAX >> (63 - width) }
        }
    }

    /// The only value, if there is just one.
    pub fn only(self) -> Option<i64> {
        (self.low == self.high).then_some(self.low)
    }

    /// Whether a sign bit is needed.
    pub const fn signed(self) -> bool {
        self.low < 0
    }

    /// Bits that hold every value of the interval, sign included; at least 1.
    pub fn width(self) -> u32 {
        self.wide().width()
    }

    /// Bits that hold every value of the interval and a sign, whether or not it needs one.
    pub fn signed_width(self) -> u32 {
        self.width() + u32::from(!self.signed())
    }

    /// Whether `value` lies inside.
    pub const fn contains(self, value: i64) -> bool {
        self.low <= value && value <= self.high
    }

    /// Largest magnitude.
    pub fn magnitude(self) -> f64 {
        (self.low as f64).abs().max((self.high as f64).abs())
    }

    /// Difference between largest and smallest value.
    pub fn extent(self) -> f64 {
        self.high as f64 - self.low as f64
    }

    /// Values of a sum.
    pub fn plus(self, other: Range) -> WideRange {
        let (a, b) = (self.wide(), other.wide());
        WideRange { low: a.low + b.low, high: a.high + b.high }
    }

    /// Values of a difference.
    pub fn minus(self, other: Range) -> WideRange {
        let (a, b) = (self.wide(), other.wide());
        WideRange { low: a.low - b.high, high: a.high - b.low }
    }

    /// Values of a product.
    pub fn times(self, other: Range) -> WideRange {
        let (a, b) = (self.wide(), other.wide());
        let corners = [a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high];
        let start = WideRange { low: corners[0], high: corners[0] };
        corners.iter().fold(start, |r, &c| WideRange { low: r.low.min(c), high: r.high.max(c) })
    }

    /// Values of a square, which is never negative.
    pub fn squared(self) -> WideRange {
        let product = self.times(self);
        let smallest = if self.contains(0) {
            0
        } else {
            self.low.unsigned_abs().min(self.high.unsigned_abs())
        };
        WideRange { low: i128::from(smallest) * i128::from(smallest), high: product.high }
    }

    /// Values after multiplication by 2^`bits`.
    pub fn shifted_left(self, bits: u32) -> WideRange {
        let wide = self.wide();
        WideRange { low: wide.low << bits, high: wide.high << bits }
    }

    /// Values after division by 2^`bits`, rounded down.
    pub fn shifted_right(self, bits: u32) -> Range {
        let bits = bits.min(63);
        Range { low: self.low >> bits, high: self.high >> bits }
    }

    /// The smallest interval that holds both.
    pub fn hull(self, other: Range) -> Range {
        Range { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The part inside `other`; its nearest end where they do not meet.
    pub fn clamped_to(self, other: Range) -> Range {
        Range {
            low: self.low.clamp(other.low, other.high),
            high: self.high.clamp(other.low, other.high),
        }
    }

    fn wide(self) -> WideRange {
        self.into()
    }
}

impl From<Range> for WideRange {
    fn from(range: Range) -> WideRange {
        WideRange { low: range.low.into(), high: range.high.into() }
    }
}

impl WideRange {
    /// Bits that hold every value of the interval, sign included; at least 1.
    pub fn width(self) -> u32 {
        let magnitude_bits = |v: i128| 128 - (if v < 0 { !v } else { v }).leading_zeros();
        let bits = magnitude_bits(self.low).max(magnitude_bits(self.high));
        (bits + u32::from(self.low < 0)).max(1)
    }

    /// The interval as a [`Range`].
    ///
    /// # Errors
    /// The width needed, if it is more than 63 bits.
    pub fn narrow(self) -> Result<Range, u32> {
        let width = self.width();
        if width > WIDEST_SIGNAL {
            return Err(width);
        }
        // At most 63 bits wide, so both ends fit 64.
        Ok(Range { low: self.low as i64, high: self.high as i64 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn small() -> impl Iterator<Item = Range> {
        (-5..=5).flat_map(|low| (low..=5).map(move |high| Range::new(low, high)))
    }

    #[test]
    fn operators_are_exact_over_all_small_intervals() {
        for a in small() {
            for b in small() {
                let all = |f: fn(i64, i64) -> i64| {
                    let values =
                        (a.low..=a.high).flat_map(|x| (b.low..=b.high).map(move |y| f(x, y)));
                    (values.clone().min(), values.max())
                };
                let ends = |r: WideRange| r.narrow().map(|r| (Some(r.low), Some(r.high)));
                assert_eq!(ends(a.plus(b)), Ok(all(|x, y| x + y)));
                assert_eq!(ends(a.minus(b)), Ok(all(|x, y| x - y)));
                assert_eq!(ends(a.times(b)), Ok(all(|x, y| x * y)));
            }
            let squares = (a.low..=a.high).map(|x| x * x);
            assert_eq!(
                a.squared().narrow().map(|r| (Some(r.low), Some(r.high))),
                Ok((squares.clone().min(), squares.max()))
            );
        }
    }

    #[test]
    fn widths_are_what_the_interval_needs() {
        let width = |low, high| Range::new(low, high).width();
        assert_eq!([width(0, 0), width(0, 1), width(0, 255), width(0, 256)], [1, 1, 8, 9]);
        assert_eq!([width(-1, 0), width(-2, 1), width(-128, 127), width(-129, 0)], [1, 2, 8, 9]);
        for bits in 1..=63 {
            assert_eq!(Range::whole(bits, false).width(), bits);
            assert_eq!(Range::whole(bits, true).width(), bits);
        }
    }

    #[test]
    fn more_than_63_bits_are_refused() {
        let wide = Range::new(0, i64::MAX >> 1);
        assert_eq!(wide.times(wide).narrow(), Err(124));
    }
}
