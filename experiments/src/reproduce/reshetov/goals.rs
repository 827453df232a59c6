//! The seven goals of section 2.1, with the trigonometric q and with the rational one.
use std::f64::consts::{FRAC_PI_2, PI};

use glam::DVec3;
use specula_golden::exact::formula::consistent::{
    Scaling, cos_gamma, cosine, normal, pixel_angle, q, rational_q, reflection, vertex_angle,
};
use specula_golden::exact::method::consistent::consistent_cosine;
use specula_scene::picture::{ConedFace, coned_faces};
use specula_scene::primitive::Primitive;

use super::super::angle::angle_between;
use super::super::claim::{Claim, Ground, Ruling, exact};
use super::super::maximum::largest;
use crate::stress::draw::{tilted, turned};

/// The largest value of `f` over angles α from 0 to 90 degrees, and over t from 0 to 1 for whatever
/// else varies.
fn largest_over(f: impl Fn(f64, f64) -> f64) -> f64 {
    const STEPS: u32 = 200;
    let share = |k: u32| f64::from(k) / f64::from(STEPS);
    let at = |k: u32| {
        (0..=STEPS).map(|j| f(FRAC_PI_2 * share(k), share(j))).fold(f64::NEG_INFINITY, f64::max)
    };
    (0..=STEPS).map(at).fold(f64::NEG_INFINITY, f64::max)
}

/// The larger result of the two curves.
fn by_both(measure: impl Fn(fn(f64) -> f64) -> f64) -> f64 {
    f64::max(measure(q), measure(rational_q))
}

/// The largest jump of r where two faces of a mesh meet.
fn jump(mesh: Primitive, curve: fn(f64) -> f64, scaling: Scaling) -> f64 {
    let faces = coned_faces(&mesh.mesh());
    let pairs = faces
        .iter()
        .enumerate()
        .flat_map(|(k, one)| faces[k + 1..].iter().map(move |other| (one, other)));
    pairs.filter_map(|(one, other)| jump_between(one, other, curve, scaling)).fold(0.0, f64::max)
}

/// The largest jump between two faces; `None` if they have no edge in common. Vertices with the
/// same normal count as one.
fn jump_between(
    one: &ConedFace,
    other: &ConedFace,
    curve: fn(f64) -> f64,
    scaling: Scaling,
) -> Option<f64> {
    let same = |a: usize, b: usize| (one.normals[a] - other.normals[b]).length() < 1e-9;
    let shared: Vec<[usize; 2]> =
        (0..3).flat_map(|a| (0..3).map(move |b| [a, b])).filter(|&[a, b]| same(a, b)).collect();
    let [first, second] = shared[..] else { return None };
    let along = |face: &ConedFace, [a, b]: [usize; 2], t: f64| {
        let weights: [f64; 3] = std::array::from_fn(|v| {
            if v == a {
                1.0 - t
            } else if v == b {
                t
            } else {
                0.0
            }
        });
        let angles = face.cones.map(|cone| vertex_angle(cone.cosine, scaling));
        let normal: DVec3 = (0..3).map(|v| weights[v] * face.normals[v]).sum();
        reflection(normal.normalize(), DVec3::Z, curve(pixel_angle(angles, weights)))
    };
    let jump = |t: f64| {
        (along(one, [first[0], second[0]], t) - along(other, [first[1], second[1]], t)).length()
    };
    Some((0..=16).map(|k| jump(f64::from(k) / 16.0)).fold(0.0, f64::max))
}

/// How far r points into a face at most, at a single point: the interpolated normal is at α from
/// the face's, and I anywhere in front of the face.
fn depth_into_face(curve: fn(f64) -> f64) -> f64 {
    largest_over(|alpha, t| {
        let normal = tilted(alpha.to_degrees());
        let heights = (0..=24).map(|azimuth| {
            let incoming = turned(DVec3::Z, FRAC_PI_2 * t, f64::from(azimuth) / 24.0);
            -reflection(normal, incoming, curve(alpha)).z
        });
        heights.fold(f64::NEG_INFINITY, f64::max)
    })
}

/// cos γ for β = t (α + 90 degrees).
fn along_beta(curve: fn(f64) -> f64, alpha: f64, t: f64) -> f64 {
    cos_gamma(curve(alpha), libm::cos(t * (alpha + FRAC_PI_2)))
}

/// By how much cos γ at the largest β exceeds sin α, where r lies in the face.
fn above_least(curve: fn(f64) -> f64) -> f64 {
    largest(|t| along_beta(curve, FRAC_PI_2 * t, 1.0) - libm::sin(FRAC_PI_2 * t))
}

/// The largest difference between N_c·I and |I + r|/2, with I in front of the interpolated normal.
fn half_length(curve: fn(f64) -> f64) -> f64 {
    largest_over(|alpha, t| {
        let (n, incoming) = (tilted(alpha.to_degrees()), tilted(alpha.to_degrees() - 89.0 * t));
        let reflected = reflection(n, incoming, curve(alpha));
        let of_vector = normal(incoming, reflected).map_or(0.0, |n_c| n_c.dot(incoming));
        (of_vector - cosine(incoming, reflected)).abs()
    })
}

/// The cosine that light from 1 degree behind a face has with a normal 30 degrees from the face's,
/// towards the light: Phong's, or the consistent normal's.
fn behind(cosine_of: fn(DVec3, DVec3) -> f64) -> f64 {
    cosine_of(DVec3::Z, tilted(91.0 - LEAN))
}

/// Degrees between a face's normal and the interpolated one.
const LEAN: f64 = 30.0;

fn of_consistent(normal: DVec3, incoming: DVec3) -> f64 {
    consistent_cosine(normal, rational_q(LEAN.to_radians()), incoming)
}

/// The largest angle in degrees between an incoming direction and what comes back along the reverse
/// of its path.
fn reversed() -> f64 {
    let q = rational_q(LEAN.to_radians());
    largest(|t| {
        let incoming = tilted((90.0 - LEAN) * (2.0 * t - 1.0));
        let back = reflection(DVec3::Z, reflection(DVec3::Z, incoming, q), q);
        angle_between(back, incoming).to_degrees()
    })
}

const NO_CULLING: &str =
    "3.3: light from behind a face may have a positive product with the normal, also Phong's";

const fn behind_face(quantity: &'static str, expected: f64, measure: fn() -> f64) -> Claim {
    exact(NO_CULLING, quantity, (expected, 5e-6), measure, |cosine| {
        Ruling::of(cosine > 0.0, "it has none")
    })
}

const fn goal(what: &'static str, quantity: &'static str, measure: fn() -> f64) -> Claim {
    // docs/numerics.md has all of them to 1e-15, with numbers up to 4.
    Claim {
        what,
        quantity,
        on: Ground::Exact,
        expected: (0.0, 4e-15),
        measure,
        judge: |off| Ruling::of(off < 4e-15, "it is more"),
    }
}

/// Claims about the goals; one number for both curves where both reach it.
pub const CLAIMS: [Claim; 13] = [
    goal(
        "goal 1: r is continuous across edges",
        "largest jump between faces of an icosahedron",
        || {
            let mesh = Primitive::Icosahedron { level: 0 };
            f64::max(
                jump(mesh, q, Scaling::TRIGONOMETRIC_LINEAR),
                jump(mesh, rational_q, Scaling::RATIONAL),
            )
        },
    ),
    goal("goal 2: f grows with b", "how far its slope q is below 0", || {
        by_both(|curve| largest(|t| -curve(FRAC_PI_2 * t)))
    }),
    goal("goal 3: r never points into the surface", "how far it does", || by_both(depth_into_face)),
    goal("goal 4: 0 <= f <= 1", "how far f is outside", || {
        by_both(|curve| {
            largest_over(|alpha, t| {
                let f = along_beta(curve, alpha, t);
                f64::max(-f, f - 1.0)
            })
        })
    }),
    goal("goal 5: f = b where all normals are the face's", "largest difference", || {
        by_both(|curve| {
            largest(|t| (cos_gamma(curve(0.0), libm::cos(PI * t)) - libm::cos(PI * t)).abs())
        })
    }),
    goal(
        "goal 6: seen along the normal, the consistent one is Phong's",
        "largest difference of f from 1",
        || by_both(|curve| largest(|t| (cos_gamma(curve(FRAC_PI_2 * t), 1.0) - 1.0).abs())),
    ),
    goal(
        "goal 7: f is least where I lies in the face, with r in it too (q)",
        "f there less sin(alpha)",
        || above_least(q),
    ),
    Claim {
        what: "goal 7: the same (q~)",
        quantity: "f there less sin(alpha)",
        on: Ground::Exact,
        expected: (0.0212, 5e-5),
        measure: || above_least(rational_q),
        judge: |above| match above {
            above if above < 4e-15 => Ruling::Holds,
            _ => Ruling::HoldsWithin("0.0212: r stays a little outside the face there"),
        },
    },
    goal("(8): N_c.I is |I + r|/2", "largest difference", || by_both(half_length)),
    behind_face("N.L, 1 degree behind a face 30 degrees from N", 0.484_81, || behind(DVec3::dot)),
    behind_face("the same of N_c.L (q~)", 0.678_97, || behind(of_consistent)),
    exact(
        "3.3: which is usually not noticed, as the product is very small then",
        "the larger of the two",
        (0.678_97, 5e-6),
        || f64::max(behind(DVec3::dot), behind(of_consistent)),
        |cosine| Ruling::of(cosine < 0.1, "it is large where a face leans far from its normals"),
    ),
    exact(
        "3.3: the reverse of a path of light is another path",
        "largest angle between both in degrees, face 30 degrees from N (q~)",
        (41.4737, 5e-4),
        reversed,
        |degrees| Ruling::of(degrees > 0.0, "it is the same"),
    ),
];
