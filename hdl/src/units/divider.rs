//! Division.
use specula_spec::format::power_of_two;

use crate::error::divider::Quotient;
use specula_datapath::builder::{Builder, Sig};

/// p/q clamped to [0, 1], to `fraction_bits`: the [`quotient`] without integer bits.
pub fn divider(b: &Builder, p: &Sig, q: &Sig, fraction_bits: u32) -> Sig {
    let to = QuotientFormat { integer_bits: 0, fraction_bits };
    b.unit("divider", "b = p/q, clamped to [0, 1]", (("p", p), ("q", q)), |b, (p, q)| {
        limited_quotient(b, &p, &q, to).named("base")
    })
}

/// The format of a quotient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuotientFormat {
    /// i: the quotient's magnitude is 2^i at most.
    pub integer_bits: u32,
    /// f: bits right of its binary point.
    pub fraction_bits: u32,
}

impl QuotientFormat {
    fn proof(self, [p, q]: [&Sig; 2]) -> Quotient {
        let limit = power_of_two(self.integer_bits.into());
        Quotient::new([p.bound(), q.bound()], limit, power_of_two(-i64::from(self.fraction_bits)))
    }
}

/// p/q clamped to [0, 2^i], to f fraction bits, correctly rounded (ties up): 0 where p ≤ 0 or q ≤
/// 0, else 2^i where p ≥ 2^i q.
///
/// A restoring divider, a row of subtractor and multiplexer and a clock for each bit of the
/// quotient, and one row more for rounding: with d = 2^i q and Q = ⌊2^(i + f + 1) p/d⌋, ⌊(Q +
/// 1)/2⌋ = ⌊2^f p/q + 1/2⌋. That makes i + f + 1 rows, a clock before them and three behind.
///
/// # Error
/// [`Quotient`], of whose q it is known how small it may be.
pub fn quotient(b: &Builder, p: &Sig, q: &Sig, to: QuotientFormat) -> Sig {
    let formula = format!("r = p/q, clamped to [0, {}]", 1u64 << to.integer_bits);
    b.unit("limited_quotient", &formula, (("p", p), ("q", q)), |b, (p, q)| {
        limited_quotient(b, &p, &q, to).named("ratio")
    })
}

/// p/q clamped to [-2^i, 2^i], to f fraction bits, correctly rounded (ties up); 0 where q ≤ 0.
///
/// p/q + 2^i = (p + 2^i q)/q lies in [0, 2^(i+1)], and adding an integer changes no rounding: the
/// [`quotient`] less 2^i, a row more.
///
/// # Error
/// [`Quotient`], as the [`quotient`]'s.
pub fn signed_quotient(b: &Builder, p: &Sig, q: &Sig, to: QuotientFormat) -> Sig {
    let limit = 1i64 << to.integer_bits;
    b.unit(
        "signed_quotient",
        &format!("r = p/q, clamped to [-{limit}, {limit}]"),
        (("p", p), ("q", q)),
        |b, (p, q)| {
            let error = to.proof([&p, &q]).signed();
            let raised = &p + q.times_power_of_two(to.integer_bits as i32);
            let positive = b.integer(0).less_than(&q);
            let shifted = QuotientFormat { integer_bits: to.integer_bits + 1, ..to };
            let ratio = quotient(b, &raised, &q, shifted) - b.integer(limit);
            positive
                .choose(&ratio, &b.integer(0))
                .override_error("error::divider::Quotient::signed", error)
                .named("ratio")
        },
    )
}

fn limited_quotient(b: &Builder, p: &Sig, q: &Sig, to: QuotientFormat) -> Sig {
    let bits = to.integer_bits + to.fraction_bits;
    let error = to.proof([p, q]).unsigned();
    let q = q.times_power_of_two(to.integer_bits as i32);
    let (zero, one) = (b.integer(0), b.integer(1));
    let positive = zero.less_than(p).and(&zero.less_than(&q)).named("positive");
    let whole = p.at_least(&q).named("whole");
    let proper = positive.and(&whole.not()).named("proper");

    let largest = q.format().value(q.range().high).max(1.0);
    // Outside 0 < p < q the rows see 0/1 instead, so that they never overflow.
    let mut remainder =
        proper.choose(p, &zero).assumed(0.0, largest, "0 <= p < q").named("dividend");
    let divisor = proper.choose(&q, &one).assumed(0.0, largest, "q > 0").named("divisor");
    let mut quotient = zero.clone();
    for _ in 0..=bits {
        let (rest, bit) = row(b, &remainder, &divisor);
        (remainder, quotient) = (rest, quotient.with_bit(&bit).named("bits"));
    }
    let quotient = quotient.times_power_of_two(-(bits as i32 + 1)).rounded(bits).named("quotient");
    let clamped = whole.choose(&one, &quotient);
    let limited = positive.choose(&clamped, &zero).clamped_above(1);
    limited
        .times_power_of_two(to.integer_bits as i32)
        .override_error("error::divider::Quotient::unsigned", error)
}

/// One bit of the quotient: with 0 ≤ r < q, whether 2r ≥ q, and what then remains of 2r, both after
/// one clock.
fn row(b: &Builder, remainder: &Sig, divisor: &Sig) -> (Sig, Sig) {
    let largest = divisor.format().value(divisor.range().high);
    b.unit(
        "divider_row",
        "bit = 2r >= q, r' = 2r - bit q",
        (("r", remainder), ("q", divisor)),
        |b, (r, q)| {
            let (rest, bit) = b.in_one_clock(|| {
                let doubled = r.doubled();
                let difference = &doubled - &q;
                let below = difference.less_than(&b.integer(0));
                let rest = below.choose(&doubled, &difference).assumed(0.0, largest, "0 <= r < q");
                (rest, below.not())
            });
            (rest.named("rest"), bit.named("quotient_bit"))
        },
    )
}
