//! Reciprocal square roots, over every operand of small widths and many of large ones.
use proptest::prelude::*;
use specula_datapath::bound::Interval;
use specula_hdl::units::{self, ReciprocalRoot};
use specula_spec::Format;

use super::{Bench, outputs, property_tests};

/// The greatest r with (2r - 1)² z ≤ 4 · 2^2f, that is r - 1/2 ≤ 2^f/√z; z is a raw number with F
/// fraction bits, and 4^-m at least.
fn wanted(z: i64, operand_bits: u32, to: ReciprocalRoot) -> i64 {
    let places = operand_bits.max(2 * to.integer_bits);
    let z = (i128::from(z) << (places - operand_bits)).max(1 << (places - 2 * to.integer_bits));
    let not_above = |r: i128| (2 * r - 1).pow(2) * z <= 1 << (2 * to.fraction_bits + 2 + places);
    let (mut low, mut high) = (0i128, (1i128 << (to.integer_bits + to.fraction_bits)) + 1);
    while high - low > 1 {
        let middle = (low + high) / 2;
        if not_above(middle) { low = middle } else { high = middle }
    }
    low as i64
}

fn check(format: Format, to: ReciprocalRoot, operands: impl Iterator<Item = i64>) {
    let bench = Bench::new();
    let z = bench.input("z", format, (format.min_raw(), format.max_raw()));
    let reciprocal = units::reciprocal_square_root(&bench.b, &z, to);
    assert_eq!(
        (reciprocal.fraction_bits(), reciprocal.range().high),
        (to.fraction_bits, 1 << (to.integer_bits + to.fraction_bits))
    );
    let design = bench.finish(&[("reciprocal", reciprocal)]);
    let rows: Vec<Vec<i64>> = operands.map(|z| vec![z]).collect();
    for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
        assert_eq!(
            got,
            [wanted(row[0], format.fraction_bits, to)],
            "{} in {format} to {to:?}",
            row[0]
        );
    }
}

#[test]
fn every_reciprocal_is_the_nearest() {
    for (whole_bits, operand_bits) in [(0, 1), (1, 4), (2, 5), (0, 8), (5, 0), (3, 3)] {
        for (integer_bits, fraction_bits) in [(0, 0), (1, 1), (2, 4), (3, 5), (5, 2)] {
            for format in [
                Format::signed(whole_bits, operand_bits),
                Format::unsigned(whole_bits, operand_bits),
            ] {
                let to = ReciprocalRoot { integer_bits, fraction_bits };
                check(format, to, format.min_raw()..=format.max_raw());
            }
        }
    }
}

/// 0, what is negative and what is too small give 2^m; 1 gives 1.
#[test]
fn known_reciprocals_come_out() {
    let to = ReciprocalRoot { integer_bits: 3, fraction_bits: 4 };
    assert_eq!(
        [-5, 0, 1, 4, 16, 64, 256].map(|z| wanted(z, 8, to)),
        [128, 128, 128, 128, 64, 32, 16]
    );
}

proptest! {
    #![proptest_config(property_tests())]
    #[test]
    fn wide_reciprocals_are_the_nearest(
        operands in prop::collection::vec((any::<i64>(), 0u32..30), 20),
        whole_bits in 0u32..4,
        operand_bits in 1u32..30,
        integer_bits in 0u32..12,
        fraction_bits in 0u32..18,
    ) {
        let format = Format::unsigned(whole_bits, operand_bits);
        let raw = |(z, shift): &(i64, u32)| (z & format.max_raw()) >> shift;
        check(format, ReciprocalRoot { integer_bits, fraction_bits }, operands.iter().map(raw).chain([0, 1, format.max_raw()]));
    }
}

/// Half of e/s^(3/2), and nothing better than 2^m where z may be 0.
#[test]
fn error_follows_the_slope() {
    let bench = Bench::new();
    let z = bench.input("z", Format::unsigned(1, 12), (0, 4096));
    let to = ReciprocalRoot { integer_bits: 3, fraction_bits: 10 };
    let error = |smallest| {
        let z = z.clone().real_within(Interval::at_least(smallest), "stated");
        units::reciprocal_square_root(&bench.b, &z, to).error_value()
    };
    let (operand, rounding) = (0.5 / 4096.0, 0.5 / 1024.0);
    assert!((error(0.25 + operand) - (operand / 2.0 * 8.0 + rounding)).abs() < 1e-12);
    assert!((error(0.0) - (operand / 2.0 * 512.0 + rounding)).abs() < 1e-12);
}
