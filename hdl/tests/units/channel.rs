//! From intensities to a code.
use specula_datapath::Design;
use specula_datapath::bound::{ErrorBound, ErrorModel};
use specula_datapath::builder::Sig;
use specula_hdl::units::{self, Light};
use specula_spec::Format;

use super::{Bench, outputs};

const ONE: i64 = 16;

/// The three channels of `lights` lights, with coefficients of `U<integer_bits>.6` and intensities
/// of `U1.4`. Rows hold ambient, then diffuse intensity, specular intensity and both coefficients
/// of each light; all channels have the same.
fn design(lights: usize, integer_bits: u32) -> Design {
    design_with(lights, integer_bits, |specular| specular)
}

/// The same, with what is `stated` of specular intensities.
fn design_with(lights: usize, integer_bits: u32, stated: impl Fn(Sig) -> Sig) -> Design {
    let bench = Bench::new();
    let coefficient = Format::unsigned(integer_bits, 6);
    let whole = (0, coefficient.max_raw());
    let grey = |name: &str| {
        let sig = bench.input(name, coefficient, whole);
        [sig.clone(), sig.clone(), sig]
    };
    let ambient = grey("ambient");
    let intensity = |name: String| bench.input(&name, Format::unsigned(1, 4), (0, ONE));
    let light = |i: usize| Light {
        diffuse: intensity(format!("diffuse_{i}")),
        specular: stated(intensity(format!("specular_{i}"))),
        diffuse_coefficients: grey(&format!("kd_{i}")),
        specular_coefficients: grey(&format!("ks_{i}")),
    };
    let lights: Vec<Light> = (0..lights).map(light).collect();
    let [red, green, blue]: [Sig; 3] = units::channels(&bench.b, &bench.slots, &ambient, &lights);
    bench.finish(&[("red", red), ("green", green), ("blue", blue)])
}

fn wanted(row: &[i64]) -> Vec<i64> {
    let lights = row[1..].chunks(4).map(|light| light[0] * light[2] + light[1] * light[3]);
    // Ten fraction bits; half an LSB is 2^9.
    let sum = row[0] * ONE + lights.sum::<i64>();
    vec![((sum + (1 << 9)) >> 10).min(255); 3]
}

fn check(design: &Design, rows: &[Vec<i64>]) {
    for (row, got) in rows.iter().zip(outputs(design, rows)) {
        assert_eq!(got, wanted(row), "{row:?}");
    }
}

/// Round about every half LSB near both ends of the codes.
#[test]
fn codes_are_rounded_and_end_at_255() {
    let near = |lsb: i64| (64 * lsb - 40..=64 * lsb + 40).filter(|a| (0..1 << 14).contains(a));
    let rows: Vec<Vec<i64>> = [0, 1, 128, 254, 255]
        .into_iter()
        .flat_map(near)
        .flat_map(|a| [0, 1, 16].map(|d| vec![a, d, 0, 64, 0]))
        .collect();
    let design = design(1, 8);
    check(&design, &rows);
    let full = [
        vec![255 * 64 + 31, 0, 0, 0, 0],
        vec![254 * 64 + 31, 0, 0, 0, 0],
        vec![254 * 64 + 32, 0, 0, 0, 0],
    ];
    assert_eq!(outputs(&design, &full), [[255; 3], [254; 3], [255; 3]]);
}

/// Every coefficient all ones and every intensity full, with the most lights and the widest
/// coefficients: 255, not wrapped around.
#[test]
fn all_ones_are_white() {
    for (lights, integer_bits) in [(1, 1), (1, 8), (4, 8), (4, 16)] {
        let ones = (1 << (integer_bits + 6)) - 1;
        let row: Vec<i64> =
            std::iter::once(ones).chain([ONE, ONE, ones, ones].repeat(lights)).collect();
        let none = row.iter().map(|_| 0).collect();
        let design = design(lights, integer_bits);
        check(&design, &[row.clone(), none]);
        let white = outputs(&design, &[row])[0].clone();
        assert_eq!(white, [if integer_bits == 1 { 6 } else { 255 }; 3]);
    }
}

/// Where one highlight is off by 1/4 or else both by less, the sum is off by the larger of one and
/// both.
#[test]
fn highlights_that_are_never_off_together_count_once() {
    let bound = |form: ErrorModel| {
        design_with(2, 2, |f| f.override_error("stated", ErrorBound { error: 0.25, model: form }))
            .error_bound()
    };
    let one = bound(ErrorModel::Exclusive { together: 0.0 });
    // A coefficient of U2.6 is 255/64 at most, off by 1/128.
    let most = 255.0 / 64.0 + 1.0 / 128.0;
    for (together, more) in [(0.125, 0.0), (0.2, 2.0 * 0.2 - 0.25), (0.24, 2.0 * 0.24 - 0.25)] {
        let got = bound(ErrorModel::Exclusive { together }) - one;
        assert!((got - most * more).abs() < 1e-9, "{together}: {got} more");
    }
    // Propagation through the products comes to a little less here, since it has the coefficients'
    // own errors apart.
    assert!((bound(ErrorModel::Bounded) - one - most * 0.25).abs() < 0.01);
}
