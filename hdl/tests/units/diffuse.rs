//! Lambert's cosine.
use specula_datapath::builder::Vector;
use specula_hdl::units;

use super::{Bench, cube, dot, lyon, outputs, rounded};

/// Every pair of a normal no longer than 1 and some lights in S1.3, about as long as `longest`
/// eighths: half of the products are negative and give 0.
fn cosines_are_clamped_at_zero(longest: i64) {
    let mut lyon = lyon(3);
    lyon.formats.diffuse.fraction_bits = 4;
    let bench = Bench::new();
    let vector = |name: &str, longest: i64| {
        let component =
            |axis| bench.input(&format!("{name}_{axis}"), lyon.formats.vector, (-longest, longest));
        Vector::new(["x", "y", "z"].map(component)).no_longer_than(longest as f64 / 8.0)
    };
    let (n, l) = (vector("n", 8), vector("l", longest));
    let intensity = units::diffuse(&bench.b, &n, &l, &lyon.formats);
    let design = bench.finish(&[("intensity", intensity)]);

    let within = |longest: i64| cube(longest).filter(move |&v| dot(v, v) <= longest * longest);
    let is_long = |&v: &[i64; 3]| dot(v, v) > longest * longest - 4;
    let lights: Vec<[i64; 3]> = within(longest).filter(is_long).step_by(5).collect();
    let rows: Vec<Vec<i64>> =
        within(8).flat_map(|n| lights.iter().map(move |l| [n, *l].concat())).collect();
    let mut dark = 0;
    for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
        let cosine = dot([row[0], row[1], row[2]], [row[3], row[4], row[5]]);
        dark += usize::from(cosine < 0);
        assert_eq!(got, [rounded(cosine, 2).max(0)], "{row:?}");
    }
    assert!(dark > rows.len() / 3);
}

#[test]
fn cosines_of_unit_vectors_are_clamped_at_zero() {
    cosines_are_clamped_at_zero(8);
}

/// As lights at places are that are brought near unit length alone.
#[test]
fn lights_may_be_longer() {
    cosines_are_clamped_at_zero(12);
}
