//! Lambert's cosine.
use specula_datapath::builder::Vector;
use specula_hdl::units;

use super::{Bench, cube, dot, lyon, outputs, rounded};

/// Every pair of a normal and some lights in S1.3, both no longer than 1: half of the products are
/// negative and give 0.
#[test]
fn cosines_are_clamped_at_zero() {
    let mut lyon = lyon(3);
    lyon.formats.diffuse.fraction_bits = 4;
    let bench = Bench::new();
    let vector = |name: &str| {
        let component = |axis| bench.input(&format!("{name}_{axis}"), lyon.formats.vector, (-8, 8));
        Vector::new(["x", "y", "z"].map(component)).no_longer_than(1.0)
    };
    let (n, l) = (vector("n"), vector("l"));
    let intensity = units::diffuse(&bench.b, &n, &l, &lyon.formats);
    let design = bench.finish(&[("intensity", intensity)]);

    let within = || cube(8).filter(|&v| dot(v, v) <= 64);
    let lights: Vec<[i64; 3]> = within().filter(|&v| dot(v, v) > 60).step_by(5).collect();
    let rows: Vec<Vec<i64>> =
        within().flat_map(|n| lights.iter().map(move |l| [n, *l].concat())).collect();
    let mut dark = 0;
    for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
        let cosine = dot([row[0], row[1], row[2]], [row[3], row[4], row[5]]);
        dark += usize::from(cosine < 0);
        assert_eq!(got, [rounded(cosine, 2).max(0)], "{row:?}");
    }
    assert!(dark > rows.len() / 3);
}
