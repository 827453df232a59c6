//! 2^-y by a shift, a table of roots and two terms of a series.
//!
//! Widths and error are derived in docs/arithmetic/units.md.
use specula_spec::format::power_of_two;

use super::tables;
use specula_datapath::builder::{Builder, Sig};

/// The bit y ≥ `fraction_bits` + 2: 2^-y is then less than a quarter of the last place.
pub fn vanishes(b: &Builder, y: &Sig, fraction_bits: u32) -> Sig {
    y.at_least(&b.integer(i64::from(fraction_bits) + 2))
}

/// 2^-y for y ≥ 0 of `fraction_bits` + 6, rounded to `fraction_bits`; 0 where `vanishes`, which has
/// at least the bit of that name.
///
/// # Error
/// Faithful: less than one unit of the last place in all, y's half unit included.
pub fn two_to_minus(b: &Builder, y: &Sig, vanishes: &Sig, fraction_bits: u32) -> Sig {
    let zero = b.integer(0);
    let beyond = f64::from(fraction_bits + 2) - power_of_two(-i64::from(fraction_bits + 6));
    let y = vanishes.choose(&zero, y).assumed(0.0, beyond, "y < f + 2").named("kept_y");
    vanishes.choose(&zero, &fraction_and_shift(b, &y, fraction_bits))
}

/// 2^-y for 0 ≤ y < `fraction_bits` + 2, rounded to `fraction_bits`.
///
/// y = Y + h/64 + δ: a shift, a table's entry, and 1 - d + d²/2 with d = δ ln 2 < 0.0109, whose
/// cube is lost.
fn fraction_and_shift(b: &Builder, y: &Sig, fraction_bits: u32) -> Sig {
    b.unit("two_to_minus", "f = 2^-y = 2^-Y 2^(-h/64) (1 - d + d^2/2)", (("y", y),), |b, (y,)| {
        let bits = fraction_bits + 6;
        let ulp = power_of_two(-i64::from(bits));
        let whole = y.truncated(0).named("whole");
        let upper = y.truncated(6);
        let h = (&upper - &whole).times_power_of_two(6).assumed(0.0, 63.0, "h < 64").named("h");
        let delta = (&y - &upper).assumed(0.0, 1.0 / 64.0 - ulp, "delta < 1/64").named("delta");
        let ln_2 = b.integer(tables::ln_2(bits)).times_power_of_two(-(bits as i32));
        let d = (delta * ln_2).rounded(bits).named("d");
        let p = (&d - d.squared().halved()).rounded(bits).named("p");
        let entries = (0..64).map(|h| tables::two_to_minus(h, bits)).collect();
        let entry = h.looked_up(entries, bits, 0.5).named("entry");
        let fraction = (entry * (b.integer(1) - p))
            .rounded(bits)
            .assumed(0.0, 1.0, "2^-x <= 1")
            .named("fraction");
        shifted_right(b, &fraction, &whole).rounded(fraction_bits).named("power")
    })
}

/// x 2^-Y, exactly.
fn shifted_right(b: &Builder, x: &Sig, by: &Sig) -> Sig {
    let most = by.range().high;
    let (mut x, mut by) = (x.clone(), by.clone());
    for bit in (0..i64::BITS - most.leading_zeros()).rev() {
        let shift = 1i64 << bit;
        let shifts = by.at_least(&b.integer(shift)).named("shifts_right");
        x = shifts.choose(&x.times_power_of_two(-(shift as i32)), &x).named("shifted");
        let rest = shifts.choose(&(&by - b.integer(shift)), &by);
        by = rest.assumed(0.0, (shift - 1) as f64, "Y < 2 s").named("rest");
    }
    x
}
