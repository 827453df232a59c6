//! Lengths of D, and the shape functions of the highlight against cos^n (figure 3).
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

use glam::DVec3;
use specula_golden::exact::formula::differences::{d1, d2, d3};
use specula_golden::exact::formula::distributions::{Formulation, formulation, torrance_sparrow};
use specula_golden::exact::formula::reflection::{halfway, reflect, reflection_minus_light};
use specula_golden::exact::formula::root_shininess;
use specula_golden::exact::formula::shape::{f_k, lobe, power};

use super::super::angle::angle_between;
use super::super::claim::{Claim, HALF_LSB, Ruling, exact};
use super::super::maximum::largest;
use crate::stress::draw::{tilted, turned};

/// |D| where R and L are `angle` radians apart.
fn chord(angle: f64) -> f64 {
    reflection_minus_light(DVec3::Z, tilted(angle.to_degrees())).length()
}

/// f_k where R and L are `angle` radians apart.
pub fn shape(angle: f64, n: u32, k: u32) -> f64 {
    // |R - L|² = 2 - 2 cos.
    f_k(f64::from(n) * (1.0 - libm::cos(angle)), k)
}

/// The power cos^n.
pub fn phong(angle: f64, n: u32) -> f64 {
    power(libm::cos(angle), n)
}

/// The largest difference between f_k and cos^n over 0 to 180 degrees.
fn shape_error(n: u32, k: u32) -> f64 {
    largest(|t| (shape(PI * t, n, k) - phong(PI * t, n)).abs())
}

/// The largest difference between (1 - x/K)^K and cos^n over 0 to 180 degrees, with K factors.
fn lobe_error(n: u32, factors: u32) -> f64 {
    let shape = |angle: f64| lobe(f64::from(n) * (1.0 - libm::cos(angle)), factors);
    largest(|t| (shape(PI * t) - phong(PI * t, n)).abs())
}

const fn any_number(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "K need be no power of two: any K is nearer than K - 1, since (1 - x/K)^K goes to exp(-x)",
        quantity,
        expected,
        measure,
        // K = 2 is off by as much.
        |error| Ruling::of(error < 0.1617, "K = 2 is nearer"),
    )
}

/// The least angle in degrees at which f_k is 0; 180 if there is none.
fn zero(n: u32, k: u32) -> f64 {
    let angles = (0..=18_000).map(|hundredth| f64::from(hundredth) / 100.0);
    // The square or the fourth power of 1e-16, which rounding leaves of a zero, counts as zero.
    angles.into_iter().find(|degrees| shape(degrees.to_radians(), n, k) < 1e-30).unwrap_or(180.0)
}

/// The largest difference between D1·D1 and D2·D2 for normals of this length.
fn d1_from_d2(length: f64) -> f64 {
    let normal = length * DVec3::Z;
    // The eye is along z, so the light is turned.
    largest(|t| {
        let light = tilted(180.0 * t);
        (d1(normal, light).length_squared() - d2(normal, light).length_squared()).abs()
    })
}

/// The largest difference between D1·D1 and D3·D3 + (V·N - L·N)², with the light going round the
/// eye while it goes down.
fn d1_from_d3() -> f64 {
    let normal = turned(DVec3::Z, 1.0, 0.3);
    largest(|t| {
        let light = turned(DVec3::Z, PI * t, 5.0 * t);
        let across = normal.dot(DVec3::Z) - normal.dot(light);
        (d1(normal, light).length_squared() - d3(normal, light).length_squared() - across * across)
            .abs()
    })
}

/// The largest difference between f_1 by figure 8's small squares of m D, m = √n, and (1 - x/2)²
/// with x = n/2 D·D.
fn small_squares(n: u32) -> f64 {
    let normal = turned(DVec3::Z, 0.2, 0.1);
    largest(|t| {
        let d = reflection_minus_light(normal, turned(reflect(normal), 0.2 * t, 3.0 * t));
        (root_shininess::highlight(f64::from(n).sqrt(), d)
            - f_k(f64::from(n) / 2.0 * d.length_squared(), 1))
        .abs()
    })
}

/// The largest difference between Blinn's D2 and his D1, cos^4n of the angle to the half-way
/// vector.
fn gaussian_from_power(n: u32) -> f64 {
    largest(|t| {
        let cosine = libm::cos(FRAC_PI_2 * t);
        (torrance_sparrow(cosine, f64::from(n)) - power(cosine, 4 * n)).abs()
    })
}

/// The height of row 10's glancing highlight: figure 9's first light, with the normal half-way
/// between it and the eye.
fn glancing(n: u32) -> f64 {
    let light = DVec3::new(1.0, 1.0, -1.0).normalize();
    formulation(Formulation::NearlyUnit, n, halfway(light).normalize(), light)
}

/// The largest difference between |D| and 2 sin(α/2), over normals from one horizon to the other.
fn chord_error() -> f64 {
    let light = tilted(50.0);
    largest(|t| {
        let normal = tilted(90.0 * (2.0 * t - 1.0));
        let angle = angle_between(reflect(normal), light);
        (reflection_minus_light(normal, light).length() - 2.0 * libm::sin(angle / 2.0)).abs()
    })
}

const fn row_10(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "row 10 of figure 9 loses the glancing highlight",
        quantity,
        expected,
        measure,
        |height| {
            if height < 0.5 {
                Ruling::Holds
            } else {
                Ruling::HoldsWithin("n of 16 and more: below it the lobe is wide enough")
            }
        },
    )
}

/// Numbers are in units of full scale unless a claim says otherwise.
pub const CLAIMS: [Claim; 27] = [
    exact("|D| is 2 sin(alpha/2)", "largest difference", (0.0, 5e-15), chord_error, |error| {
        Ruling::of(error < 5e-15, "it differs")
    }),
    exact(
        "row 12 (Trowbridge and Reitz) never drops to zero",
        "least height, n = 100",
        (9.802_96e-5, 5e-10),
        || formulation(Formulation::TrowbridgeReitz, 100, DVec3::X, DVec3::Z),
        |height| Ruling::of(height > 0.0, "it does"),
    ),
    exact(
        "|D| is about 1.41 at 90 degrees",
        "|D|",
        (1.41, 5e-3),
        || chord(FRAC_PI_2),
        |length| Ruling::of((length - 1.41).abs() < 5e-3, "it is not"),
    ),
    exact(
        "|D| is 2 at 180 degrees",
        "|D|",
        (2.0, 1e-15),
        || chord(PI),
        |length| Ruling::of((length - 2.0).abs() < 1e-14, "it is not"),
    ),
    exact(
        "f_0 is Phong's lobe for n = 1",
        "largest difference from cos",
        (0.0, 1e-15),
        || shape_error(1, 0),
        |error| Ruling::of(error < 1e-15, "it differs"),
    ),
    exact(
        "f_2 is cos^4 for n = 4",
        "largest difference from cos^4",
        (0.0, 1e-14),
        || shape_error(4, 2),
        |error| Ruling::of(error < 1e-14, "it differs"),
    ),
    exact(
        "f_1 is not 0 before 180 degrees for n = 1",
        "degrees of its zero",
        (180.0, 0.01),
        || zero(1, 1),
        |degrees| Ruling::of(degrees > 179.9, "it is"),
    ),
    exact(
        "f_2 is never 0 for n = 1",
        "f_2 at 180 degrees",
        (0.0625, 1e-15),
        || shape(PI, 1, 2),
        |least| Ruling::of(least > 0.0, "it is"),
    ),
    exact(
        "f_1 is 0 from 60 degrees on for n = 4",
        "degrees of its zero",
        (60.0, 0.01),
        || zero(4, 1),
        |degrees| Ruling::of((degrees - FRAC_PI_3.to_degrees()).abs() < 0.02, "it is not"),
    ),
    exact(
        "f_2 is 0 from 90 degrees on for n = 4",
        "degrees of its zero",
        (90.0, 0.01),
        || zero(4, 2),
        |degrees| Ruling::of((degrees - 90.0).abs() < 0.02, "it is not"),
    ),
    exact(
        "k = 2 is visually indistinguishable (half an LSB)",
        "largest difference from cos^1024",
        (0.0735, 5e-5),
        || shape_error(1024, 2),
        |error| Ruling::of(error < HALF_LSB, "it is 18.8 LSB off on the flank of the lobe"),
    ),
    exact(
        "k = 1 is nearer than k = 0 (0.3677)",
        "largest difference from cos^1024, k = 1",
        (0.1617, 5e-5),
        || shape_error(1024, 1),
        |error| Ruling::of(error < shape_error(1024, 0), "it is not"),
    ),
    exact(
        "k = 3 is nearer than k = 2",
        "largest difference from cos^1024, k = 3",
        (0.0350, 5e-5),
        || shape_error(1024, 3),
        |error| Ruling::of(error < shape_error(1024, 2), "it is not"),
    ),
    // From the formula in Python.
    any_number("largest difference from cos^1024, K = 3", (0.101_18, 5e-6), || lobe_error(1024, 3)),
    any_number("largest difference from cos^1024, K = 64", (0.003_987, 5e-7), || {
        lobe_error(1024, 64)
    }),
    exact(
        "D1 and D2 are equally long",
        "largest difference of D.D, |N| = 1",
        (0.0, 3e-15),
        || d1_from_d2(1.0),
        |error| Ruling::of(error < 3e-15, "they are not"),
    ),
    exact(
        "D1 and D2 are equally long",
        "largest difference of D.D, |N| = 1.01",
        (0.082, 5e-4),
        || d1_from_d2(1.01),
        |error| {
            if error < 3e-15 {
                Ruling::Holds
            } else {
                Ruling::HoldsWithin("what he says: \"ignoring normalization imperfections\"")
            }
        },
    ),
    exact(
        "D1.D1 is D3.D3 + (V.N - L.N)^2, so D3 is never longer",
        "largest difference",
        (0.0, 5e-15),
        d1_from_d3,
        |error| Ruling::of(error < 5e-15, "it differs"),
    ),
    exact(
        "figure 8's squares of m D give the f_1 of n D.D",
        "largest difference, n = 256",
        (0.0, 1e-13),
        || small_squares(256),
        |error| Ruling::of(error < 1e-13, "they differ"),
    ),
    exact(
        "Blinn's D2 is his D1 for large n",
        "largest difference, n = 1",
        (0.050, 5e-4),
        || gaussian_from_power(1),
        |error| Ruling::of(error < HALF_LSB, "n = 1 is not large"),
    ),
    exact(
        "Blinn's D2 is his D1 for large n",
        "largest difference, n = 16",
        (0.0028, 5e-5),
        || gaussian_from_power(16),
        |error| {
            if error < HALF_LSB { Ruling::Holds } else { Ruling::HoldsWithin("an LSB") }
        },
    ),
    exact(
        "Blinn's D2 is his D1 for large n",
        "largest difference, n = 256",
        (0.00018, 5e-6),
        || gaussian_from_power(256),
        |error| Ruling::of(error < HALF_LSB, "they differ"),
    ),
    row_10("its height, n = 1", (0.91, 5e-3), || glancing(1)),
    // This is the peak itself, from which the samples of docs/numerics.md are a little away.
    row_10("its height, n = 4", (0.67, 1e-2), || glancing(4)),
    row_10("its height, n = 16", (0.15, 5e-3), || glancing(16)),
    row_10("its height, n = 64", (0.0, 1e-15), || glancing(64)),
    row_10("its height, n = 256", (0.0, 1e-15), || glancing(256)),
];
