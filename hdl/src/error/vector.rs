//! Whether a vector has a direction, and what depends on that.
use specula_datapath::bound::{Bound, ErrorBound, VectorBound};

/// Error of the bit that says whether a vector is not 0: 1 where rounding may decide it.
pub fn has_direction(of: VectorBound) -> f64 {
    if of.surely() > 0.0 { 0.0 } else { 1.0 }
}

/// What is known of a value from 0 to 1 that is 0 where the bit `has_direction` is 0. Where rounding
/// may decide that bit, nothing is known: a choice counts as one between values that meet.
pub fn where_sure(has_direction: Bound, value: Bound) -> ErrorBound {
    if has_direction.is_exact() { value.error_bound() } else { 1.0.into() }
}
