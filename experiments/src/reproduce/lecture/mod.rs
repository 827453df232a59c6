//! The lecture: scan lines and bands, arcs against chords, Newton's root, exercises.
mod bands;
mod edges;
mod exercises;
pub(super) mod highlights;
pub mod increments;
mod packets;
pub mod quadrilateral;

use glam::DVec3;
use specula_golden::exact::formula::direct::{kappa, length_squared};
use specula_golden::exact::formula::newton::lengths;
use specula_golden::exact::formula::slerp::{slerp, weights};
use specula_golden::exact::formula::specular::{fast, textbook};
use specula_spec::FULL_SCALE;

use super::angle::angle_between;
use super::claim::{Claim, HALF_LSB, Ruling, exact};
use super::maximum::largest;
use crate::stress::draw::{tilted, turned};

/// All claims, in the order of the lecture.
pub(super) fn claims() -> Vec<&'static Claim> {
    let groups: [&'static [Claim]; 7] = [
        &quadrilateral::CLAIMS,
        &bands::CLAIMS,
        &highlights::CLAIMS,
        &CLAIMS,
        &edges::CLAIMS,
        &packets::CLAIMS,
        &exercises::CLAIMS,
    ];
    groups.into_iter().flatten().collect()
}

pub use bands::figures;

/// Largest angle in degrees between slerp and the normalised lerp.
fn largest_angle(degrees: f64) -> f64 {
    let ends = [tilted(0.0), tilted(degrees)];
    largest(|t| {
        let [a, b] = weights(degrees.to_radians(), t);
        let (arc, chord) = (a * ends[0] + b * ends[1], ends[0].lerp(ends[1], t));
        angle_between(arc, chord).to_degrees()
    })
}

/// The largest error in LSBs of diffuse light with Newton's root, warm-started from the previous
/// pixel.
fn newton_error(degrees: f64, spans: u32, steps: u32) -> f64 {
    let ends = [tilted(-degrees / 2.0), tilted(degrees / 2.0)];
    let off = |(i, length): (usize, f64)| {
        let normal = ends[0].lerp(ends[1], i as f64 / f64::from(spans)).length();
        (normal / length - 1.0).abs()
    };
    FULL_SCALE * lengths(ends, spans, steps).enumerate().map(off).fold(0.0, f64::max)
}

/// The largest difference between (4.6) with normals of any length and (4.5) with unit normals.
fn any_length() -> f64 {
    largest(|t| {
        let (normal, light) = (turned(DVec3::Z, 1.5 * t, 7.0 * t), turned(DVec3::Z, 3.0 * t, 0.2));
        (fast((0.1 + t) * normal, light) - textbook(normal, light)).abs()
    })
}

/// The largest difference between 1 - κt(1 - t) and N·N for unit normals that are `degrees` apart.
fn square(degrees: f64) -> f64 {
    let ends = [tilted(-degrees / 2.0), tilted(degrees / 2.0)];
    largest(|t| {
        (length_squared([1.0; 2], kappa(ends), t) - ends[0].lerp(ends[1], t).length_squared()).abs()
    })
}

const fn same(what: &'static str, quantity: &'static str, measure: fn() -> f64) -> Claim {
    exact(what, quantity, (0.0, 1e-14), measure, |error| Ruling::of(error < 1e-14, "they differ"))
}

/// The largest angle in degrees between the normals at a triangle's centre along scan lines in
/// three directions, with vertex normals `degrees` apart.
fn spread(degrees: f64) -> f64 {
    // Three normals `degrees` apart about z: sin(degrees/2) = sin(tilt) sin(60).
    let tilt = libm::asin(libm::sin(degrees.to_radians() / 2.0) / libm::sin(60f64.to_radians()));
    let vertices = [0.0, 1.0, 2.0].map(|k| turned(DVec3::Z, tilt, k / 3.0));
    let centre = |apex: usize| {
        let [top, left, right] = [0, 1, 2].map(|k| vertices[(apex + k) % 3]);
        slerp([slerp([top, left], 2.0 / 3.0)?, slerp([top, right], 2.0 / 3.0)?], 0.5)
    };
    let centres: Option<Vec<DVec3>> = (0..3).map(centre).collect();
    let apart = |c: &[DVec3]| {
        [(0, 1), (1, 2), (2, 0)]
            .map(|(a, b)| c[a].angle_between(c[b]))
            .into_iter()
            .fold(0.0, f64::max)
    };
    centres.map_or(f64::NAN, |centres| apart(&centres).to_degrees())
}

const fn difference(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    let what = "arc and chord differ by less than half an LSB of diffuse light (our question, not a claim)";
    exact(what, quantity, expected, measure, |degrees| {
        Ruling::of(degrees.to_radians() < HALF_LSB, "lerp runs unevenly in wide spans")
    })
}

const fn few(
    what: &'static str,
    quantity: &'static str,
    expected: (f64, f64),
    measure: fn() -> f64,
) -> Claim {
    // docs/numerics.md's root has 12 fraction bits, which are worth up to 0.1 LSB.
    exact(what, quantity, expected, measure, |lsb| {
        Ruling::of(lsb < 1.0, "wide short spans jump too far for a warm start")
    })
}

const fn whichever(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "the triangle's scan does not depend on its orientation, by slerp",
        quantity,
        expected,
        measure,
        |degrees| {
            Ruling::of(
                degrees < 1e-6,
                "that is so for lerp, which slerp along edges and scan lines is not",
            )
        },
    )
}

const ONE: &str = "Newton's root needs few steps: one";
const TWO: &str = "Newton's root needs few steps: two";

/// The criterion is half an LSB of diffuse light unless a claim says otherwise.
const CLAIMS: [Claim; 13] = [
    difference("largest angle between them in degrees, span of 10", (0.0049, 5e-5), || {
        largest_angle(10.0)
    }),
    difference("largest angle between them in degrees, span of 30", (0.134, 5e-4), || {
        largest_angle(30.0)
    }),
    difference("largest angle between them in degrees, span of 60", (1.12, 5e-3), || {
        largest_angle(60.0)
    }),
    difference("largest angle between them in degrees, span of 90", (4.07, 5e-3), || {
        largest_angle(90.0)
    }),
    same("(4.6) is (4.5) for N of any length", "largest difference", any_length),
    same(
        "N.N is 1 - kappa t (1 - t) (our extension, not a claim)",
        "largest difference, 150 degrees",
        || square(150.0),
    ),
    few(ONE, "largest error in LSB, 90 degrees in 2 steps of a pixel", (14.6, 0.1), || {
        newton_error(90.0, 2, 1)
    }),
    few(ONE, "largest error in LSB, 90 degrees in 16", (0.49, 0.1), || newton_error(90.0, 16, 1)),
    few(TWO, "largest error in LSB, 90 degrees in 2", (0.41, 0.1), || newton_error(90.0, 2, 2)),
    few(TWO, "largest error in LSB, 150 degrees in 2", (55.0, 0.5), || newton_error(150.0, 2, 2)),
    whichever("degrees between the normals at the centre, 30 degrees", (0.159, 5e-4), || {
        spread(30.0)
    }),
    whichever("degrees between the normals at the centre, 60 degrees", (1.47, 5e-3), || {
        spread(60.0)
    }),
    whichever("degrees between the normals at the centre, 90 degrees", (6.87, 5e-3), || {
        spread(90.0)
    }),
];
