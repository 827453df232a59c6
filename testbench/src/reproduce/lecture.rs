//! The lecture: arcs against chords.
use specula_golden::exact::slerp::weights;

use super::super::stress::draw::tilted;
use super::{Claim, largest};

/// Largest angle in degrees between slerp and the normalised lerp.
fn apart(degrees: f64) -> f64 {
    let ends = [tilted(0.0), tilted(degrees)];
    largest(|t| {
        let [a, b] = weights(degrees.to_radians(), t);
        let (arc, chord) = (a * ends[0] + b * ends[1], ends[0].lerp(ends[1], t));
        libm::atan2(arc.cross(chord).length(), arc.dot(chord)).to_degrees()
    })
}

const fn difference(what: &'static str, expected: (f64, f64), measure: fn() -> f64) -> Claim {
    Claim { what, quantity: "largest angle between them in degrees", expected, measure, holds: |angle| angle < 0.5 / 255.0 * 57.3 }
}

/// By the criterion of half an LSB of diffuse light.
pub const CLAIMS: [Claim; 4] = [
    difference(
        "arc and chord differ by less than half an LSB of diffuse light: 10 degrees (our question, not a claim)",
        (0.0049, 5e-5),
        || apart(10.0),
    ),
    difference(
        "arc and chord differ by less than half an LSB of diffuse light: 30 degrees (our question, not a claim)",
        (0.134, 5e-4),
        || apart(30.0),
    ),
    difference(
        "arc and chord differ by less than half an LSB of diffuse light: 60 degrees (our question, not a claim)",
        (1.12, 5e-3),
        || apart(60.0),
    ),
    difference(
        "arc and chord differ by less than half an LSB of diffuse light: 90 degrees (our question, not a claim)",
        (4.07, 5e-3),
        || apart(90.0),
    ),
];
