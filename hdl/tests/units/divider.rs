//! The divider, over every pair of operands.
use specula_datapath::bound::Interval;
use specula_hdl::units;
use specula_spec::Format;

use super::{Bench, outputs};

/// p/q of signed operands with `operand_bits` fraction bits, to `base_bits`.
fn quotients(operand_bits: u32, base_bits: u32) {
    let format = Format::signed(1, operand_bits);
    let ends = (format.min_raw(), format.max_raw());
    let bench = Bench::new();
    let (p, q) = (bench.input("p", format, ends), bench.input("q", format, ends));
    let base = units::divider(&bench.b, &p, &q, base_bits);
    assert_eq!((base.fraction_bits(), base.range().high), (base_bits, 1 << base_bits));
    let design = bench.finish(&[("base", base)]);

    let values = || ends.0..=ends.1;
    let rows: Vec<Vec<i64>> = values().flat_map(|p| values().map(move |q| vec![p, q])).collect();
    for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
        assert_eq!(
            got,
            [nearest(row[0], row[1], base_bits)],
            "{}/{} to {base_bits} bits",
            row[0],
            row[1]
        );
    }
}

/// 0 where p ≤ 0 or q ≤ 0, else 1 where p ≥ q, else the multiple b of the last place with b - 1/2 ≤
/// p/q < b + 1/2.
fn nearest(p: i64, q: i64, base_bits: u32) -> i64 {
    if p <= 0 || q <= 0 {
        return 0;
    }
    if p >= q {
        return 1 << base_bits;
    }
    let twice = 2 * (p << base_bits);
    let nearest: Vec<i64> = (0..=1 << base_bits)
        .filter(|b| (2 * b - 1) * q <= twice && twice < (2 * b + 1) * q)
        .collect();
    assert_eq!(nearest.len(), 1);
    nearest[0]
}

#[test]
fn every_quotient_is_the_nearest() {
    for base_bits in [0, 1, 4, 5, 8] {
        quotients(4, base_bits);
    }
    for base_bits in [3, 6] {
        quotients(5, base_bits);
    }
}

/// Both operands are off by half a unit of the last place; comparisons and bits show nothing of it,
/// so it must be stated.
#[test]
fn error_is_the_operands_over_the_smallest_divisor() {
    let format = Format::signed(1, 12);
    let bench = Bench::new();
    let ends = (-(1 << 12), 1 << 12);
    let (p, q) = (bench.input("p", format, ends), bench.input("q", format, ends));
    let q = q.real_within(Interval::at_least(0.25), "stated");
    let base = units::divider(&bench.b, &p, &q, 10);
    let operands = 2.0 * 0.5 / 4096.0;
    let wanted = operands / (0.25 - 0.5 / 4096.0) + 0.5 / 1024.0;
    assert!(
        (base.error_value() - wanted).abs() < 1e-12,
        "{} is stated, {wanted} proven",
        base.error_value()
    );
}
