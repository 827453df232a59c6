//! Angles at vertices and in between: the shortfall of interpolation, and the constants that
//! compensate it.
use std::f64::consts::FRAC_PI_2;

use specula_golden::exact::formula::consistent::{Scaling, cos_gamma, q, rational_q, vertex_angle};

use super::super::claim::{Claim, Ruling, exact};
use super::super::maximum::largest;

/// The angle α at a share u of the way from a vertex with the face's normal to one whose normal is
/// `theta` radians from it.
fn angle_of_face(theta: f64, u: f64) -> f64 {
    libm::atan2(u * libm::sin(theta), 1.0 - u + u * libm::cos(theta))
}

/// Angles that are interpolated as they are.
pub(super) const UNSCALED: Scaling = Scaling { constant: 0.0, exponent: 1 };

/// The shortfall of the interpolated angle in radians, for vertex angles enlarged by `scaling`.
pub(super) fn shortfall(theta: f64, u: f64, scaling: Scaling) -> f64 {
    angle_of_face(theta, u) - u * vertex_angle(libm::cos(theta), scaling)
}

/// The largest shortfall in degrees.
fn largest_shortfall(scaling: Scaling) -> f64 {
    let at = |k: u32| {
        let theta = FRAC_PI_2 * f64::from(k) / 900.0;
        (0..=1000).map(|j| shortfall(theta, f64::from(j) / 1000.0, scaling)).fold(0.0, f64::max)
    };
    (0..=900).map(at).fold(0.0, f64::max).to_degrees()
}

/// How far r enters the face at most, with I grazing it opposite to the normal, so that β = α + 90
/// degrees and n·r = cos(α + γ), with the trigonometric q. Specula's ρ, which is clamped to 1,
/// halves it.
fn entering(scaling: Scaling) -> f64 {
    let at = |k: u32, j: u32| {
        let (theta, u) = (FRAC_PI_2 * f64::from(k) / 450.0, f64::from(j) / 500.0);
        let (true_angle, angle) =
            (angle_of_face(theta, u), (u * vertex_angle(libm::cos(theta), scaling)).min(FRAC_PI_2));
        -libm::cos(true_angle + libm::acos(cos_gamma(q(angle), libm::cos(true_angle + FRAC_PI_2))))
    };
    (1..=450).flat_map(|k| (0..=500).map(move |j| at(k, j))).fold(f64::NEG_INFINITY, f64::max)
}

/// By how much, as an angle, q~ of the interpolated angle exceeds q of the face's angle: r would
/// enter the face.
fn rational_deficit() -> f64 {
    let above = |theta: f64, u: f64| {
        let interpolated = (u * vertex_angle(libm::cos(theta), Scaling::RATIONAL)).min(FRAC_PI_2);
        (rational_q(interpolated) - q(angle_of_face(theta, u))).max(0.0)
    };
    let at = |k: u32| {
        (0..=1000)
            .map(|j| above(FRAC_PI_2 * f64::from(k) / 900.0, f64::from(j) / 1000.0))
            .fold(0.0, f64::max)
    };
    (0..=900).map(at).fold(0.0, f64::max).to_degrees()
}

/// By how many degrees a vertex angle of 45 degrees is enlarged.
fn at_45(scaling: Scaling) -> f64 {
    vertex_angle(0.5_f64.sqrt(), scaling).to_degrees() - 45.0
}

const THIRD_POWER: &str = "what falls short grows as the third power of the angle, what is added as the fifth. With the exponent 1 and 0.06097 nothing is short";

fn none_short(degrees: f64) -> Ruling {
    Ruling::of(degrees < 1e-9, THIRD_POWER)
}

/// Claims about inequality 5, equation 6 and its constants.
pub const CLAIMS: [Claim; 7] = [
    exact(
        "without scaling the interpolated angle falls short by less than 4.075 degrees",
        "largest shortfall in degrees",
        (4.07457, 5e-5),
        || largest(|u| shortfall(FRAC_PI_2, u, UNSCALED)).to_degrees(),
        |degrees| Ruling::of(degrees < 4.075, "it is more"),
    ),
    exact(
        "0.03632 suffices for q~, which makes up for some",
        "degrees beyond what q~ < q makes up",
        (0.0, 1e-9),
        rational_deficit,
        none_short,
    ),
    exact(
        "0.06096 suffices for q, with the exponent 2 as printed",
        "largest shortfall in degrees",
        // docs/numerics.md truncated its digits.
        (0.42, 1e-2),
        || largest_shortfall(Scaling::TRIGONOMETRIC),
        none_short,
    ),
    exact(
        "0.06096 suffices for q, with the exponent 2 as printed",
        "how far r enters the face",
        (0.0085, 5e-4),
        || entering(Scaling::TRIGONOMETRIC),
        |depth| Ruling::of(depth < 1e-9, THIRD_POWER),
    ),
    exact(
        "0.06097 suffices for q, with the exponent 1 (our constant, not a claim)",
        "largest shortfall in degrees",
        (0.0, 1e-9),
        || largest_shortfall(Scaling::TRIGONOMETRIC_LINEAR),
        none_short,
    ),
    exact(
        "vertex angles of 45 degrees are enlarged by less than 0.3 degrees (q)",
        "degrees",
        (0.235, 5e-4),
        || at_45(Scaling::TRIGONOMETRIC),
        |degrees| Ruling::of(degrees < 0.3, "it is more"),
    ),
    exact(
        "vertex angles of 45 degrees are enlarged by less than 0.3 degrees (q~)",
        "degrees",
        (0.140, 5e-4),
        || at_45(Scaling::RATIONAL),
        |degrees| Ruling::of(degrees < 0.3, "it is more"),
    ),
];
