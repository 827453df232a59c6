//! Quotients with integer bits, over every pair of small operands and many of large ones.
use proptest::prelude::*;
use specula_datapath::builder::{Builder, Sig};
use specula_hdl::units::{self, QuotientFormat};
use specula_spec::Format;

use super::{Bench, outputs, property_tests};

type Unit = fn(&Builder, &Sig, &Sig, QuotientFormat) -> Sig;

/// floor(2^f p/q + 1/2) between the limits, 0 where q ≤ 0; p and q are raw numbers, p with so many
/// fraction bits more.
fn wanted(p: i64, q: i64, more: i32, to: QuotientFormat, low: i64) -> i64 {
    if q <= 0 {
        return 0;
    }
    let (p, q) = (i128::from(p) << (-more).max(0), i128::from(q) << more.max(0));
    let nearest = ((p << (to.fraction_bits + 1)) + q).div_euclid(2 * q);
    let limit = 1 << (to.integer_bits + to.fraction_bits);
    nearest.clamp(i128::from(low) << (to.integer_bits + to.fraction_bits), limit) as i64
}

fn check((unit, low): (Unit, i64), [p, q]: [Format; 2], to: QuotientFormat, rows: &[Vec<i64>]) {
    let bench = Bench::new();
    let input =
        |name, format: Format| bench.input(name, format, (format.min_raw(), format.max_raw()));
    let ratio = unit(&bench.b, &input("p", p), &input("q", q), to);
    assert_eq!(ratio.fraction_bits(), to.fraction_bits);
    let design = bench.finish(&[("ratio", ratio)]);
    let more = p.fraction_bits as i32 - q.fraction_bits as i32;
    for (row, got) in rows.iter().zip(outputs(&design, rows)) {
        assert_eq!(
            got,
            [wanted(row[0], row[1], more, to, low)],
            "{}/{} in {p} and {q} to {to:?}",
            row[0],
            row[1]
        );
    }
}

const UNITS: [(Unit, i64); 2] = [(units::quotient, 0), (units::signed_quotient, -1)];

#[test]
fn every_quotient_is_the_nearest() {
    let formats = [
        [Format::signed(1, 3), Format::unsigned(0, 4)],
        [Format::signed(2, 2), Format::signed(1, 3)],
        [Format::unsigned(4, 0); 2],
    ];
    for [p, q] in formats {
        let rows: Vec<Vec<i64>> = (p.min_raw()..=p.max_raw())
            .flat_map(|x| (q.min_raw()..=q.max_raw()).map(move |y| vec![x, y]))
            .collect();
        for (integer_bits, fraction_bits) in [(0, 0), (0, 3), (1, 0), (2, 4), (4, 2), (6, 1)] {
            let to = QuotientFormat { integer_bits, fraction_bits };
            UNITS.iter().for_each(|&unit| check(unit, [p, q], to, &rows));
        }
    }
}

/// Ties go up on either side of 0.
#[test]
fn known_quotients_come_out() {
    let to = QuotientFormat { integer_bits: 2, fraction_bits: 0 };
    assert_eq!(
        [(3, 2), (-3, 2), (1, 2), (-1, 2), (9, 2), (-9, 2)].map(|(p, q)| wanted(p, q, 0, to, -1)),
        [2, -1, 1, 0, 4, -4]
    );
}

proptest! {
    #![proptest_config(property_tests())]
    #[test]
    fn wide_quotients_are_the_nearest(
        operands in prop::collection::vec((any::<i64>(), any::<i64>(), 0u32..24), 20),
        fractions in (1u32..26, 1u32..26),
        integer_bits in 0u32..10,
        fraction_bits in 0u32..18,
    ) {
        let (p, q) = (Format::signed(2, fractions.0), Format::unsigned(1, fractions.1));
        let signed = |x: i64| p.min_raw() + (x & (p.max_raw() - p.min_raw()));
        let row = |&(x, y, shift): &(i64, i64, u32)| vec![signed(x), (y & q.max_raw()) >> shift];
        let rows: Vec<Vec<i64>> = operands.iter().map(row).collect();
        let to = QuotientFormat { integer_bits, fraction_bits };
        UNITS.iter().for_each(|&unit| check(unit, [p, q], to, &rows));
    }
}
