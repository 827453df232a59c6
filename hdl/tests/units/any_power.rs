//! Powers with any exponent: small ones against exact integers, large ones against f64, whose own
//! error is far smaller.
use specula_hdl::units;
use specula_spec::Format;

use super::{Bench, outputs};

/// What the unit gives for `rows` of bases and exponents.
fn powers(base_bits: u32, largest: u32, fraction_bits: u32, rows: &[Vec<i64>]) -> Vec<i64> {
    let bench = Bench::new();
    let base = bench.input("base", Format::unsigned(1, base_bits), (0, 1 << base_bits));
    let n = bench.input("n", Format::unsigned(15, 0), (1, largest.into()));
    let f = units::any_power(&bench.b, &base, &n, fraction_bits);
    assert_eq!((f.fraction_bits(), f.range().high), (fraction_bits, 1 << fraction_bits));
    let design = bench.finish(&[("f", f)]);
    outputs(&design, rows).into_iter().map(|got| got[0]).collect()
}

/// Largest distance from the true power, in units of the last place.
fn worst(base_bits: u32, largest: u32, fraction_bits: u32, rows: &[Vec<i64>]) -> f64 {
    let one = f64::from(1 << base_bits);
    let off = |(row, got): (&Vec<i64>, i64)| {
        (got as f64 - (row[0] as f64 / one).powi(row[1] as i32) * f64::from(1 << fraction_bits))
            .abs()
    };
    rows.iter().zip(powers(base_bits, largest, fraction_bits, rows)).map(off).fold(0.0, f64::max)
}

/// |f - 2^F (b/B)^n| < 1 as integers: |f B^n - 2^F b^n| < B^n.
#[test]
fn every_small_power_is_faithful() {
    for (base_bits, largest, fraction_bits) in [(6, 15, 4), (8, 7, 8), (3, 40, 6), (1, 100, 3)] {
        let bases = 0..=1i64 << base_bits;
        let rows: Vec<Vec<i64>> =
            bases.flat_map(|b| (1..=i64::from(largest)).map(move |n| vec![b, n])).collect();
        for (row, got) in rows.iter().zip(powers(base_bits, largest, fraction_bits, &rows)) {
            let (b, n) = (i128::from(row[0]), row[1] as u32);
            let (one, power) = (1i128 << (base_bits * n), b.pow(n) << fraction_bits);
            assert!(
                (i128::from(got) * one - power).abs() < one,
                "({b}/2^{base_bits})^{n} to {fraction_bits} bits: {got}"
            );
        }
    }
}

/// Bases near enough to 1 for the power to be between 0 and 1; and the ends.
#[test]
fn large_exponents_are_faithful() {
    for (base_bits, largest, fraction_bits) in [(17, 256, 12), (22, 8191, 12), (24, 32764, 16)] {
        let one = 1i64 << base_bits;
        let near = |n: i64| (0..400).map(move |i| vec![(one - i * one / (40 * n)).max(0), n]);
        let exponents =
            [1, 2, 3, i64::from(largest) / 7, i64::from(largest) - 1, i64::from(largest)];
        let rows: Vec<Vec<i64>> = exponents.into_iter().flat_map(near).collect();
        let worst = worst(base_bits, largest, fraction_bits, &rows);
        assert!(worst < 1.0, "{worst} units of the last place");
    }
}

#[test]
fn the_ends_are_exact() {
    let ends = vec![vec![0, 1], vec![0, 8191], vec![1 << 16, 1], vec![1 << 16, 8191]];
    assert_eq!(worst(16, 8191, 12, &ends), 0.0);
}
