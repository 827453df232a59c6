//! -log₂ by a table of reciprocals and their logarithms, and three terms of a series.
//!
//! Widths and error are derived in docs/arithmetic/units.md.
use specula_spec::format::power_of_two;

use super::tables;
use specula_datapath::builder::{Builder, Sig};

/// λ = -log₂ b for 0 < b ≤ 1, to `fraction_bits`, off by less than two units of the last place.
///
/// b = m 2^-e with 1 ≤ m < 2; c from a table is about 1/m, r = m c - 1 is small, and λ = e + log₂
/// c - log₂(1 + r).
pub fn minus_log2(b: &Builder, base: &Sig, fraction_bits: u32) -> Sig {
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

            let (reciprocals, logarithms) = entries(index_bits, fraction_bits);
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
                b.integer(tables::log2_e(scale_bits)).times_power_of_two(-(scale_bits as i32));
            let log_rest = (q * log2_e).rounded(fraction_bits).named("log2_rest");
            (e + log_c - log_rest).at_least_zero().named("lambda")
        },
    )
}

/// About 1/m for each of the 2^`index_bits` parts of 1 ≤ m < 2, with `index_bits` + 4 fraction
/// bits, and their logarithms.
fn entries(index_bits: u32, fraction_bits: u32) -> (Vec<i64>, Vec<i64>) {
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
    let logarithms = reciprocals.iter().map(|&c| tables::log2(c, bits, fraction_bits)).collect();
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
