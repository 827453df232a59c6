//! Cosines of which it is known how far their angle is off.

/// The real value is s cos t, for a length 0 ≤ s ≤ 1 and an angle t; the fixed one is s cos t' + r:
///
/// ```text
/// |t' - t| ≤ angle
/// |r|      ≤ rest
/// ```
///
/// as [`ErrorForm::OfCosine`](specula_datapath::design::ErrorForm::OfCosine) has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angular {
    /// By how much the angle is off at most, in radians.
    pub angle: f64,
    /// By how much the cosine is off beside that.
    pub rest: f64,
}

impl Angular {
    /// Nothing is known.
    pub const UNKNOWN: Angular = Angular { angle: f64::INFINITY, rest: f64::INFINITY };

    /// Itself, if anything is known.
    pub fn known(self) -> Option<Angular> {
        (self.angle + self.rest).is_finite().then_some(self)
    }
}
