//! Quadratics by forward differences.
use crate::error;
use specula_datapath::builder::{Builder, Sig};

/// Start value and differences of a quadratic in the pixel number.
pub struct Differences<'a> {
    /// Value at the first pixel.
    pub start: &'a Sig,
    /// Second pixel's value less the first's.
    pub first_difference: &'a Sig,
    /// Second difference.
    pub second_difference: &'a Sig,
}

/// x(i+1) = x(i) + d(i), d(i+1) = d(i) + d2: a value in `limits`, by two additions a pixel. [Hast
/// et al., eq. 17 to 26; methods C3]
///
/// The difference at the last pixel looks one pixel beyond the span; with the value within [-1, 1]
/// at three neighbours it is at most 2 + 4. The value is outside its limits by no more than it is
/// off.
///
/// # Error
/// [`error::quadratic::bound`].
pub fn quadratic(b: &Builder, first: &Sig, of: Differences, limits: (f64, f64), steps: u32) -> Sig {
    let inputs = (
        ("start", first),
        ("value_start", of.start),
        ("first_difference", of.first_difference),
        ("second_difference", of.second_difference),
    );
    b.unit(
        "quadratic",
        "x(i+1) = x(i) + d(i), d(i+1) = d(i) + d2 [Hast et al., eq. 17-26]",
        inputs,
        |_, (first, x0, d0, d2)| {
            let error = error::quadratic::bound(steps, x0.ulp());
            let slack = error + x0.ulp();
            let difference = Sig::accumulated(&first, &d0, &d2, (-6.5, 6.5), steps, "|d| <= 6");
            let limits = (limits.0 - slack, limits.1 + slack);
            let value =
                Sig::accumulated(&first, &x0, &difference, limits, steps, "x within its limits");
            value.override_error("error::quadratic::bound", error).named("value")
        },
    )
}
