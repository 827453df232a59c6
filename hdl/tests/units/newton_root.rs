//! Newton's root: spans one straight after the other, each from 1 on, against the same steps in
//! whole numbers.
use specula_fixtures::Draw;
use specula_fixtures::clocked::{Drive, paused, run};
use specula_fixtures::formats::direct_formats;
use specula_hdl::units;
use specula_spec::Format;
use specula_spec::direct::DirectFormats;

use super::{Bench, rounded};

const LENGTHS: [u32; 7] = [1, 1, 3, 2, 40, 1, 9];
/// q's fraction bits.
const SQUARE: u32 = 12;

/// m and the fraction bits of d.
fn formats(reach: u32, length: u32) -> DirectFormats {
    DirectFormats {
        length_squared: Format::unsigned(1, SQUARE),
        length: Format::unsigned(1, length),
        reciprocal: Format::unsigned(reach, 10),
        ..direct_formats(Format::unsigned(1, 10))
    }
}

/// (d + q/d)/2, the quotient 2^m at most; q has `SQUARE` fraction bits.
fn step(d: i64, q: i64, reach: u32, bits: u32) -> i64 {
    let (p, divisor) = (q << bits, d << SQUARE);
    let quotient = (((p << (bits + 1)) + divisor) / (2 * divisor)).min(1 << (reach + bits));
    rounded(d + quotient, 1)
}

/// q that stays, falls to less than nothing, rises, and jumps.
#[test]
fn every_pixel_follows_the_one_before() {
    let one = 1i64 << SQUARE;
    for (reach, bits, steps) in [(0, 8, 1), (1, 12, 2), (3, 16, 1), (4, 9, 2)] {
        let bench = Bench::new();
        let formats = formats(reach, bits);
        let q = bench.input("q", formats.length_squared, (-4, one));
        let d = units::newton_root(&bench.b, &bench.start, &q, &formats, steps);
        assert_eq!(d.fraction_bits(), bits);
        let design = bench.finish(&[("d", d)]);

        let values = [one, one / 2, one / 9, 3, -4, 0, one / 5, one, 7, one - 1, 1];
        let pixel = |i: u32, first| Drive {
            valid: true,
            start: first,
            inputs: vec![values[(i * 7 % 11) as usize]],
        };
        let firsts: Vec<bool> =
            LENGTHS.iter().flat_map(|&length| (0..length).map(|i| i == 0)).collect();
        let drives: Vec<Drive> = (0..).zip(&firsts).map(|(i, &first)| pixel(i, first)).collect();
        let got = run(&design, drives.clone());
        assert!(run(&design, paused(&design, &drives, &mut Draw::new(5))) == got);
        let mut d = 0;
        for ((i, first), got) in (0..).zip(firsts).zip(got) {
            let q = values[(i * 7 % 11) as usize].max(1 << (SQUARE - 2 * reach));
            let before = if first { 1 << bits } else { d };
            d = (0..steps).fold(before, |d, _| step(d, q, reach, bits));
            assert_eq!(got, [d], "pixel {i}, m = {reach}, {bits} bits, {steps} steps");
        }
    }
}
