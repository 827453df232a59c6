//! The shape of the highlight.
use specula_datapath::Design;
use specula_datapath::builder::Vector;
use specula_hdl::units;
use specula_spec::{Format, LyonSpec};

use super::{Bench, cube, dot, lyon, outputs, rounded};

/// The unit for vectors D no longer than 2 and exponents up to `largest`.
fn design(lyon: &LyonSpec, largest: i64) -> Design {
    let bench = Bench::new();
    let format = lyon.formats.difference;
    let two = format.quantise(2.0 - format.ulp()) + 1;
    let d = ["d_x", "d_y", "d_z"].map(|name| bench.input(name, format, (-two, two)));
    let n = bench.input("n", Format::unsigned(13, 0), (1, largest));
    let has_direction = bench.input("has_direction", Format::unsigned(1, 0), (0, 1));
    let d = Vector::new(d).no_longer_than(2.0);
    let f = units::shape(
        &bench.b,
        (&d, units::LengthError::whole(d.bound().error.length)),
        &n,
        &has_direction,
        lyon,
    );
    bench.finish(&[("f", f)])
}

fn row(d: [i64; 3], n: i64, has_direction: i64) -> Vec<i64> {
    vec![d[0], d[1], d[2], n, has_direction]
}

/// f_k in whole numbers: x has twice D's fraction bits and k + 1 more.
fn wanted(lyon: &LyonSpec, row: &[i64]) -> i64 {
    let (d, n) = ([row[0], row[1], row[2]], row[3]);
    let f = lyon.formats.shape.fraction_bits;
    let scale = 2 * lyon.formats.difference.fraction_bits + lyon.squarings + 1;
    let x =
        if scale >= f { rounded(n * dot(d, d), scale - f) } else { (n * dot(d, d)) << (f - scale) };
    let shape = if row[4] == 0 { 0 } else { ((1 << f) - x).max(0) };
    let odd = (0..lyon.odd_power.ilog2()).rev().fold(shape, |s, digit| {
        let square = rounded(s * s, f);
        if lyon.odd_power >> digit & 1 == 1 { rounded(square * shape, f) } else { square }
    });
    (0..lyon.squarings).fold(odd, |s, _| rounded(s * s, f))
}

fn check(lyon: &LyonSpec, design: &Design, rows: &[Vec<i64>]) {
    for (row, got) in rows.iter().zip(outputs(design, rows)) {
        assert_eq!(got, [wanted(lyon, row)], "D, n, has_direction = {row:?}, K = {}", lyon.terms());
    }
}

/// Every D of 3 fraction bits that is no longer than 2, and some exponents, for k = 0 to 4 and odd
/// powers; whole numbers stand for n over the odd power too.
#[test]
fn every_short_difference() {
    let powers = (0..=4).map(|k| (1, k)).chain([(3, 0), (5, 1), (11, 0), (15, 2)]);
    for (odd_power, squarings) in powers {
        let mut lyon = lyon(3);
        (lyon.odd_power, lyon.squarings) = (odd_power, squarings);
        lyon.formats.shape.fraction_bits = 6;
        let design = design(&lyon, 300);
        let within = cube(16).filter(|&d| dot(d, d) <= 16 * 16);
        // Every exponent with every fourth vector is as good as all with all, and four times as
        // fast.
        let rows: Vec<Vec<i64>> = within
            .enumerate()
            .map(|(i, d)| row(d, [1, 2, 5, 300][i % 4], i64::from(i % 7 != 0)))
            .collect();
        check(&lyon, &design, &rows);
    }
}

/// Three whole numbers up to `limit` whose squares add up to `sum`, if there are any.
fn three_squares(sum: i64, limit: i64) -> Option<[i64; 3]> {
    let root = |rest: i64| (rest as f64).sqrt().round() as i64;
    let pairs = (0..=limit).flat_map(|a| (0..=a).map(move |b| (a, b)));
    let mut triples =
        pairs.filter(|(a, b)| a * a + b * b <= sum).map(|(a, b)| [a, b, root(sum - a * a - b * b)]);
    triples.find(|&d| dot(d, d) == sum && d[2] <= limit)
}

/// extremes row 21: x = 2^k exactly and one unit of the last place to either side; 0 from there on
/// and never negative to an even power.
#[test]
fn end_of_the_shape() {
    for squarings in 0..=3u32 {
        let mut lyon = lyon(7);
        lyon.squarings = squarings;
        // With n = 2^k, x/2^k is D.D/2. A unit of its last place is four of D.D's, and four sums
        // round to each value of x.
        lyon.formats.shape.fraction_bits = 13;
        let design = design(&lyon, 8);
        let n = 1 << squarings;
        let with_x = |x: i64| (4 * x - 2..4 * x + 2).find_map(|sum| three_squares(sum, 256));
        let rows = [-1, 0, 1].map(|ulps| {
            row(with_x((1 << 13) + ulps).expect("one of four sums is one of three squares"), n, 1)
        });
        check(&lyon, &design, &rows);
        let got: Vec<i64> = outputs(&design, &rows).into_iter().map(|codes| codes[0]).collect();
        // One unit of the last place squared is far below half a unit.
        assert_eq!(got, [i64::from(squarings == 0), 0, 0]);
    }
}

/// extremes row 22: x = 0 gives 1.0 exactly, and a normal without direction 0 (row 1).
#[test]
fn centre_of_the_shape() {
    for squarings in 0..=3 {
        let mut lyon = lyon(5);
        lyon.squarings = squarings;
        let design = design(&lyon, 8191);
        assert_eq!(outputs(&design, &[row([0; 3], 8191, 1), row([0; 3], 8191, 0)]), [[32], [0]]);
    }
}

/// extremes rows 24 and 31: the longest D with the largest exponent, along one axis alone and along
/// none.
#[test]
fn the_longest_difference_gives_no_highlight() {
    let mut lyon = lyon(6);
    lyon.formats.shape.fraction_bits = 12;
    let design = design(&lyon, 8191);
    let two = 128;
    let rows: Vec<Vec<i64>> =
        [[two, 0, 0], [0, -two, 0], [0, 0, two], [73, 73, -75]].map(|d| row(d, 8191, 1)).to_vec();
    check(&lyon, &design, &rows);
    assert_eq!(outputs(&design, &rows), [[0], [0], [0], [0]]);
}
