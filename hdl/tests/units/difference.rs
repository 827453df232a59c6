//! Both forms of D.
use specula_datapath::Design;
use specula_datapath::builder::Vector;
use specula_hdl::units;
use specula_spec::{Format, LyonSpec};

use super::{Bench, cube, dot, lyon, outputs, rounded};

fn vector(bench: &Bench, name: &str, format: Format, limit: i64) -> Vector {
    let component = |axis| bench.input(&format!("{name}_{axis}"), format, (-limit, limit));
    Vector::new(["x", "y", "z"].map(component)).no_longer_than(format.value(limit))
}

fn finish(bench: Bench, d: Vector) -> Design {
    bench.finish(&[("x", d.x), ("y", d.y), ("z", d.z)])
}

fn formats(difference_bits: u32) -> LyonSpec {
    let mut lyon = lyon(3);
    lyon.formats.difference.fraction_bits = difference_bits;
    lyon
}

/// Normals of S1.3 no longer than 1, and vectors near the sphere with the radius `length`.
fn pairs(length: i64) -> Vec<Vec<i64>> {
    let normals = cube(8).filter(|&n| dot(n, n) <= 64);
    let others: Vec<[i64; 3]> = cube(length)
        .filter(|&v| (length * (length - 2)..=length * length).contains(&dot(v, v)))
        .step_by(37)
        .collect();
    normals.flat_map(|n| others.iter().map(move |v| [n, *v].concat())).collect()
}

#[test]
fn cross_products_are_rounded() {
    for difference_bits in [3, 4, 6] {
        let lyon = formats(difference_bits);
        let f = &lyon.formats;
        let bench = Bench::new();
        let (n, h) = (vector(&bench, "n", f.vector, 8), vector(&bench, "h", f.vector_sum(), 16));
        let d = units::halfway_cross_normal(&bench.b, &h, &n, f);
        let design = finish(bench, d);
        let rows = pairs(16);
        for (row, got) in rows.iter().zip(outputs(&design, &rows)) {
            let (n, h) = (&row[..3], &row[3..]);
            let component =
                |a: usize, b: usize| rounded(h[a] * n[b] - h[b] * n[a], 6 - difference_bits);
            assert_eq!(got, [component(1, 2), component(2, 0), component(0, 1)], "{row:?}");
        }
    }
}

/// D = 2(N·V)N - V - L with V = (0, 0, 1), rounded twice; L = -R makes a component 2.0 (extremes
/// row 25).
#[test]
fn reflections_are_rounded_twice() {
    for difference_bits in [3, 5] {
        let lyon = formats(difference_bits);
        let f = &lyon.formats;
        let bench = Bench::new();
        let (n, l) = (vector(&bench, "n", f.vector, 8), vector(&bench, "l", f.vector, 8));
        let v = Vector::new([0, 0, 1].map(|c| bench.b.integer(c)));
        let (d, _) = units::reflection_minus_light(&bench.b, &n, &v, &l, f);
        let design = finish(bench, d);
        let mut rows = pairs(8);
        rows.push(vec![0, 0, 8, 0, 0, -8]);
        let got = outputs(&design, &rows);
        for (row, got) in rows.iter().zip(&got) {
            assert_eq!(got, &reflection(row, difference_bits), "{row:?}");
        }
        assert_eq!(got.last().map(|d| d[2]), Some(2 << difference_bits));
    }
}

fn reflection(row: &[i64], difference_bits: u32) -> Vec<i64> {
    let f = difference_bits;
    // 2 n_z has no more than the 3 bits of n, so rounding to f ≥ 3 bits leaves it as it is.
    let twice = row[2] << (1 + f - 3);
    let eye = [0, 0, 8];
    (0..3).map(|c| rounded(twice * row[c] - ((eye[c] + row[3 + c]) << f), 3)).collect()
}
