//! How far powers of a cosine are off.
use specula_scene::format::power_of_two;

use crate::builder::Sig;
use crate::design::ErrorForm;

/// What is known of b^n of a base b from 0 to 1 and n from 1 on.
///
/// # Error
/// Let the base be s cos t, off by an angle a and by r beside that.
///
/// - cos^n t has the slope √n ((n-1)/n)^((n-1)/2) at most, where cos² t = (n-1)/n. So the angle moves the power by a times that.
/// - x^n and y^n with |x - y| ≤ r are no further apart than n r m^(n-1) with m = max(x, y), that is r (1 + (n-1) m^n) at most, since
///   n m^(n-1) ≤ 1 + (n-1) m^n (weighted means). m^n exceeds both powers by no more than their bound.
pub(super) struct PowerError {
    /// Bound on the error.
    bound: f64,
    /// Of it, what grows with the power.
    ratio: f64,
    /// Of it, what does not.
    rest: f64,
}

impl PowerError {
    /// Of the exact power of a base as it comes, for exponents up to `n`.
    pub fn of(base: &Sig, n: f64) -> PowerError {
        let (angle, r) = match base.error_form() {
            ErrorForm::OfCosine { angle, rest } => (angle, rest),
            _ => (0.0, base.error_value()),
        };
        let turned = angle * steepest(n);
        PowerError { bound: turned + n * r, ratio: (n - 1.0) * r, rest: turned + r }
    }

    /// And off by `error` besides.
    pub fn and(self, error: f64) -> PowerError {
        PowerError { bound: self.bound + error, rest: self.rest + error, ..self }
    }

    /// And each of j squares, 2^j = n, rounded by `half_unit`: the one that is followed by i more is raised to k = 2^i, and so counts as
    /// r does, 1 + (k-1) m^n times. The k add up to n - 1.
    pub fn and_squared(self, log2_n: u32, half_unit: f64) -> PowerError {
        let (squares, all) = (f64::from(log2_n), power_of_two(log2_n.into()) - 1.0);
        PowerError {
            bound: self.bound + all * half_unit,
            ratio: self.ratio + (all - squares) * half_unit,
            rest: self.rest + squares * half_unit,
        }
    }

    /// States it of the power.
    pub fn state(self, power: Sig) -> Sig {
        let bound = self.bound.min(1.0);
        // The ratio counts for m^n, which exceeds the smaller power by the bound at most.
        let rest = self.rest + self.ratio * bound;
        power.stated_error_value(bound).of_error_form(ErrorForm::Proportional { ratio: self.ratio, rest })
    }
}

/// Largest slope of cos^n.
fn steepest(n: f64) -> f64 {
    n.sqrt() * ((n - 1.0) / n).powf((n - 1.0) / 2.0)
}
