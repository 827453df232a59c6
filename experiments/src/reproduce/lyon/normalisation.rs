//! The approximate normalisation g1, g2 (figure 4).
use glam::DVec3;
use specula_golden::exact::normalisation::{g1, g2};
use specula_spec::{FULL_SCALE, Method};

use super::super::claim::{Claim, Ground, Ruling};
use super::super::largest;
use super::super::span_core::{SpanCore, frame, value, vector};
use super::height;
use crate::stress::draw::tilted;
use crate::stress::scene::matt;
use crate::stress::variant::Variant;

/// How many per cent a normal of length² z falls short of 1 behind a gain.
fn short(z: f64, gain: fn(f64) -> f64) -> f64 {
    100.0 * (1.0 - gain(z) * z.sqrt())
}

/// Lengths of normals before and behind a core's `normalisation` along a span of `degrees`, from
/// its middle, of even steps, to its end.
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

/// How many per cent a core's normal is short in the middle of a span of 90 degrees.
fn core_short(normalisation: &str) -> f64 {
    core_lengths(normalisation, 90.0, 1).map_or(f64::NAN, |lengths| 100.0 * (1.0 - lengths[0].1))
}

/// Per cent of length that a core's rounding of g and n can make: 3 units of 2^-17.
const OF_CORE: f64 = 3e-3;

fn below_12(error: f64) -> Ruling {
    Ruling::of(error < 12.0, "it is more")
}

fn below_3(error: f64) -> Ruling {
    Ruling::of(error < 3.0, "it is more")
}

/// Figure 4 and what is said of it.
pub const CLAIMS: [Claim; 8] = [
    Claim {
        what: "g1 is less than 12 % short in a span of 90 degrees",
        quantity: "% short at z = 1/2",
        on: Ground::Exact,
        expected: (11.61, 5e-3),
        measure: || short(0.5, g1),
        judge: below_12,
    },
    Claim {
        what: "g1 is less than 12 % short in a span of 90 degrees",
        quantity: "% short at z = 1/2",
        on: Ground::Core,
        expected: (11.61, 5e-3 + OF_CORE),
        measure: || core_short("g1"),
        judge: below_12,
    },
    Claim {
        what: "g2 is less than 3 % short there",
        quantity: "% short at z = 1/2",
        on: Ground::Exact,
        expected: (2.77, 5e-3),
        measure: || short(0.5, g2),
        judge: below_3,
    },
    Claim {
        what: "g2 is less than 3 % short there",
        quantity: "% short at z = 1/2",
        on: Ground::Core,
        expected: (2.77, 5e-3 + OF_CORE),
        measure: || core_short("g2"),
        judge: below_3,
    },
    Claim {
        what: "g2 is less than 0.5 % off for lengths of 0.8 and more",
        quantity: "largest % off",
        on: Ground::Exact,
        expected: (0.416, 5e-4),
        measure: || largest(|t| short((0.8 + 0.2 * t) * (0.8 + 0.2 * t), g2).abs()),
        judge: |error| Ruling::of(error < 0.5, "it is more"),
    },
    Claim {
        what: "g2 overshoots to 1.002 near a length of 0.9",
        quantity: "largest length",
        on: Ground::Exact,
        expected: (1.00176, 5e-6),
        measure: || largest(|z| g2(z) * z.sqrt()),
        judge: |length| Ruling::of((length - 1.002).abs() < 5e-4, "it does not"),
    },
    Claim {
        what: "g2 overshoots to 1.002 near a length of 0.9",
        quantity: "largest length",
        on: Ground::Core,
        expected: (1.00176, 1e-2 * OF_CORE),
        measure: || {
            core_lengths("g2", 60.0, 64)
                .map_or(f64::NAN, |lengths| lengths.iter().map(|l| l.1).fold(0.0, f64::max))
        },
        judge: |length| Ruling::of((length - 1.002).abs() < 5e-4, "it does not"),
    },
    Claim {
        what: "the overshoot is completely negligible (an LSB)",
        quantity: "LSBs of the peak lost in the middle of a span of 60 degrees, n = 1000",
        on: Ground::Exact,
        expected: (3.7, 5e-2),
        measure: || FULL_SCALE * (1.0 - height(DVec3::Z, g2(0.75) * 0.75_f64.sqrt(), 1000)),
        judge: |lsb| Ruling::of(lsb < 1.0, "it is for n up to 250 only"),
    },
];
