//! Square roots, over every operand of small widths and many of large ones.
use proptest::prelude::*;
use specula_hdl::units;
use specula_spec::Format;

use super::{Bench, outputs, property_tests};

/// The greatest r with (2r - 1)² 2^F ≤ 4 · 2^2f x, or 0: r - 1/2 ≤ 2^f √x, x a raw number with F
/// fraction bits.
fn wanted(x: i64, operand_bits: u32, fraction_bits: u32) -> i64 {
    let not_above =
        |r: i128| (2 * r - 1).pow(2) << operand_bits <= i128::from(x) << (2 * fraction_bits + 2);
    let (mut low, mut high) = (0i128, 1i128 << 40);
    while x > 0 && high - low > 1 {
        let middle = (low + high) / 2;
        if not_above(middle) { low = middle } else { high = middle }
    }
    low as i64
}

fn check(format: Format, fraction_bits: u32, operands: impl Iterator<Item = i64>) {
    let bench = Bench::new();
    let x = bench.input("x", format, (format.min_raw(), format.max_raw()));
    let root = units::square_root(&bench.b, &x, fraction_bits);
    assert_eq!(root.fraction_bits(), fraction_bits);
    let design = bench.finish(&[("root", root)]);
    let rows: Vec<Vec<i64>> = operands.map(|x| vec![x]).collect();
    for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
        assert_eq!(
            got,
            [wanted(row[0], format.fraction_bits, fraction_bits)],
            "{} in {format} to {fraction_bits}",
            row[0]
        );
    }
}

#[test]
fn every_root_is_the_nearest() {
    for (integer_bits, operand_bits) in [(0, 1), (1, 4), (2, 5), (0, 8), (5, 0), (3, 3)] {
        for fraction_bits in [0, 1, 2, 5] {
            for format in [
                Format::signed(integer_bits, operand_bits),
                Format::unsigned(integer_bits, operand_bits),
            ] {
                check(format, fraction_bits, format.min_raw()..=format.max_raw());
            }
        }
    }
}

/// What is worked out beforehand, since the operand is always the same, is what the hardware would
/// give.
#[test]
fn roots_of_constants_are_the_nearest() {
    for format in [Format::unsigned(2, 5), Format::signed(1, 4), Format::unsigned(0, 7)] {
        for (fraction_bits, raw) in [0, 3, 6]
            .into_iter()
            .flat_map(|bits| (format.min_raw()..=format.max_raw()).map(move |x| (bits, x)))
        {
            let bench = Bench::new();
            let x = bench.input("x", format, (raw, raw));
            let root = units::square_root(&bench.b, &x, fraction_bits).range();
            let wanted = wanted(raw, format.fraction_bits, fraction_bits);
            assert_eq!(
                (root.low, root.high),
                (wanted, wanted),
                "{raw} in {format} to {fraction_bits}"
            );
        }
    }
}

/// √2.25 = 1.5 lies half way between integers.
#[test]
fn ties_go_up() {
    assert_eq!([wanted(9, 2, 0), wanted(1, 2, 0), wanted(25, 2, 0)], [2, 1, 3]);
}

proptest! {
    #![proptest_config(property_tests())]
    #[test]
    fn wide_roots_are_the_nearest(
        operands in prop::collection::vec(any::<i64>(), 20),
        integer_bits in 0u32..20,
        operand_bits in 1u32..40,
        fraction_bits in 0u32..20,
    ) {
        let format = Format::unsigned(integer_bits, operand_bits);
        let squares = operands.iter().map(|x| (x >> 20).wrapping_mul(x >> 20));
        let raw = |x: i64| x & format.max_raw();
        check(format, fraction_bits, operands.iter().copied().chain(squares).chain([0, 1, -1]).map(raw));
    }
}

/// The error of an operand that may be 0 is the root of it.
#[test]
fn error_follows_the_slope() {
    let error = |low: i64| {
        let bench = Bench::new();
        let x = bench.input("x", Format::unsigned(1, 12), (low, 4096));
        units::square_root(&bench.b, &x, 10).error_value()
    };
    let (operand, rounding) = (0.5 / 4096.0, 0.5 / 1024.0);
    assert!((error(0) - (f64::sqrt(operand) + rounding)).abs() < 1e-12);
    assert!((error(1024) - (operand / 0.5 + rounding)).abs() < 1e-12);
}
