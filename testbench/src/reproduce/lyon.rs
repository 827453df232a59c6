//! Lyon, TR 43: shape functions and approximate normalisation.
use specula_golden::exact::normalisation::{g1, g2};
use specula_golden::exact::shape::{f_k, power};

use super::{Claim, largest};

/// The largest difference of f_k from cos^n over 0 to 180 degrees.
fn shape_error(n: u32, k: u32) -> f64 {
    largest(|t| {
        let cosine = libm::cos(std::f64::consts::PI * t);
        // |R - L|² = 2 - 2 cos.
        (f_k(f64::from(n) * (1.0 - cosine), k) - power(cosine, n)).abs()
    })
}

/// How many per cent a normal of length² z falls short of 1 behind a gain.
fn short(z: f64, gain: fn(f64) -> f64) -> f64 {
    100.0 * (1.0 - gain(z) * z.sqrt())
}

/// In units of the paper's full scale or in per cent.
pub const CLAIMS: [Claim; 9] = [
    Claim {
        what: "f_0 is Phong's lobe for n = 1",
        quantity: "largest difference from cos",
        expected: (0.0, 1e-15),
        measure: || shape_error(1, 0),
        holds: |error| error < 1e-15,
    },
    Claim {
        what: "f_2 is cos^4 for n = 4",
        quantity: "largest difference from cos^4",
        expected: (0.0, 1e-14),
        measure: || shape_error(4, 2),
        holds: |error| error < 1e-14,
    },
    Claim {
        what: "k = 2 is visually indistinguishable (half an LSB)",
        quantity: "largest difference from cos^1024",
        expected: (0.0735, 5e-5),
        measure: || shape_error(1024, 2),
        holds: |error| error < 0.5 / 255.0,
    },
    Claim {
        what: "k = 1 is nearer than k = 0 (0.3677)",
        quantity: "largest difference from cos^1024, k = 1",
        expected: (0.1617, 5e-5),
        measure: || shape_error(1024, 1),
        holds: |error| error < shape_error(1024, 0),
    },
    Claim {
        what: "k = 3 is nearer than k = 2",
        quantity: "largest difference from cos^1024, k = 3",
        expected: (0.0350, 5e-5),
        measure: || shape_error(1024, 3),
        holds: |error| error < shape_error(1024, 2),
    },
    Claim {
        what: "g1 is less than 12 % short in a span of 90 degrees",
        quantity: "% short at z = 1/2",
        expected: (11.61, 5e-3),
        measure: || short(0.5, g1),
        holds: |error| error < 12.0,
    },
    Claim {
        what: "g2 is less than 3 % short there",
        quantity: "% short at z = 1/2",
        expected: (2.77, 5e-3),
        measure: || short(0.5, g2),
        holds: |error| error < 3.0,
    },
    Claim {
        what: "g2 is less than 0.5 % off for lengths of 0.8 and more",
        quantity: "largest % off",
        expected: (0.416, 5e-4),
        measure: || largest(|t| short((0.8 + 0.2 * t) * (0.8 + 0.2 * t), g2).abs()),
        holds: |error| error < 0.5,
    },
    Claim {
        what: "g2 overshoots to 1.002 near a length of 0.9",
        quantity: "largest length",
        expected: (1.00176, 5e-6),
        measure: || largest(|z| g2(z) * z.sqrt()),
        holds: |length| (length - 1.002).abs() < 5e-4,
    },
];
