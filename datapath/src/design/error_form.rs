//! What is known of an error beside its bound.

/// How the error of a signal from 0 to 1 depends on its value, where a unit knows more than a
/// bound.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ErrorForm {
    /// Nothing beside the bound.
    #[default]
    Bounded,
    /// The real value is s cos t, kept within 0 to 1, for a length 0 ≤ s ≤ 1 and an angle t; the
    /// fixed one is s cos t' + r, kept likewise, with |t - t'| ≤ `angle`, in radians, and |r| ≤
    /// `rest`. Turns show by the root of the exponent in a power, and r by the exponent itself.
    OfCosine {
        /// By how much the angle is off at most.
        angle: f64,
        /// By how much the cosine is off beside that.
        rest: f64,
    },
    /// Each of these holds. Of several such values that add up to no more than full scale, the
    /// ratios count once.
    Proportional([Share; SHARES]),
    /// Of all signals of this form in one sum, either none is off by more than `together`, or all
    /// but one are exact.
    OneOfSeveral {
        /// Bound on the errors of all, where more than one is off.
        together: f64,
    },
}

/// How many shares are kept: what is small at small values is large at large ones, and which counts
/// is seen where values are added.
pub const SHARES: usize = 8;

/// |fixed - real| ≤ `ratio` · min(fixed, real) + `rest`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// What grows with the value; not negative.
    pub ratio: f64,
    /// What does not.
    pub rest: f64,
}
