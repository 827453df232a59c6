//! Division.
use specula_scene::format::power_of_two;

use crate::builder::{Builder, Sig};

/// p/q clamped to [0, 1], to `fraction_bits`, correctly rounded (ties up): 0 where p ≤ 0 or q ≤ 0, else 1 where p ≥ q.
///
/// A restoring divider, a row of subtractor and multiplexer and a clock for each bit of the quotient, and one row more for rounding:
/// with Q = ⌊2^(f+1) p/q⌋, ⌊(Q + 1)/2⌋ = ⌊2^f p/q + 1/2⌋.
///
/// # Error
/// Both quotients are clamped, so with q ≥ `smallest_divisor` the result is off by (e_p + e_q)/(smallest_divisor - e_q) and half a
/// unit of the last place; by 1 at most where nothing is known of q.
pub fn divider(b: &Builder, p: &Sig, q: &Sig, fraction_bits: u32, smallest_divisor: f64) -> Sig {
    b.unit("divider", "b = p/q, clamped to [0, 1]", (("p", p), ("q", q)), |b, (p, q)| {
        let error = quotient_error(&p, &q, smallest_divisor) + 0.5 * power_of_two(-i64::from(fraction_bits));
        let (zero, one) = (b.integer(0), b.integer(1));
        let positive = zero.less_than(&p).and(&zero.less_than(&q)).named("positive");
        let whole = p.at_least(&q).named("whole");
        let proper = positive.and(&whole.not()).named("proper");

        let largest = q.format().value(q.range().high).max(1.0);
        // Outside 0 < p < q the rows see 0/1 instead, so that they never overflow.
        let mut remainder = proper.choose(&p, &zero).assumed(0.0, largest, "0 <= p < q").named("dividend");
        let divisor = proper.choose(&q, &one).assumed(0.0, largest, "q > 0").named("divisor");
        let mut quotient = zero.clone();
        for _ in 0..=fraction_bits {
            let (rest, bit) = row(b, &remainder, &divisor);
            (remainder, quotient) = (rest, quotient.with_bit(&bit).named("bits"));
        }
        let quotient = quotient.times_power_of_two(-(fraction_bits as i32 + 1)).rounded(fraction_bits).named("quotient");
        let clamped = whole.choose(&one, &quotient);
        positive.choose(&clamped, &zero).clamped_above(1).stated_error_value(error).named("base")
    })
}

fn quotient_error(p: &Sig, q: &Sig, smallest_divisor: f64) -> f64 {
    let surely = smallest_divisor - q.error_value();
    if surely > 0.0 { ((p.error_value() + q.error_value()) / surely).min(1.0) } else { 1.0 }
}

/// One bit of the quotient: with 0 ≤ r < q, whether 2r ≥ q, and what then remains of 2r, both after one clock.
fn row(b: &Builder, remainder: &Sig, divisor: &Sig) -> (Sig, Sig) {
    let largest = divisor.format().value(divisor.range().high);
    b.unit("divider_row", "bit = 2r >= q, r' = 2r - bit q", (("r", remainder), ("q", divisor)), |b, (r, q)| {
        let (rest, bit) = b.in_one_clock(|| {
            let doubled = r.doubled();
            let difference = &doubled - &q;
            let below = difference.less_than(&b.integer(0));
            let rest = below.choose(&doubled, &difference).assumed(0.0, largest, "0 <= r < q");
            (rest, below.not())
        });
        (rest.named("rest"), bit.named("quotient_bit"))
    })
}
