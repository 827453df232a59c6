//! The bits that figures 7 and 8 propose.
use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use specula_golden::exact::formula::reflection::{reflect, reflection_minus_light};
use specula_golden::exact::formula::shape::f_k;
use specula_spec::{FULL_SCALE, Format, Method};

use super::super::claim::{Claim, Ground, Ruling};
use super::super::span_core::{SpanCore, frame, value};
use crate::operations::lyon::{Datapath, FIGURE_7, FIGURE_8};
use crate::stress::draw::{Draw, turned};
use crate::stress::scene::mirror;
use crate::stress::variant::Variant;

/// Fraction bits of direction vectors in figures 7 and 8.
const FRACTION: Format = Format::signed(1, 10);
/// Number of random directions or spans for a largest error.
const DRAWN: u32 = 20_000;
/// Seed of the random numbers.
const SEED: u64 = 43;

/// Normals in all directions, and eyes up to 90 degrees from them, half of them up to 22 degrees.
fn normals_and_eyes() -> impl Iterator<Item = [DVec3; 2]> {
    let mut draw = Draw::new(SEED, 7);
    (0..DRAWN).map(move |_| {
        let normal = turned(DVec3::Z, libm::acos(draw.within(-1.0, 1.0)), draw.unit());
        let share = draw.unit();
        [normal, turned(normal, FRAC_PI_2 * share * share, draw.unit())]
    })
}

fn rounded(vector: DVec3) -> DVec3 {
    DVec3::from_array(FRACTION.quantise_vector(vector).map(|raw| FRACTION.value(raw)))
}

fn truncated(vector: DVec3) -> DVec3 {
    vector.map(|component| libm::floor(component / FRACTION.ulp()) * FRACTION.ulp())
}

/// The largest difference between a normal and its value rounded to 10 fraction bits.
fn error_of_normal(narrowed: fn(DVec3) -> DVec3) -> f64 {
    normals_and_eyes().map(|[normal, _]| (narrowed(normal) - normal).length()).fold(0.0, f64::max)
}

/// The largest difference between R and its value computed from rounded vectors.
fn error_of_reflection(narrowed: fn(DVec3) -> DVec3) -> f64 {
    let reflect = |normal: DVec3, eye: DVec3| 2.0 * normal.dot(eye) * normal - eye;
    normals_and_eyes()
        .map(|[normal, eye]| (reflect(narrowed(normal), eye) - reflect(normal, eye)).length())
        .fold(0.0, f64::max)
}

/// The largest error in LSBs, before the rounding to 8 bits, of the datapath's f against f_k of
/// true normals: for spans of up to 30 degrees whose middle is up to 70 degrees from the eye, and
/// the light within the lobe of the middle.
fn error_lsb(datapath: &Datapath, n: u32) -> Option<f64> {
    let variant = Variant { method: Method::Lyon, table: datapath.table.to_owned() };
    let mut draw = Draw::new(SEED, n.into());
    let mut frame = frame([DVec3::Z; 2], 3, DVec3::Z, mirror(n))?;
    let core = SpanCore::new(&frame, &variant)?;
    let mut largest: f64 = 0.0;
    for _ in 0..DRAWN {
        let degrees = 30.0 * draw.unit().sqrt();
        let ends = draw.ends(degrees, 70.0);
        let normal = (ends[0] + ends[1]).normalize();
        let light = turned(reflect(normal), 2.0 / f64::from(n).sqrt() * draw.unit(), draw.unit());
        (frame.triangles[0].normals, frame.lights[0].direction) =
            ([ends[0], ends[1], normal], light);
        let shape = value(&core.trace(&frame, 1)?, "colour_r")? / FULL_SCALE;
        let wanted = f_k(
            f64::from(n) / 2.0 * reflection_minus_light(normal, light).length_squared(),
            datapath.squarings,
        );
        largest = largest.max(FULL_SCALE * (shape - wanted).abs());
    }
    Some(largest)
}

const fn angle(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    Claim {
        what: "10 fraction bits keep errors of directions below 0.001 radian",
        quantity,
        on: Ground::Exact,
        expected,
        measure,
        judge: |error| match error {
            error if error < 1e-3 => Ruling::Holds,
            _ => Ruling::DoesNotHold(
                "of N with rounding alone: a truncated N is off by twice as much, and R by four times as much as N",
            ),
        },
    }
}

/// Tolerance: docs/numerics.md's largest errors are those of 60 000 spans seen from any direction
/// with V also rounded, but a core's V is exactly (0, 0, 1). Its errors are a third smaller.
const SAMPLE_TOLERANCE: f64 = 0.4;

const fn figure(
    what: &'static str,
    quantity: &'static str,
    expected: f64,
    measure: fn() -> f64,
) -> Claim {
    Claim {
        what,
        quantity,
        on: Ground::Core,
        expected: (expected, SAMPLE_TOLERANCE * expected),
        measure,
        judge: |lsb| Ruling::of(lsb <= 1.0, "D is too coarse: n D.D makes its last bit large"),
    }
}

const SEVEN: &str = "figure 7's bit counts are plausible (an LSB), spans of 30 degrees";
const EIGHT: &str = "figure 8's bit counts are plausible (an LSB), spans of 30 degrees";

/// Claims about 10 fraction bits, and about figures 7 and 8 with them.
pub const CLAIMS: [Claim; 14] = [
    angle("largest error of N, rounded", (8.3e-4, 2e-5), || error_of_normal(rounded)),
    angle("largest error of N, truncated", (1.65e-3, 4e-5), || error_of_normal(truncated)),
    angle("largest error of R, N rounded", (3.1e-3, 2e-4), || error_of_reflection(rounded)),
    angle("largest error of R, N truncated", (6.3e-3, 4e-4), || error_of_reflection(truncated)),
    figure(SEVEN, "largest error in LSB, n = 16", 3.5, || {
        error_lsb(&FIGURE_7, 16).unwrap_or(f64::NAN)
    }),
    figure(SEVEN, "largest error in LSB, n = 64", 7.7, || {
        error_lsb(&FIGURE_7, 64).unwrap_or(f64::NAN)
    }),
    figure(SEVEN, "largest error in LSB, n = 256", 15.0, || {
        error_lsb(&FIGURE_7, 256).unwrap_or(f64::NAN)
    }),
    figure(SEVEN, "largest error in LSB, n = 1024", 31.0, || {
        error_lsb(&FIGURE_7, 1024).unwrap_or(f64::NAN)
    }),
    figure(SEVEN, "largest error in LSB, n = 8000", 90.0, || {
        error_lsb(&FIGURE_7, 8000).unwrap_or(f64::NAN)
    }),
    figure(EIGHT, "largest error in LSB, m = 4", 4.0, || {
        error_lsb(&FIGURE_8, 4 * 4).unwrap_or(f64::NAN)
    }),
    figure(EIGHT, "largest error in LSB, m = 8", 7.0, || {
        error_lsb(&FIGURE_8, 8 * 8).unwrap_or(f64::NAN)
    }),
    figure(EIGHT, "largest error in LSB, m = 16", 12.6, || {
        error_lsb(&FIGURE_8, 16 * 16).unwrap_or(f64::NAN)
    }),
    figure(EIGHT, "largest error in LSB, m = 32", 23.7, || {
        error_lsb(&FIGURE_8, 32 * 32).unwrap_or(f64::NAN)
    }),
    figure(EIGHT, "largest error in LSB, m = 63", 45.0, || {
        error_lsb(&FIGURE_8, 63 * 63).unwrap_or(f64::NAN)
    }),
];
