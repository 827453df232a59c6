//! Exact normalisation, over every normal of a small width and many of a large one.
use proptest::prelude::*;
use specula_datapath::builder::Vector;
use specula_hdl::units::{self, ExactNormalisation, ReciprocalRoot};
use specula_spec::Format;

use super::{Bench, cube, outputs, property_tests};

/// floor(raw / 2^bits + 1/2), or raw · 2^-bits.
fn narrowed(raw: i128, bits: i32) -> i128 {
    if bits > 0 { (raw + (1 << (bits - 1))) >> bits } else { raw << -bits }
}

/// n and whether it has a direction: z, r and n as whole numbers, r by trying.
fn wanted(normal: [i64; 3], v: u32, to: ExactNormalisation) -> Vec<i64> {
    let (l, r) = (to.length_squared_fraction_bits, to.reciprocal);
    let squared: i128 = normal.iter().map(|&c| i128::from(c) * i128::from(c)).sum();
    let z = narrowed(squared, 2 * v as i32 - l as i32);
    let places = l.max(2 * r.integer_bits);
    let limited = (z << (places - l)).max(1 << (places - 2 * r.integer_bits));
    let not_above =
        |g: i128| (2 * g - 1).pow(2) * limited <= 1 << (2 * r.fraction_bits + 2 + places);
    let (mut low, mut high) = (0i128, (1i128 << (r.integer_bits + r.fraction_bits)) + 1);
    while high - low > 1 {
        let middle = (low + high) / 2;
        if not_above(middle) { low = middle } else { high = middle }
    }
    let component = |c: i64| {
        narrowed(low * i128::from(c), (r.fraction_bits + v) as i32 - to.vector_fraction_bits as i32)
            as i64
    };
    let [x, y, z_component] = normal.map(component);
    vec![x, y, z_component, i64::from(z > 0)]
}

fn check(v: u32, to: ExactNormalisation, longest: f64, normals: &[[i64; 3]]) -> Vec<Vec<i64>> {
    let bench = Bench::new();
    let format = Format::signed(1, v);
    let ends = (-(1 << v), 1 << v);
    let normal = Vector::new(["x", "y", "z"].map(|name| bench.input(name, format, ends)))
        .no_longer_than(longest);
    let (n, has_direction) = units::normalise_exactly(&bench.b, &normal, to);
    let design =
        bench.finish(&[("x", n.x), ("y", n.y), ("z", n.z), ("has_direction", has_direction)]);
    let rows: Vec<Vec<i64>> = normals.iter().map(|n| n.to_vec()).collect();
    let got = outputs(&design, &rows);
    for (row, got) in normals.iter().zip(&got) {
        assert_eq!(*got, wanted(*row, v, to), "{row:?} with {to:?}");
    }
    got
}

fn formats(
    length_squared: u32,
    integer_bits: u32,
    fraction_bits: u32,
    vector: u32,
) -> ExactNormalisation {
    ExactNormalisation {
        length_squared_fraction_bits: length_squared,
        reciprocal: ReciprocalRoot { integer_bits, fraction_bits },
        vector_fraction_bits: vector,
    }
}

#[test]
fn every_small_normal() {
    let normals: Vec<[i64; 3]> = cube(8).collect();
    for to in [formats(6, 3, 8, 4), formats(4, 1, 4, 3), formats(5, 4, 6, 6)] {
        check(3, to, 2.0, &normals);
    }
}

/// With enough bits inside, n is the nearest to N/|N| in every component, or next to it.
#[test]
fn components_are_within_one_unit_of_the_direction() {
    let normals: Vec<[i64; 3]> = cube(8).filter(|n| *n != [0; 3]).collect();
    let got = check(3, formats(6, 3, 14, 8), 2.0, &normals);
    for (normal, got) in normals.iter().zip(got) {
        let length = normal.iter().map(|&c| (c * c) as f64).sum::<f64>().sqrt();
        for (c, got) in normal.iter().zip(got) {
            let off = (got as f64 - 256.0 * *c as f64 / length).abs();
            assert!(off <= 0.52, "{normal:?}: {off} units");
        }
    }
}

proptest! {
    #![proptest_config(property_tests())]
    #[test]
    fn wide_normals_agree_with_integers(
        normals in prop::collection::vec((any::<[i32; 3]>(), 0u32..16), 20),
        v in 8u32..18,
        length_squared in 8u32..24,
        integer_bits in 0u32..9,
        fraction_bits in 6u32..18,
        vector in 6u32..18,
    ) {
        let raw = |&(n, shift): &([i32; 3], u32)| n.map(|c| i64::from(c) >> (31 - v) >> shift);
        let normals: Vec<[i64; 3]> = normals.iter().map(raw).chain([[0; 3], [0, 0, 1 << v]]).collect();
        check(v, formats(length_squared, integer_bits, fraction_bits, vector), 2.0, &normals);
    }
}

/// With shortest s = 1/2 and N off by e as a whole, n turns by e/√(s (s - e)), gets longer by what
/// z and r round, and is rounded.
#[test]
fn error_is_known_of_long_normals_alone() {
    let bench = Bench::new();
    let ends = (-(1 << 12), 1 << 12);
    let normal =
        Vector::new(["x", "y", "z"].map(|name| bench.input(name, Format::signed(1, 12), ends)))
            .no_longer_than(1.0);
    let error = |shortest| {
        let normal = normal.clone().no_shorter_than(shortest, "stated");
        let (n, has_direction) =
            units::normalise_exactly(&bench.b, &normal, formats(20, 4, 14, 12));
        (n.x.error_value(), has_direction.error())
    };
    let half_unit = 0.5 / 4096.0;
    let e = 3f64.sqrt() * half_unit;
    let (known, sure) = error(0.5);
    let floor = e / (0.5 * (0.5 - e)).sqrt() + half_unit;
    assert!(known > floor && known < 1.1 * floor, "{known} is stated, about {floor} proven");
    assert_eq!(sure, 0.0);
    assert!(error(0.0).0 > 2.0 && error(0.0).1 == 1.0);
}
