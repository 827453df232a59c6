//! What is known of the real value that a signal stands for.
use crate::design::Range;

/// An interval that holds the real value, in units of the signal's last place.
///
/// The range of a signal says nothing of it: that holds what the host and the core *rounded*, and
/// what they rounded may lie beyond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Real {
    /// Smallest value.
    low: f64,
    /// Largest value.
    high: f64,
}

impl Real {
    /// Nothing is known.
    pub const ANY: Real = Real { low: f64::NEG_INFINITY, high: f64::INFINITY };

    /// What is no further than `error` from a raw value in `range`.
    pub fn near(range: Range, error: f64) -> Real {
        Real { low: range.low as f64 - error, high: range.high as f64 + error }
    }

    /// What both hold.
    pub fn and(self, other: Real) -> Real {
        Real { low: self.low.max(other.low), high: self.high.min(other.high) }
    }

    /// What either holds.
    pub fn or(self, other: Real) -> Real {
        Real { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// The value, or `limit` where it is smaller.
    pub fn clamped_below(self, limit: f64) -> Real {
        Real { low: self.low.max(limit), high: self.high.max(limit) }
    }

    /// The value, or `limit` where it is larger.
    pub fn clamped_above(self, limit: f64) -> Real {
        Real { low: self.low.min(limit), high: self.high.min(limit) }
    }

    /// The value without its sign.
    pub fn absolute(self) -> Real {
        Real { low: self.low.max(-self.high).max(0.0), high: self.high.max(-self.low) }
    }

    /// In units that are 1/`factor` of these.
    pub fn scaled(self, factor: f64) -> Real {
        Real { low: self.low * factor, high: self.high * factor }
    }

    /// How far it can be from a raw value in `range`.
    pub fn furthest_from(self, range: Range) -> f64 {
        (self.high - range.low as f64).max(range.high as f64 - self.low).max(0.0)
    }
}
