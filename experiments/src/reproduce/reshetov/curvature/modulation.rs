//! Angles that are larger where a surface is convex.
use std::collections::HashMap;
use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use specula_golden::exact::formula::consistent::modulated_cosine;
use specula_scene::mesh::normals::newell;
use specula_scene::{Frame, Triangle, VertexCone};

use super::super::super::angle::angle_between;

/// The frame with the angle of each vertex modulated by how convex its visible triangles are.
pub fn modulated(frame: &Frame) -> Frame {
    let convexity = convexities(&frame.triangles);
    let of_triangle = |triangle: &Triangle| {
        let cone = |v: usize| {
            let convexity = convexity.get(&key(triangle.positions[v])).copied().unwrap_or(0.0);
            let cone = triangle.cones[v];
            VertexCone { cosine: modulated_cosine(cone.cosine, convexity), ..cone }
        };
        Triangle { cones: std::array::from_fn(cone), ..triangle.clone() }
    };
    Frame { triangles: frame.triangles.iter().map(of_triangle).collect(), ..frame.clone() }
}

/// What identifies a vertex: its place, bit by bit, as all triangles around it have it.
type Key = [u64; 3];

fn key(place: DVec3) -> Key {
    // 0 and -0 are the same place.
    place.to_array().map(|x| (x + 0.0).to_bits())
}

/// One of the triangles at an edge.
struct Side {
    normal: DVec3,
    /// The corner that is not on the edge.
    opposite: DVec3,
}

/// How convex a surface is at each vertex: the largest angle between the normals of two triangles
/// at one of its edges, in quarter turns, 0 to 1; edges inwards count for nothing.
fn convexities(triangles: &[Triangle]) -> HashMap<Key, f64> {
    let mut edges: HashMap<[Key; 2], Vec<Side>> = HashMap::new();
    for triangle in triangles {
        let Some(face) = newell(&triangle.positions) else { continue };
        let normal = if face.z < 0.0 { -face } else { face };
        for v in 0..3 {
            let [a, b, opposite] = [v, (v + 1) % 3, (v + 2) % 3].map(|k| triangle.positions[k]);
            let mut ends = [a, b].map(key);
            ends.sort_unstable();
            edges.entry(ends).or_default().push(Side { normal, opposite });
        }
    }
    let mut convexities = HashMap::new();
    for (ends, sides) in edges {
        let [one, other] = &sides[..] else { continue };
        for end in ends {
            let at: &mut f64 = convexities.entry(end).or_default();
            *at = at.max(bend(end, [one, other]));
        }
    }
    convexities
}

/// The angle between two triangles at an edge through `end`, in quarter turns up to 1, if it is
/// convex; else 0.
fn bend(end: Key, [one, other]: [&Side; 2]) -> f64 {
    let place = DVec3::from_array(end.map(f64::from_bits));
    let angle = angle_between(one.normal, other.normal) / FRAC_PI_2;
    let is_convex = one.normal.dot(other.opposite - place) < 0.0;
    if is_convex { angle.min(1.0) } else { 0.0 }
}
