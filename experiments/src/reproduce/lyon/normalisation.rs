//! The approximate normalisation g1, g2 (figure 4).
use glam::DVec3;
use specula_golden::exact::formula::normalisation::{g1, g2};
use specula_spec::{FULL_SCALE, Method};

use super::super::claim::{Claim, Ground, Ruling};
use super::super::maximum::largest;
use super::super::span_core::{SpanCore, frame, value, vector};
use super::heights::height;
use crate::stress::draw::tilted;
use crate::stress::scene::matt;
use crate::stress::variant::Variant;

/// How many per cent a normal with length² z is too short after it is multiplied by a gain.
fn shortfall(z: f64, gain: fn(f64) -> f64) -> f64 {
    100.0 * (1.0 - gain(z) * z.sqrt())
}

/// Lengths of normals before and after a core's `normalisation` along a span of `degrees`, from its
/// middle to its end.
pub fn core_lengths(normalisation: &str, degrees: f64, steps: u32) -> Option<Vec<(f64, f64)>> {
    let frame =
        frame([tilted(-degrees / 2.0), tilted(degrees / 2.0)], 2 * steps + 1, DVec3::Z, matt())?;
    let table = format!("normalisation = \"{normalisation}\"\nnewton_steps = 0\n");
    let core = SpanCore::new(&frame, &Variant { method: Method::Lyon, table })?;
    let lengths = |i| {
        let trace = core.trace(&frame, i)?;
        Some((value(&trace, "length_squared")?.sqrt(), vector(&trace, "normal")?.length()))
    };
    (steps..=2 * steps).map(lengths).collect()
}

/// How many per cent a core's normal is too short in the middle of a span of 90 degrees.
fn core_short(normalisation: &str) -> f64 {
    core_lengths(normalisation, 90.0, 1).map_or(f64::NAN, |lengths| 100.0 * (1.0 - lengths[0].1))
}

/// Per cent of length that a core's rounding of g and n can cause: 3 units of 2^-17.
const CORE_TOLERANCE: f64 = 3e-3;

const fn g1_short(on: Ground, tolerance: f64, measure: fn() -> f64) -> Claim {
    Claim {
        what: "g1 is less than 12 % short in a span of 90 degrees",
        quantity: "% short at z = 1/2",
        on,
        expected: (11.61, tolerance),
        measure,
        judge: |error| Ruling::of(error < 12.0, "it is more"),
    }
}

const fn g2_short(on: Ground, tolerance: f64, measure: fn() -> f64) -> Claim {
    Claim {
        what: "g2 is less than 3 % short there",
        quantity: "% short at z = 1/2",
        on,
        expected: (2.77, tolerance),
        measure,
        judge: |error| Ruling::of(error < 3.0, "it is more"),
    }
}

const fn overshoot(on: Ground, tolerance: f64, measure: fn() -> f64) -> Claim {
    Claim {
        what: "g2 overshoots to 1.002 near a length of 0.9",
        quantity: "largest length",
        on,
        expected: (1.00176, tolerance),
        measure,
        judge: |length| Ruling::of((length - 1.002).abs() < 5e-4, "it does not"),
    }
}

/// Claims about figure 4.
pub const CLAIMS: [Claim; 8] = [
    g1_short(Ground::Exact, 5e-3, || shortfall(0.5, g1)),
    g1_short(Ground::Core, 5e-3 + CORE_TOLERANCE, || core_short("g1")),
    g2_short(Ground::Exact, 5e-3, || shortfall(0.5, g2)),
    g2_short(Ground::Core, 5e-3 + CORE_TOLERANCE, || core_short("g2")),
    Claim {
        what: "g2 is less than 0.5 % off for lengths of 0.8 and more",
        quantity: "largest % off",
        on: Ground::Exact,
        expected: (0.416, 5e-4),
        measure: || largest(|t| shortfall((0.8 + 0.2 * t) * (0.8 + 0.2 * t), g2).abs()),
        judge: |error| Ruling::of(error < 0.5, "it is more"),
    },
    overshoot(Ground::Exact, 5e-6, || largest(|z| g2(z) * z.sqrt())),
    overshoot(Ground::Core, 1e-2 * CORE_TOLERANCE, || {
        core_lengths("g2", 60.0, 64)
            .map_or(f64::NAN, |lengths| lengths.iter().map(|l| l.1).fold(0.0, f64::max))
    }),
    Claim {
        what: "the overshoot is completely negligible (an LSB)",
        quantity: "LSBs of the peak lost in the middle of a span of 60 degrees, n = 1000",
        on: Ground::Exact,
        expected: (3.7, 5e-2),
        measure: || FULL_SCALE * (1.0 - height(DVec3::Z, g2(0.75) * 0.75_f64.sqrt(), 1000)),
        judge: |lsb| Ruling::of(lsb < 1.0, "it is for n up to 250 only"),
    },
];
