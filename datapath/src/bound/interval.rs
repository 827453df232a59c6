//! Intervals of values.

/// Every value from `low` to `high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
}

impl Interval {
    /// Any value.
    pub const ANY: Interval = Interval { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// From `low` to `high`.
    pub const fn new(low: f64, high: f64) -> Interval {
        Interval { low, high }
    }

    /// `low` and whatever is larger.
    pub const fn at_least(low: f64) -> Interval {
        Interval { low, high: f64::INFINITY }
    }

    /// The largest magnitude.
    pub fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// What is no further than `distance` from it.
    pub fn enlarged_by(self, distance: f64) -> Interval {
        Interval { low: self.low - distance, high: self.high + distance }
    }

    /// What both hold.
    pub fn intersection(self, other: Interval) -> Interval {
        Interval { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// The smallest interval that holds both.
    pub fn hull(self, other: Interval) -> Interval {
        Interval { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// Values of a sum.
    pub fn plus(self, other: Interval) -> Interval {
        Interval { low: self.low + other.low, high: self.high + other.high }
    }

    /// Values of a difference.
    pub fn minus(self, other: Interval) -> Interval {
        Interval { low: self.low - other.high, high: self.high - other.low }
    }

    /// Values of a product; any value where an end is infinite.
    pub fn times(self, other: Interval) -> Interval {
        let corners = [
            self.low * other.low,
            self.low * other.high,
            self.high * other.low,
            self.high * other.high,
        ];
        if corners.iter().any(|corner| corner.is_nan()) {
            return Interval::ANY;
        }
        let end = |f: fn(f64, f64) -> f64| corners.into_iter().reduce(f).unwrap_or(f64::NAN);
        Interval { low: end(f64::min), high: end(f64::max) }
    }

    /// Values of a square.
    pub fn squared(self) -> Interval {
        let (low, high) = (self.absolute().low, self.magnitude());
        Interval { low: low * low, high: high * high }
    }

    /// The value, or `limit` where it is smaller.
    pub fn clamped_below(self, limit: f64) -> Interval {
        Interval { low: self.low.max(limit), high: self.high.max(limit) }
    }

    /// The value, or `limit` where it is larger.
    pub fn clamped_above(self, limit: f64) -> Interval {
        Interval { low: self.low.min(limit), high: self.high.min(limit) }
    }

    /// The value without its sign.
    pub fn absolute(self) -> Interval {
        Interval { low: self.low.max(-self.high).max(0.0), high: self.high.max(-self.low) }
    }

    /// The value times `factor`, which is positive.
    pub fn scaled(self, factor: f64) -> Interval {
        Interval { low: self.low * factor, high: self.high * factor }
    }

    /// How far a value of it can be from one of `other`.
    pub fn furthest_from(self, other: Interval) -> f64 {
        (self.high - other.low).max(other.high - self.low).max(0.0)
    }
}
