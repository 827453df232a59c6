//! Powers with any whole exponent: 2^(n log₂ b), by tables and short polynomials.
//!
//! Widths and error are derived in docs/arithmetic/units.md.
use specula_scene::format::power_of_two;

use super::power_error::PowerError;
use super::{exp2, fixed_log};
use specula_datapath::builder::{Builder, Sig};

/// b^n for a base from 0 to 1 and whole n ≥ 1, to `fraction_bits`: faithful, off by less than one
/// unit of the last place.
///
/// # Error
/// See [`PowerError`]; less than 1 in any case.
pub fn any_power(b: &Builder, base: &Sig, n: &Sig, fraction_bits: u32) -> Sig {
    any_power_up_to(b, base, n, n.range().high, fraction_bits)
}

/// As [`any_power`], with tables for exponents up to `largest`, whatever n is known to be.
pub fn any_power_up_to(b: &Builder, base: &Sig, n: &Sig, largest: i64, fraction_bits: u32) -> Sig {
    b.unit("any_power", "f = b^n = 2^(n log2 b)", (("base", base), ("n", n)), |b, (base, n)| {
        let exponent_bits = u64::BITS - largest.unsigned_abs().leading_zeros();
        let error = PowerError::of(&base, n.range().magnitude())
            .and(power_of_two(-i64::from(fraction_bits)));
        let (zero, one) = (b.integer(0), b.integer(1));
        let positive = zero.less_than(&base).named("positive");
        // Of 0 there is no logarithm; 1 goes in instead.
        let base = positive.choose(&base, &one).named("positive_base");
        let minus_log = minus_log2(b, &base, fraction_bits + exponent_bits + 3);
        let y = (&n * minus_log).rounded(fraction_bits + 6).named("y");
        let vanishes = exp2::vanishes(b, &y, fraction_bits).or(&positive.not()).named("vanishes");
        error.state(exp2::two_to_minus(b, &y, &vanishes, fraction_bits)).named("f")
    })
}

/// λ = -log₂ b for 0 < b ≤ 1, to `fraction_bits`, off by less than two units of the last place.
///
/// b = m 2^-e with 1 ≤ m < 2; c from a table is about 1/m, r = m c - 1 is small, and λ = e + log₂
/// c - log₂(1 + r).
fn minus_log2(b: &Builder, base: &Sig, fraction_bits: u32) -> Sig {
    b.unit(
        "minus_log2",
        "l = e + log2 c - log2(1 + r), b = m 2^-e, r = m c - 1",
        (("base", base),),
        |b, (base,)| {
            let index_bits = (fraction_bits + 1).div_ceil(4);
            let (m, e) = normalised(b, &base);
            let index =
                (m.truncated(index_bits) - b.integer(1)).times_power_of_two(index_bits as i32);
            let last = power_of_two(index_bits.into()) - 1.0;
            let index = index.assumed(0.0, last, "m < 2").named("index");

            let (reciprocals, logarithms) = tables(index_bits, fraction_bits);
            let c = index.looked_up(reciprocals, index_bits + 4, 0.5).named("c");
            let log_c = index.looked_up(logarithms, fraction_bits, 0.5).named("log2_c");
            let small = power_of_two(-i64::from(index_bits));
            let r = (&m * c - b.integer(1)).assumed(-small, small, "|m c - 1| <= 2^-i").named("r");
            let s = r.squared().rounded(fraction_bits).named("r_squared");
            let t = (&r * &s).rounded(fraction_bits).named("r_cubed");
            // r - r²/2 + r³/3, 1/3 as 5461/2^14: ln(1 + r) to third order.
            let third = b.integer(5461).times_power_of_two(-14);
            let q = (r - s.halved() + t * third).rounded(fraction_bits).named("ln");
            let scale_bits = fraction_bits - index_bits + 2;
            let log2_e =
                b.integer(fixed_log::log2_e(scale_bits)).times_power_of_two(-(scale_bits as i32));
            let log_rest = (q * log2_e).rounded(fraction_bits).named("log2_rest");
            (e + log_c - log_rest).at_least_zero().named("lambda")
        },
    )
}

/// About 1/m for each of the 2^`index_bits` parts of 1 ≤ m < 2, with `index_bits` + 4 fraction
/// bits, and their logarithms.
fn tables(index_bits: u32, fraction_bits: u32) -> (Vec<i64>, Vec<i64>) {
    let bits = index_bits + 4;
    let parts = 1i64 << index_bits;
    // 1/(1 + (i + 1/2)/2^I) = 2^(I+1)/(2^(I+1) + 2i + 1), rounded.
    let middle = |i: i64| (((4 * parts) << bits) / (2 * parts + 2 * i + 1) + 1) / 2;
    let reciprocal = |i: i64| match i {
        0 => 1 << bits,
        i if i == parts - 1 => 1 << (bits - 1),
        i => middle(i),
    };
    let reciprocals: Vec<i64> = (0..parts).map(reciprocal).collect();
    let logarithms = reciprocals.iter().map(|&c| fixed_log::log2(c, bits, fraction_bits)).collect();
    (reciprocals, logarithms)
}

/// m from 1 up to 2 and e with b = m 2^-e, for 0 < b ≤ 1: shifts by 16, 8, 4, 2 and 1 where they
/// leave the number below 2.
fn normalised(b: &Builder, base: &Sig) -> (Sig, Sig) {
    let format = base.fraction_bits();
    b.unit("normalised", "b = m 2^-e, 1 <= m < 2", (("base", base),), |b, (base,)| {
        let (mut m, mut e) = (base, b.integer(0));
        let ulp = power_of_two(-i64::from(format));
        for shift in [16, 8, 4, 2, 1] {
            let limit = b.integer(1).times_power_of_two(1 - shift);
            let shifts = m.less_than(&limit).named("shifts");
            let least = power_of_two(i64::from(1 - shift)).max(ulp);
            m = shifts
                .choose(&m.times_power_of_two(shift), &m)
                .assumed(least, 2.0 - ulp, "2^(1-s) <= m < 2")
                .named("m");
            e = e.with_bit(&shifts).named("e");
        }
        (m, e)
    })
}
