//! The Gaussian of an angle, against f64, whose own error is far smaller.
use specula_hdl::units;
use specula_spec::Format;

use super::{Bench, outputs};

/// exp(-2n α²) for d = 1 - cos α = 2 sin²(α/2).
fn wanted(d: f64, n: i64) -> f64 {
    (-8.0 * n as f64 * (d / 2.0).sqrt().asin().powi(2)).exp()
}

/// Largest distance from the true value, in units of the last place, over `rows` of distances d and
/// n.
fn worst(versine_bits: u32, largest: i64, fraction_bits: u32, rows: &[Vec<i64>]) -> f64 {
    let bench = Bench::new();
    let versine =
        bench.input("d", Format::unsigned(1, versine_bits), (0, 15 << (versine_bits - 3)));
    let n = bench.input("n", Format::unsigned(13, 0), (1, largest));
    let f = units::gaussian(&bench.b, &versine, &n, fraction_bits);
    assert_eq!((f.fraction_bits(), f.range().high), (fraction_bits, 1 << fraction_bits));
    let bound = f.error();
    let design = bench.finish(&[("f", f)]);
    let ulp = 0.5_f64.powi(versine_bits as i32);
    let off = |(row, got): (&Vec<i64>, Vec<i64>)| {
        (got[0] as f64 - wanted(row[0] as f64 * ulp, row[1]) * f64::from(1 << fraction_bits)).abs()
    };
    let worst = rows.iter().zip(outputs(&design, rows)).map(off).fold(0.0, f64::max);
    assert!(worst <= bound, "{worst}, bound {bound}");
    worst
}

#[test]
fn every_small_gaussian_is_faithful() {
    for (versine_bits, largest, fraction_bits) in [(4, 15, 4), (8, 7, 8), (10, 2, 16), (6, 40, 6)] {
        let versines = 0..=15i64 << (versine_bits - 3);
        let rows: Vec<Vec<i64>> =
            versines.flat_map(|d| (1..=largest).map(move |n| vec![d, n])).collect();
        let worst = worst(versine_bits, largest, fraction_bits, &rows);
        assert!(worst < 0.7, "{worst} units of the last place");
    }
}

/// Angles of which the Gaussian makes something between 0 and 1.
#[test]
fn large_exponents_are_faithful() {
    for (versine_bits, largest, fraction_bits) in [(17, 256, 12), (22, 8191, 12), (22, 8191, 16)] {
        let one = 1i64 << versine_bits;
        let near = |n: i64| (0..400).map(move |i| vec![(i * one / (100 * n)).min(15 * one / 8), n]);
        let exponents = [1, 2, 3, largest / 7, largest - 1, largest];
        let rows: Vec<Vec<i64>> = exponents.into_iter().flat_map(near).collect();
        let worst = worst(versine_bits, largest, fraction_bits, &rows);
        assert!(worst < 0.7, "{worst} units of the last place");
    }
}

#[test]
fn the_ends_are_exact() {
    let largest = 15 << 13;
    let ends = vec![vec![0, 1], vec![0, 8191], vec![largest, 1], vec![largest, 8191]];
    assert!(worst(16, 8191, 12, &ends) < 0.01);
}
