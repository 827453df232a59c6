//! Normals of vertices among the faces around them, and their repair (section 3.2, figure 10).
use glam::DVec3;
use specula_scene::picture::normal_cones::repaired;

use super::super::claim::{Claim, Ruling, exact};
use crate::stress::draw::{Draw, turned};

/// Seed of the fans.
const SEED: u64 = 2010;
/// Number of fans that are drawn of each kind.
const FANS: u32 = 20_000;

/// Whether triangles of a fan may pass through each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// They do not: its edges, as arcs on a sphere around the vertex, do not cross.
    Simple,
    /// They do.
    Crossed,
}

/// The edges from a vertex with `valence` triangles around it, in order.
fn edges(draw: &mut Draw, valence: usize, kind: Kind) -> Vec<DVec3> {
    loop {
        let edges: Vec<DVec3> = (0..valence)
            .map(|_| turned(DVec3::Z, libm::acos(draw.within(-1.0, 1.0)), draw.unit()))
            .collect();
        if kind_of(&edges) == kind {
            return edges;
        }
    }
}

fn kind_of(edges: &[DVec3]) -> Kind {
    let arc = |k: usize| [edges[k], edges[(k + 1) % edges.len()]];
    // Arcs next to each other have an end in common.
    let apart = |i: usize, j: usize| j > i + 1 && (j + 1) % edges.len() != i;
    let pairs = (0..edges.len()).flat_map(|i| (i + 1..edges.len()).map(move |j| (i, j)));
    let crossed = pairs.filter(|&(i, j)| apart(i, j)).any(|(i, j)| cross(arc(i), arc(j)));
    if crossed { Kind::Crossed } else { Kind::Simple }
}

/// Whether two arcs of great circles cross.
fn cross([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> bool {
    let side = |x: DVec3, y: DVec3, z: DVec3| x.dot(y.cross(z)) > 0.0;
    let sides = [side(a, c, b), side(c, b, d), side(b, d, a), side(d, a, c)];
    sides.iter().all(|side| *side == sides[0])
}

/// Unit normals of a fan's triangles.
fn faces(edges: &[DVec3]) -> Vec<DVec3> {
    (0..edges.len())
        .map(|k| edges[k].cross(edges[(k + 1) % edges.len()]).normalize_or_zero())
        .collect()
}

/// Whether some direction is less than 90 degrees from all of the normals: those that are not
/// farther are between the edges of a cone, each of which is perpendicular to two of the normals.
fn is_repairable(normals: &[DVec3]) -> bool {
    let least = |of: DVec3| normals.iter().map(|normal| normal.dot(of)).fold(1.0, f64::min);
    let pairs = (0..normals.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let inside: DVec3 = pairs
        .map(|(i, j)| normals[i].cross(normals[j]).normalize_or_zero())
        .flat_map(|edge| [edge, -edge])
        .filter(|&edge| least(edge) >= -1e-12)
        .sum();
    least(inside) > 0.0
}

/// Share of fans without a normal less than 90 degrees from all of their faces.
fn beyond_repair(valence: usize, kind: Kind) -> f64 {
    let mut draw = Draw::new(SEED, valence as u64);
    let lost = (0..FANS).filter(|_| !is_repairable(&faces(&edges(&mut draw, valence, kind))));
    lost.count() as f64 / f64::from(FANS)
}

/// Share of simple fans that have such a normal, and do not get it by 200 repairs of the mean of
/// their faces' normals.
fn not_repaired(valence: usize, overshoot: f64) -> f64 {
    let mut draw = Draw::new(SEED, valence as u64);
    let is_left = |normals: &[DVec3]| {
        let normal = normals.iter().sum::<DVec3>().normalize_or(DVec3::Z);
        let repaired = repaired(normal, normals.iter().copied(), overshoot);
        normals.iter().any(|face| repaired.dot(*face) < 0.0)
    };
    let left = (0..FANS)
        .map(|_| faces(&edges(&mut draw, valence, Kind::Simple)))
        .filter(|normals| is_repairable(normals) && is_left(normals));
    left.count() as f64 / f64::from(FANS)
}

const EXISTS: &str =
    "a vertex normal 90 degrees or more from a face can always be remedied for valence 3 and 4";
const MORE: &str = "in most cases for more faces";
const GREEDY: &str = "the greedy repair, which is not guaranteed, remedies what can be remedied";

fn always(share: f64) -> Ruling {
    match share {
        0.0 => Ruling::Holds,
        _ => Ruling::HoldsWithin("triangles that do not pass through each other"),
    }
}

fn mostly(share: f64) -> Ruling {
    Ruling::of(share < 0.5, "in most cases it cannot")
}

fn remedied(share: f64) -> Ruling {
    match share {
        0.0 => Ruling::Holds,
        share if share < 0.01 => Ruling::HoldsWithin("a few skinny fans, left by 200 steps"),
        _ => Ruling::DoesNotHold("steps that hardly overshoot do not end within 200"),
    }
}

/// Claims about repair, for edges drawn evenly from all directions. Numbers other than 0 and 1 are
/// those of 50 000 to 100 000 fans in Python, which looks for 0 in tetrahedra of normals; the
/// tolerance is 3 standard deviations of both counts.
///
/// Four normals have none within 90 degrees of all if and only if 0 is a sum of them with positive
/// factors. With edges a, b, c and d, the products with each edge make that the case if abc and acd
/// are of opposite sign as determinants, and abd and bcd too; then a sum of a and d with positive
/// factors is one of b and c, or one of a and b is one of c and d: two of the arcs cross.
pub(super) const CLAIMS: [Claim; 8] = [
    exact(
        EXISTS,
        "share of fans without remedy, valence 3",
        (0.0, 0.0),
        || beyond_repair(3, Kind::Simple),
        always,
    ),
    exact(EXISTS, "the same, valence 4", (0.0, 0.0), || beyond_repair(4, Kind::Simple), always),
    exact(
        EXISTS,
        "the same, valence 4, triangles that pass through each other",
        (1.0, 0.0),
        || beyond_repair(4, Kind::Crossed),
        always,
    ),
    exact(
        MORE,
        "share of fans without remedy, valence 5",
        (0.0, 0.0),
        || beyond_repair(5, Kind::Simple),
        mostly,
    ),
    exact(MORE, "the same, valence 6", (0.2148, 1.1e-2), || beyond_repair(6, Kind::Simple), mostly),
    exact(
        GREEDY,
        "share of valence 3 that is left, epsilon = 1",
        (0.005_56, 1.8e-3),
        || not_repaired(3, 1.0),
        remedied,
    ),
    exact(GREEDY, "the same, valence 4", (0.002_15, 1.1e-3), || not_repaired(4, 1.0), remedied),
    exact(
        GREEDY,
        "the same, valence 4, epsilon = 0.01",
        (0.033_7, 4.2e-3),
        || not_repaired(4, 0.01),
        remedied,
    ),
];
