//! Approximate normalisation, over every normal of a small width.
use specula_datapath::Design;
use specula_datapath::builder::Vector;
use specula_hdl::units;
use specula_spec::LyonSpec;
use specula_spec::lyon::Normalisation;

use super::{Bench, cube, dot, lyon, outputs, rounded};

/// One unit of the last place longer than a unit vector: what rounding leaves.
const LONGEST: f64 = 1.0 + 1.0 / 16.0;

fn design(lyon: &LyonSpec) -> Design {
    let bench = Bench::new();
    let ends = (-17, 17);
    let normal = ["x", "y", "z"].map(|name| bench.input(name, lyon.formats.vector, ends));
    let normal = Vector::new(normal).no_longer_than(LONGEST);
    let (n, has_direction) = units::normalise(&bench.b, &normal, lyon);
    bench.finish(&[("x", n.x), ("y", n.y), ("z", n.z), ("has_direction", has_direction)])
}

/// n and whether it has a direction, in whole numbers.
fn wanted(lyon: &LyonSpec, normal: [i64; 3]) -> Vec<i64> {
    let f = &lyon.formats;
    let (v, l, g) = (f.vector.fraction_bits, f.length_squared.fraction_bits, f.gain.fraction_bits);
    let z = narrowed(dot(normal, normal), 2 * v, l);
    let mut gain = first_gain(lyon, z);
    for _ in 0..lyon.newton_steps {
        let square = rounded(gain * gain, g);
        let factor = narrowed((3 << (l + g)) - z * square, l + g, g);
        gain = rounded(gain * factor, g + 1);
    }
    let n = normal.map(|c| rounded(gain * c, g));
    vec![n[0], n[1], n[2], i64::from(z > 0)]
}

/// 1 + y/2 or 1 + (y + y²)/2, all in units of 2^-(2l + 1).
fn first_gain(lyon: &LyonSpec, z: i64) -> i64 {
    let l = lyon.formats.length_squared.fraction_bits;
    let y = (1 << l) - z;
    let above_one = match lyon.normalisation {
        Normalisation::None | Normalisation::Exact => unreachable!("neither has a first gain"),
        Normalisation::G1 => y << l,
        Normalisation::G2 => (y << l) + y * y,
    };
    narrowed((1 << (2 * l + 1)) + above_one, 2 * l + 1, lyon.formats.gain.fraction_bits)
}

/// From `from` to `to` fraction bits: rounded, or exact where there is room.
fn narrowed(raw: i64, from: u32, to: u32) -> i64 {
    if from > to { rounded(raw, from - to) } else { raw << (to - from) }
}

fn check(lyon: &LyonSpec, normals: &[[i64; 3]]) {
    let rows: Vec<Vec<i64>> = normals.iter().map(|n| n.to_vec()).collect();
    for (row, got) in normals.iter().zip(outputs(&design(lyon), &rows)) {
        assert_eq!(
            got,
            wanted(lyon, *row),
            "{row:?}, {:?} and {} steps",
            lyon.normalisation,
            lyon.newton_steps
        );
    }
}

fn within_reach() -> Vec<[i64; 3]> {
    cube(17).filter(|&n| dot(n, n) <= 17 * 17).collect()
}

fn every_option() -> impl Iterator<Item = LyonSpec> {
    let options = [Normalisation::G1, Normalisation::G2]
        .into_iter()
        .flat_map(|n| (0..=3).map(move |steps| (n, steps)));
    options.map(|(normalisation, newton_steps)| LyonSpec { normalisation, newton_steps, ..lyon(4) })
}

/// Every normal of S1.4, with formats equal, finer and coarser.
#[test]
fn every_small_normal() {
    let normals = within_reach();
    for (number, mut lyon) in every_option().enumerate() {
        let (length_squared, gain) = [(4, 4), (8, 6), (5, 9), (8, 12)][number % 4];
        (lyon.formats.length_squared.fraction_bits, lyon.formats.gain.fraction_bits) =
            (length_squared, gain);
        check(&lyon, &normals);
    }
}

/// extremes row 26: z a little above 1, y negative and the gain below 1.
#[test]
fn a_little_longer_than_one() {
    let longer: Vec<[i64; 3]> =
        within_reach().into_iter().filter(|&n| dot(n, n) > 16 * 16).collect();
    assert!(longer.len() > 100);
    for mut lyon in every_option() {
        (lyon.formats.length_squared.fraction_bits, lyon.formats.gain.fraction_bits) = (8, 8);
        check(&lyon, &longer);
        let below_one = |n: &&[i64; 3]| first_gain(&lyon, dot(**n, **n)) < 1 << 8;
        assert!(longer.iter().filter(below_one).count() > 100);
    }
}

/// extremes rows 1 and 27: no normal, no direction; the gain is 2.0 and not wrapped around.
#[test]
fn no_normal_at_all() {
    for lyon in every_option() {
        check(&lyon, &[[0; 3]]);
        assert_eq!(wanted(&lyon, [0; 3]), [0; 4]);
        let g2 = lyon.normalisation == Normalisation::G2;
        assert_eq!(first_gain(&lyon, 0), if g2 { 32 } else { 24 });
    }
}
