//! The steps of appendix A, from 17 variables to one (figures 11 and 12).
use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use super::super::claim::{Claim, Ruling, exact};
use super::super::figure::{Figure, FigureCurve};
use super::angles::{UNSCALED, shortfall};
use crate::stress::draw::{Draw, turned};

/// Seed of what is drawn.
const SEED: u64 = 2010;
/// Number of triangles that are drawn.
const DRAWN: u32 = 200_000;

/// α_f - α in radians, for normals that lean the same way by `angles` from the face's.
fn difference(angles: [f64; 3], weights: [f64; 3]) -> f64 {
    let normal = |v: usize| DVec3::new(libm::sin(angles[v]), 0.0, libm::cos(angles[v]));
    interpolated(angles, weights) - from_face([0, 1, 2].map(normal), weights)
}

fn interpolated(angles: [f64; 3], weights: [f64; 3]) -> f64 {
    (0..3).map(|v| weights[v] * angles[v]).sum()
}

/// α, the angle between the interpolated normal and the face's, which is z.
fn from_face(normals: [DVec3; 3], weights: [f64; 3]) -> f64 {
    let normal: DVec3 = (0..3).map(|v| weights[v] * normals[v]).sum();
    libm::atan2(normal.truncate().length(), normal.z)
}

/// The derivative of [`difference`] with respect to the middle angle.
fn slope(angles: [f64; 3], weights: [f64; 3]) -> f64 {
    let sum = |f: fn(f64) -> f64| (0..3).map(|v| weights[v] * f(angles[v])).sum::<f64>();
    let (s, c) = (sum(libm::sin), sum(libm::cos));
    let along = c * libm::cos(angles[1]) + s * libm::sin(angles[1]);
    weights[1] * (1.0 - along / (s * s + c * c))
}

/// How much farther from the face's normal the interpolated one is at most, for normals that lean
/// to all sides rather than the same way.
fn leaning_apart() -> f64 {
    let mut draw = Draw::new(SEED, 17);
    let mut excess = || {
        let angles = [(); 3].map(|()| FRAC_PI_2 * draw.unit());
        let normals = angles.map(|angle| turned(DVec3::Z, angle, draw.unit()));
        let weights = draw.weights();
        from_face(normals, weights) - interpolated(angles, weights) + difference(angles, weights)
    };
    (0..DRAWN).map(|_| excess()).fold(0.0, f64::max)
}

/// What the difference comes to for angles in steps of 5 degrees, the middle one between the others,
/// and weights in steps of 1/20.
struct Extremes {
    /// By how much it is at most below what it is for a middle angle equal to either of the others.
    depth: f64,
    /// Where it is least.
    least: f64,
}

fn extremes() -> Extremes {
    let mut found = Extremes { depth: 0.0, least: 0.0 };
    let angle = |step: u32| FRAC_PI_2 * f64::from(step) / 18.0;
    let share = |part: u32| f64::from(part) / 20.0;
    let weights = (0..=20).flat_map(|p| (0..=20 - p).map(move |q| [p, q, 20 - p - q].map(share)));
    let weights: Vec<[f64; 3]> = weights.collect();
    for (low, high) in (0..=18).flat_map(|low| (low..=18).map(move |high| (low, high))) {
        for &weights in &weights {
            let at = |middle: u32| difference([low, middle, high].map(angle), weights);
            let least = (low..=high).map(at).fold(f64::INFINITY, f64::min);
            found.depth = found.depth.max(at(low).min(at(high)) - least);
            found.least = found.least.min(least);
        }
    }
    found
}

/// The angle between two normals, in degrees, at which the difference at a share u of the way is
/// least.
fn least_at(u: f64) -> f64 {
    const STEPS: u32 = 9000;
    let angle = |k: u32| FRAC_PI_2 * f64::from(k) / f64::from(STEPS);
    let at = |k: u32| difference([0.0, angle(k), 0.0], [1.0 - u, u, 0.0]);
    let least = (0..=STEPS).min_by(|a, b| at(*a).total_cmp(&at(*b))).unwrap_or(0);
    angle(least).to_degrees()
}

/// Figures 11 and 12.
pub fn figures() -> Vec<Figure> {
    vec![slopes(), family()]
}

fn slopes() -> Figure {
    let range = (10.0, 80.0);
    let curve = |(colour, share): (usize, f64)| {
        let weights = [(1.0 - share) / 2.0, share, (1.0 - share) / 2.0];
        FigureCurve::formula(
            &format!("b1 = {share}"),
            colour,
            range,
            0.2 + 0.2 * colour as f64,
            move |degrees| slope([10.0, degrees, 80.0].map(f64::to_radians), weights),
        )
    };
    Figure {
        name: "reshetov_figure11",
        title: "Reshetov's figure 11: slopes of the difference, angles of 10 and 80 degrees"
            .to_owned(),
        x: "the third angle in degrees",
        y: "slope of alpha_f - alpha",
        curves: [(0, 0.25), (1, 0.5), (2, 0.75)].map(curve).into(),
        notes: vec![
            "The other two weights are equal. A slope that falls through 0 is a dome's, one that rises through 0 a dip's.".to_owned(),
        ],
    }
}

fn family() -> Figure {
    let curve = |(colour, degrees): (usize, u32)| {
        FigureCurve::formula(&format!("{degrees}"), colour, (0.0, 1.0), 0.76, move |u| {
            -shortfall(f64::from(degrees).to_radians(), u, UNSCALED).to_degrees()
        })
    };
    Figure {
        name: "reshetov_figure12",
        title: "Reshetov's figure 12: the difference between two normals".to_owned(),
        x: "u, share of the way between the normals",
        y: "alpha_f - alpha in degrees",
        curves: [(0, 30), (1, 50), (2, 70), (3, 90)].map(curve).into(),
        notes: vec![
            "For angles of 30 to 90 degrees between the normals. The least is -4.0746 degrees, at u = 0.7614."
                .to_owned(),
        ],
    }
}

const NOT_THERE: &str = "for u below 1/2 no angle makes the difference less than 0, which it is where both normals are one";

/// Claims of appendix A. Numbers of figure 11 are those of a program in Python; those of figure 12 follow from the derivative with respect to the angle,
/// whose sign is that of (1 - 2u)(1 - cos Δ).
pub(super) const CLAIMS: [Claim; 5] = [
    exact(
        "appendix A, 8 to 5: alpha is largest where all normals lean the same way",
        "largest excess elsewhere, in radians",
        (0.0, 1e-12),
        leaning_apart,
        |excess| Ruling::of(excess < 1e-12, "it is larger elsewhere"),
    ),
    exact(
        "figure 11: the difference is monotone or a dome in the third angle, so that it is least at an end",
        "largest depth below both ends, in radians",
        (0.017_669_58, 1e-8),
        || extremes().depth,
        |depth| {
            Ruling::of(
                depth < 1e-12,
                "it can rise, fall and rise again, as for angles of 0, 60 and 90 degrees with weights of .65, .2 and .15",
            )
        },
    ),
    exact(
        "what follows from it holds all the same: no three angles fall short by more than two do",
        "least difference in degrees, angles in steps of 5 degrees",
        (-4.065_051, 1e-6),
        || extremes().least.to_degrees(),
        |degrees| Ruling::of(degrees > -4.0746, "they do"),
    ),
    exact(
        "figure 12: whatever u, the difference is least for normals 90 degrees apart",
        "degrees between the normals, u = 0.9",
        (90.0, 1e-9),
        || least_at(0.9),
        |degrees| Ruling::of(degrees == 90.0, NOT_THERE),
    ),
    exact(
        "figure 12: whatever u, the difference is least for normals 90 degrees apart",
        "degrees between the normals, u = 0.3",
        (0.0, 1e-9),
        || least_at(0.3),
        |degrees| Ruling::of(degrees == 90.0, NOT_THERE),
    ),
];
