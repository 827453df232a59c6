//! Powers of highlights' bases: by squaring, or by tables of log₂ and 2^-x.
//!
//! Widths and error of the tables' way are derived in docs/arithmetic/units.md.
pub(super) mod exp2;
mod log2;
mod squaring;
pub(super) mod tables;

use specula_spec::format::power_of_two;
use specula_spec::power::{Power, PowerUnit};

use crate::error::power::PowerError;
use specula_datapath::builder::{Builder, Sig};

pub use squaring::power;
pub(super) use squaring::square;

/// base^n, as the spec has it taken; `exponent` is what the unit's port is given.
pub fn raised(b: &Builder, base: &Sig, exponent: &Sig, unit: PowerUnit) -> Sig {
    let fraction_bits = unit.format().fraction_bits;
    match unit.power {
        Power::Squaring => power(b, base, exponent, fraction_bits),
        Power::Tables => any_power(b, base, exponent, fraction_bits),
    }
}

/// b^n for a base from 0 to 1 and whole n ≥ 1, to `fraction_bits`: faithful, off by less than one
/// unit of the last place.
///
/// # Error
/// [`error::power`](crate::error::power), and less than 1 unit in any case.
pub fn any_power(b: &Builder, base: &Sig, n: &Sig, fraction_bits: u32) -> Sig {
    any_power_up_to(b, base, n, n.range().high, fraction_bits)
}

/// As [`any_power`], with tables for exponents up to `largest`, whatever n is known to be.
pub fn any_power_up_to(b: &Builder, base: &Sig, n: &Sig, largest: i64, fraction_bits: u32) -> Sig {
    b.unit("any_power", "f = b^n = 2^(n log2 b)", (("base", base), ("n", n)), |b, (base, n)| {
        let exponent_bits = u64::BITS - largest.unsigned_abs().leading_zeros();
        let error = PowerError::of(base.bound(), n.bound().magnitude())
            .and(power_of_two(-i64::from(fraction_bits)));
        let (zero, one) = (b.integer(0), b.integer(1));
        let positive = zero.less_than(&base).named("positive");
        // Of 0 there is no logarithm; 1 goes in instead.
        let base = positive.choose(&base, &one).named("positive_base");
        let minus_log = log2::minus_log2(b, &base, fraction_bits + exponent_bits + 3);
        let y = (&n * minus_log).rounded(fraction_bits + 6).named("y");
        let vanishes = exp2::vanishes(b, &y, fraction_bits).or(&positive.not()).named("vanishes");
        exp2::two_to_minus(b, &y, &vanishes, fraction_bits)
            .override_error("error::power::PowerError::bound", error.bound())
            .named("f")
    })
}
