//! Powers by squaring, over every base and exponent.
use specula_hdl::units;
use specula_spec::Format;

use super::{Bench, outputs, rounded};

fn powers(base_bits: u32, most_squarings: u32) {
    let one = 1 << base_bits;
    let bench = Bench::new();
    let base = bench.input("base", Format::unsigned(1, base_bits), (0, one));
    let j = bench.input("j", Format::unsigned(4, 0), (0, most_squarings.into()));
    let f = units::power(&bench.b, &base, &j, base_bits);
    assert_eq!((f.fraction_bits(), f.range().high), (base_bits, one));
    let design = bench.finish(&[("f", f)]);

    let exponents = || 0..=i64::from(most_squarings);
    let rows: Vec<Vec<i64>> =
        (0..=one).flat_map(|b| exponents().map(move |j| vec![b, j])).collect();
    for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
        let wanted = (0..row[1]).fold(row[0], |b, _| rounded(b * b, base_bits));
        assert_eq!(got, [wanted], "({}/{one})^(2^{})", row[0], row[1]);
    }
}

#[test]
fn every_power_is_repeated_rounding_squares() {
    powers(4, 12);
    powers(6, 5);
    powers(9, 3);
    powers(5, 1);
}

/// n = 1 alone: there is nothing to square, and the base goes through.
#[test]
fn no_squarings_are_wires() {
    let bench = Bench::new();
    let base = bench.input("base", Format::unsigned(1, 4), (0, 16));
    let j = bench.input("j", Format::unsigned(4, 0), (0, 0));
    let f = units::power(&bench.b, &base, &j, 4);
    let design = bench.finish(&[("f", f)]);
    assert_eq!(design.latency(), 0);
    let rows: Vec<Vec<i64>> = (0..=16).map(|b| vec![b, 0]).collect();
    let wanted: Vec<Vec<i64>> = (0..=16).map(|b| vec![b]).collect();
    assert_eq!(outputs(&design, &rows), wanted);
}
