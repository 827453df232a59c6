//! Vectors that need no normalisation: the specular base, and vectors wrapped around others.
use glam::DVec3;
use specula_golden::exact::formula::hast::{base, eq33, eq34};
use specula_golden::exact::formula::point_light::{scaled, wrapped_cosine, wrapped_view};
use specula_golden::exact::formula::reflection::{halfway, reflect};
use specula_golden::exact::formula::shape::power;
use specula_golden::exact::formula::wrap;
use specula_scene::frame::EYE;
use specula_spec::FULL_SCALE;

use super::super::claim::{Claim, HALF_LSB, Ruling, exact};
use super::super::maximum::largest;
use crate::stress::draw::{Draw, tilted, turned};

/// Number of random cases.
const CASES: u32 = 200_000;
/// Seed of the cases.
const SEED: u64 = 1;

/// A direction, uniformly distributed on the sphere.
fn direction(draw: &mut Draw) -> DVec3 {
    // Archimedes: heights on a sphere are uniform.
    turned(DVec3::Z, libm::acos(draw.within(-1.0, 1.0)), draw.unit())
}

/// The largest value over normals of any length and lights.
fn largest_over_normals(f: impl Fn(DVec3, DVec3) -> f64) -> f64 {
    let mut draw = Draw::new(SEED, 2);
    (0..CASES)
        .map(|_| f(draw.within(0.05, 3.0) * direction(&mut draw), direction(&mut draw)))
        .fold(0.0, f64::max)
}

/// Among front-facing cases in which the angle from R to V is below `widest` degrees, the share in
/// which the angle from N to H is not below it.
fn farther_halfway(widest: f64) -> f64 {
    let mut draw = Draw::new(SEED, 3);
    let (mut all, mut farther) = (0, 0);
    for _ in 0..CASES {
        let (normal, light) = (direction(&mut draw), direction(&mut draw));
        let alpha = EYE.angle_between(2.0 * normal.dot(light) * normal - light);
        if normal.dot(EYE) > 0.0 && normal.dot(light) > 0.0 && alpha < widest.to_radians() {
            all += 1;
            farther += u32::from(normal.angle_between(halfway(light)) >= alpha);
        }
    }
    f64::from(farther) / f64::from(all)
}

/// The largest angle in degrees by which a normal is wrong that is wrapped around the bisector of a
/// span of `degrees`.
fn wrap_error(degrees: f64) -> f64 {
    let ends = [tilted(-degrees / 2.0), tilted(degrees / 2.0)];
    largest(|t| {
        let normal = ends[0].lerp(ends[1], t);
        wrap::error(libm::atan2(normal.x.abs(), normal.z), normal.length()).abs().to_degrees()
    })
}

/// The largest error in LSBs that twice that angle causes on the flank of a highlight with n = 256.
fn flank_error(degrees: f64) -> f64 {
    let off = 2.0 * wrap_error(degrees).to_radians();
    // The lobe ends long before a radian.
    FULL_SCALE * largest(|angle| power(libm::cos(angle - off), 256) - power(libm::cos(angle), 256))
}

/// The angle in degrees at which the light of a spot leaves, if the spot stands at 60 degrees and
/// at this distance.
fn spot(distance: f64) -> f64 {
    libm::acos(wrapped_cosine(DVec3::Z, distance * tilted(60.0))).to_degrees()
}

/// The same angle if F - P is divided by its length beforehand.
fn scaled_spot(distance: f64) -> f64 {
    let [to_light, _] = scaled([distance * tilted(60.0); 2]);
    libm::acos(wrapped_cosine(DVec3::Z, to_light)).to_degrees()
}

/// The largest difference between V' and the direction to an eye that is up to 89 degrees aside, if
/// F - P is divided by its length beforehand.
fn scaled_view() -> f64 {
    largest(|t| {
        let [to_eye, _] = scaled([10.0 * tilted(89.0 * t); 2]);
        (wrapped_view(to_eye) - tilted(89.0 * t)).length()
    })
}

/// The largest difference between the quotient of (29) and Lambert's cosine of (27)'s vector, with
/// the normal up to 89 degrees from n and of any length.
fn quotient_from_vector() -> f64 {
    let mut draw = Draw::new(SEED, 4);
    let one = |_| {
        let (n, light) = (direction(&mut draw), direction(&mut draw));
        let normal =
            draw.within(0.3, 1.0) * turned(n, draw.within(0.0, 89f64.to_radians()), draw.unit());
        let wrapped =
            wrap::wrap(n, normal).map_or(0.0, |wrapped| wrapped.dot(light).clamp(0.0, 1.0));
        (wrap::diffuse(n, normal, light) - wrapped).abs()
    };
    (0..CASES).map(one).fold(0.0, f64::max)
}

fn equal(off: f64) -> Ruling {
    Ruling::of(off < 1e-12, "they differ")
}

const DIFFUSE: &str =
    "reflection shading is hard to distinguish: diffuse light (half an LSB, 0.11 degrees)";

const fn diffuse(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(DIFFUSE, quantity, expected, measure, |degrees| {
        Ruling::of(
            degrees.to_radians() < HALF_LSB,
            "normals are wrapped too near to n in wide spans",
        )
    })
}

const SPECULAR: &str =
    "reflection shading is hard to distinguish: highlights of n = 256 (half an LSB)";

const fn specular(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(SPECULAR, quantity, expected, measure, |lsb| {
        Ruling::of(lsb < 0.5, "a reflection doubles the error of its normal")
    })
}

const fn closer(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "the angle from N to H is always less than that from R to V",
        quantity,
        expected,
        measure,
        |share| {
            Ruling::of(share == 0.0, "where L and V are more than 90 degrees apart it may be more")
        },
    )
}

const fn narrower(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "a spot by reflection is smaller than by normalisation, so that a smaller n will do",
        quantity,
        expected,
        measure,
        |degrees| {
            if degrees >= 60.0 {
                Ruling::HoldsWithin("|F - P| of 1 and more")
            } else {
                Ruling::DoesNotHold("angles to a nearer light come out smaller, and its spot wider")
            }
        },
    )
}

/// Claims about propositions and remarks.
pub const CLAIMS: [Claim; 17] = [
    exact(
        "the hybrid's quotient is the exact R.V, for N of any length",
        "largest difference",
        (0.0, 1e-13),
        || {
            largest_over_normals(|n, l| {
                (base(n, l) - reflect(n.normalize()).dot(l).clamp(0.0, 1.0)).abs()
            })
        },
        equal,
    ),
    exact(
        "(33) is (17)",
        "largest difference",
        (0.0, 1e-13),
        || largest_over_normals(|n, l| (eq33(n, l) - base(n, l)).abs()),
        equal,
    ),
    exact(
        "(34) is (17)",
        "largest difference",
        (0.0, 1e-13),
        || largest_over_normals(|n, l| (eq34(n, l) - base(n, l)).abs()),
        equal,
    ),
    exact(
        "(29) is Lambert's cosine of (27)",
        "largest difference",
        (0.0, 1e-13),
        quotient_from_vector,
        equal,
    ),
    // Of 50 000 and 4 000 cases that remain; the tolerance is two standard deviations.
    closer("share of random front-facing cases", (0.081, 3e-3), || farther_halfway(180.0)),
    closer("share of those with R less than 20 degrees from V", (0.285, 1.5e-2), || {
        farther_halfway(20.0)
    }),
    diffuse("largest error of the normal in degrees, 10 degrees", (0.0037, 5e-5), || {
        wrap_error(10.0)
    }),
    diffuse("largest error of the normal in degrees, 30 degrees", (0.10, 5e-3), || {
        wrap_error(30.0)
    }),
    diffuse("largest error of the normal in degrees, 60 degrees", (0.85, 5e-3), || {
        wrap_error(60.0)
    }),
    diffuse("largest error of the normal in degrees, 90 degrees", (3.2, 5e-2), || wrap_error(90.0)),
    specular("largest error in LSB, 30 degrees", (8.7, 0.5), || flank_error(30.0)),
    specular("largest error in LSB, 60 degrees", (72.0, 1.0), || flank_error(60.0)),
    specular("largest error in LSB, 90 degrees", (214.0, 1.0), || flank_error(90.0)),
    narrower("degrees that 60 come out at, distance 10", (110.6, 5e-2), || spot(10.0)),
    narrower("degrees that 60 come out at, distance 0.5", (38.0, 0.5), || spot(0.5)),
    exact(
        "scaled to unit length beforehand, a light comes out where it is (our question, not a claim)",
        "degrees that 60 come out at, distance 10",
        (60.0, 1e-9),
        || scaled_spot(10.0),
        |degrees| Ruling::of((degrees - 60.0).abs() < 1e-9, "it is elsewhere"),
    ),
    exact(
        "and so does an eye, by (38)",
        "largest difference, distance 10",
        (0.0, 1e-13),
        scaled_view,
        equal,
    ),
];
