//! Whether a vector has a direction, what depends on that, and how short it may be.
use specula_datapath::bound::{Bound, VectorBound};

/// Error of the bit that says whether a vector is not 0: 1 where rounding may decide it.
pub fn has_direction(of: VectorBound) -> f64 {
    if of.surely() > 0.0 { 0.0 } else { 1.0 }
}

/// Bound on the error of a value from 0 to 1 that is 0 where a bit is 0, if rounding may decide that
/// bit: nothing is known then, since a choice counts as one between values that meet.
pub fn gated(bit: Bound) -> Option<f64> {
    (!bit.is_exact()).then_some(1.0)
}

/// √q of the smallest real q: no normal is shorter, at pixels or between them, since what is known of
/// q is so for every t.
pub fn shortest(q: Bound) -> f64 {
    q.real.low.max(0.0).sqrt()
}
