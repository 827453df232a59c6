//! The two exercises.
use specula_golden::loops::{Exponential, Number};

use super::super::claim::{Claim, Ruling, exact};

/// The largest relative error of e^t for t from 0 to 1 in `steps` steps, by multiplications with
/// the rounded e^(1/steps).
fn drift<T: Number + Into<f64>>(steps: u32) -> f64 {
    let step = f64::from(steps).recip();
    let mut exponential = Exponential::<T>::new(0.0, step);
    let error = |i: u32| {
        let here: f64 = exponential.pixel().into();
        (here / libm::exp(f64::from(i) * step) - 1.0).abs()
    };
    (0..=steps).map(error).fold(0.0, f64::max)
}

const fn exponential(quantity: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    exact(
        "exercise 2: e^t by one multiplication a pixel (its error grows with the pixels: an LSB)",
        quantity,
        expected,
        measure,
        |error| Ruling::of(error < 1.0 / 255.0, "the rounding of e^dt adds up"),
    )
}

/// The exercises as claims; the second's numbers come from the same recurrence in Python, with
/// numbers rounded to 32 bits by `struct`.
pub const CLAIMS: [Claim; 4] = [
    exact(
        "exercise 1: sin 24.3 degrees by lerp from a table",
        "sin 24.3 degrees",
        (0.411_504, 5e-7),
        || 0.7 * 0.40674 + 0.3 * 0.42262,
        |sine| {
            Ruling::of(
                (sine - libm::sin(24.3_f64.to_radians())).abs() < 5e-5,
                "it differs in the table's digits",
            )
        },
    ),
    exponential("largest relative error, 256 pixels, f32", (1.8723e-6, 5e-11), || {
        drift::<f32>(256)
    }),
    exponential("largest relative error, 4096 pixels, f32", (1.2082e-4, 5e-9), || {
        drift::<f32>(4096)
    }),
    exponential("largest relative error, 4096 pixels, f64", (0.0, 1e-12), || drift::<f64>(4096)),
];
