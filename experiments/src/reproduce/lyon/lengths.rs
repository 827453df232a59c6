//! "Length error sensitivity", and the remaining highlight in the middle of a wide span.
use glam::DVec3;
use specula_golden::exact::formula::normalisation::g2;
use specula_golden::exact::formula::shape::f_k;
use specula_spec::FULL_SCALE;

use super::super::claim::{Claim, Ground, Ruling};
use super::heights::{core_height, height};
use crate::stress::draw::tilted;

/// Half of the angle in degrees of the widest span whose middle normal, if not normalised, is
/// `length` long.
fn half_angle(length: f64) -> f64 {
    libm::acos(length).to_degrees()
}

/// The loss of the peak with a core without normalisation in the middle of a span, where the normal
/// is `length` long, seen from above.
fn core_loss(length: f64, n: u32) -> f64 {
    let half = half_angle(length);
    core_height([tilted(-half), tilted(half)], n, "none").map_or(f64::NAN, |height| 1.0 - height)
}

/// The loss of the peak by an error in the length of N, seen from above.
fn loss(error: f64, n: u32) -> f64 {
    1.0 - height(DVec3::Z, 1.0 - error, n)
}

/// The error in the length of N that costs an LSB of the peak, seen from above. It is found by
/// bisection, since the loss grows with the error.
fn error_for_one_lsb(n: u32) -> f64 {
    let (mut low, mut high) = (0.0, 0.1);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if loss(middle, n) * FULL_SCALE < 1.0 { low = middle } else { high = middle }
    }
    high
}

/// The length of N after g2 in the middle of a span of 90 degrees, where z = 1/2.
fn middle_of_90() -> f64 {
    g2(0.5) * 0.5_f64.sqrt()
}

/// Ends of a span of 90 degrees whose middle normal is `degrees` from the eye.
fn ends_of_90(degrees: f64) -> [DVec3; 2] {
    [1.0, -1.0].map(|side| (tilted(degrees) + side * DVec3::Y).normalize())
}

/// Height of the highlight in the middle of a span of 90 degrees whose normal there is `degrees`
/// from the eye, with n = 1000.
fn mid_span(degrees: f64) -> f64 {
    height(tilted(degrees), middle_of_90(), 1000)
}

/// The same height with a core that has g2 and no Newton step.
fn core_mid_span(degrees: f64) -> f64 {
    core_height(ends_of_90(degrees), 1000, "g2").unwrap_or(f64::NAN)
}

/// Tolerance of a core's f, which has an error of some units of its last place, 2^-14.
const CORE_TOLERANCE: f64 = 0.01;

const ONE_PERCENT: &str = "1 % residual length error is good enough at n = 1000 (5 % of the peak)";

/// What 1 % of the length costs.
const fn one_percent(on: Ground, tolerance: f64, measure: fn() -> f64) -> Claim {
    Claim {
        what: ONE_PERCENT,
        quantity: "share of the peak that f_2 loses to 1 % of |N|",
        on,
        expected: (0.59, tolerance),
        measure,
        judge: five_percent,
    }
}

/// What costs an LSB.
const fn one_lsb(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    Claim {
        what: ONE_PERCENT,
        quantity,
        on: Ground::Exact,
        expected,
        measure,
        judge: |error| Ruling::of(error >= 0.01, "an LSB is lost long before"),
    }
}

fn five_percent(loss: f64) -> Ruling {
    let why = "that is for the length of R. An error e of N makes R wrong by 4e cos(V, N), and costs 8 n e^2 cos^2";
    Ruling::of(loss <= 0.05, why)
}

fn about_a_half(height: f64) -> Ruling {
    let why = "R is 10.9 % short for V at N, and a factor of 2 takes 3.6 %; nearer the horizon it is less short";
    Ruling::of((height - 0.5).abs() < 0.1, why)
}

const fn peak(
    quantity: &'static str,
    on: Ground,
    expected: (f64, f64),
    measure: fn() -> f64,
) -> Claim {
    Claim {
        what: "a span of 90 degrees halves the highlight in its middle, n = 1000, behind g2",
        quantity,
        on,
        expected,
        measure,
        judge: about_a_half,
    }
}

/// The exponent is n = 1000 unless a claim says otherwise.
pub const CLAIMS: [Claim; 18] = [
    Claim {
        what: "the dot product loses 5 % of the peak to an error of 1 in 20 000 of the length of R",
        quantity: "share of the peak that (R.L)^n loses",
        on: Ground::Exact,
        expected: (0.0488, 5e-5),
        measure: || 1.0 - libm::pow(1.0 - 1.0 / 20_000.0, 1000.0),
        judge: |loss| Ruling::of((loss - 0.05).abs() < 0.002, "it does not"),
    },
    Claim {
        what: "the new form loses 5 % to an error of 1 in 100",
        quantity: "share of the peak that f_2 loses",
        on: Ground::Exact,
        // |D| is the error itself.
        expected: (0.0491, 5e-5),
        measure: || 1.0 - f_k(500.0 * 0.01 * 0.01, 2),
        judge: |loss| Ruling::of(loss <= 0.05, "it loses more"),
    },
    Claim {
        what: "the new form loses 5 % to an error of 1 in 100",
        quantity: "share of the peak that f_2 loses where |R| = 2|N|^2 - 1 = 0.99",
        on: Ground::Core,
        expected: (0.0491, 1e-3),
        measure: || core_loss((0.995_f64).sqrt(), 1000),
        judge: |loss| Ruling::of(loss <= 0.05, "it loses more"),
    },
    one_percent(Ground::Exact, 5e-3, || loss(0.01, 1000)),
    one_percent(Ground::Core, CORE_TOLERANCE, || core_loss(0.99, 1000)),
    one_lsb("error of |N| that costs an LSB, n = 256", (1.4e-3, 5e-5), || error_for_one_lsb(256)),
    one_lsb("error of |N| that costs an LSB", (7.0e-4, 5e-6), || error_for_one_lsb(1000)),
    one_lsb("error of |N| that costs an LSB, n = 8000", (2.5e-4, 5e-6), || error_for_one_lsb(8000)),
    Claim {
        what: ONE_PERCENT,
        quantity: "LSBs that 7.0e-4 of |N| cost",
        on: Ground::Core,
        // Two or three units of f's last place are 0.05 LSB.
        expected: (1.0, 0.05),
        measure: || FULL_SCALE * core_loss(1.0 - 7.0e-4, 1000),
        judge: |lsb| Ruling::of(lsb <= 0.5, "it is an LSB, with an error 14 times smaller"),
    },
    peak("height of f_2, V at N", Ground::Exact, (0.0, 1e-15), || mid_span(0.0)),
    peak("height of f_2, V at 35 degrees", Ground::Exact, (0.0, 5e-4), || mid_span(35.0)),
    peak("height of f_2, V at 50 degrees", Ground::Exact, (0.02, 5e-3), || mid_span(50.0)),
    peak("height of f_2, V at 60 degrees", Ground::Exact, (0.15, 5e-3), || mid_span(60.0)),
    peak("height of f_2, V at 75 degrees", Ground::Exact, (0.66, 5e-3), || mid_span(75.0)),
    peak("height of f_2, V at N", Ground::Core, (0.0, 1e-15), || core_mid_span(0.0)),
    peak("height of f_2, V at 50 degrees", Ground::Core, (0.02, CORE_TOLERANCE), || {
        core_mid_span(50.0)
    }),
    peak("height of f_2, V at 60 degrees", Ground::Core, (0.15, CORE_TOLERANCE), || {
        core_mid_span(60.0)
    }),
    peak("height of f_2, V at 75 degrees", Ground::Core, (0.66, CORE_TOLERANCE), || {
        core_mid_span(75.0)
    }),
];
