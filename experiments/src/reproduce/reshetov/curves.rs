//! The rational q (figure 6).
use std::f64::consts::FRAC_PI_2;

use specula_golden::exact::formula::consistent::{q, rational_q};

use super::super::claim::{Claim, Ground, Ruling};
use super::super::maximum::{SAMPLES, largest};

fn difference(t: f64) -> f64 {
    q(FRAC_PI_2 * t) - rational_q(FRAC_PI_2 * t)
}

/// The angle of the largest difference, in degrees.
fn place() -> f64 {
    let places = (0..=SAMPLES).map(|k| f64::from(k) / f64::from(SAMPLES));
    90.0 * places.max_by(|a, b| difference(*a).total_cmp(&difference(*b))).unwrap_or(0.0)
}

/// Claims about figure 6.
pub const CLAIMS: [Claim; 3] = [
    Claim {
        what: "q - q~ is below 0.0127",
        quantity: "largest difference",
        on: Ground::Exact,
        expected: (0.012_688_7, 5e-8),
        measure: || largest(difference),
        judge: |error| Ruling::of(error < 0.0127, "it is more"),
    },
    Claim {
        what: "q~ is never above q",
        quantity: "largest q~ - q",
        on: Ground::Exact,
        expected: (0.0, 1e-15),
        measure: || largest(|t| -difference(t)),
        judge: |above| Ruling::of(above < 1e-15, "it is"),
    },
    Claim {
        what: "the difference is largest near 40 degrees, where figure 6 has it",
        quantity: "degrees",
        on: Ground::Exact,
        expected: (40.20, 5e-3),
        measure: place,
        judge: |degrees| Ruling::of((degrees - 40.0).abs() < 1.0, "it is not"),
    },
];
