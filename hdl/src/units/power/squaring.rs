//! Powers by squaring.
use specula_spec::format::power_of_two;

use crate::error::power::PowerError;
use specula_datapath::builder::{Builder, Sig};

/// base^(2^j) for j = `log2_exponent`, 0 or more: each stage squares where j asks for it, else
/// passes on. [Hast et al.; methods C3]
///
/// A square doubles the error of what it squares, so this is the cheaper power
/// (`power = "squaring"`), and off by up to (n - 1)/2 units of the last place near 1;
/// [`any_power`](super::any_power) is faithful.
///
/// # Error
/// [`error::power`](crate::error::power).
pub fn power(b: &Builder, base: &Sig, log2_exponent: &Sig, fraction_bits: u32) -> Sig {
    b.unit(
        "power",
        "f = b^n, n = 2^j, by squaring",
        (("base", base), ("j", log2_exponent)),
        |b, (base, j)| {
            let log2_n = j.range().high.unsigned_abs() as u32;
            let error = PowerError::of(base.bound(), power_of_two(log2_n.into()))
                .and_squared(log2_n, 0.5 * power_of_two(-i64::from(fraction_bits)));
            let mut f = base;
            for done in 0..log2_n {
                let squared = square(b, &f, fraction_bits);
                f = b.integer(i64::from(done)).less_than(&j).choose(&squared, &f);
            }
            f.override_error("error::power::PowerError::bound", error.bound()).named("f")
        },
    )
}

/// The square of a number from 0 to 1, rounded.
pub fn square(b: &Builder, base: &Sig, fraction_bits: u32) -> Sig {
    b.unit("square", "b^2", (("base", base),), |_, (base,)| {
        base.squared().rounded(fraction_bits).named("squared")
    })
}
