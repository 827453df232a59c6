//! The icosahedron, intentionally coarse: the end normals of its spans are up to 63 degrees apart.
use std::collections::HashMap;

use glam::DVec3;

use crate::Facet;
use crate::mesh::Mesh;

/// The 12 vertices: (0, ±1, ±φ) and its cyclic permutations, normalised; φ is the golden ratio.
fn corners() -> Vec<DVec3> {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let signs = [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)];
    let along = |k: usize| {
        signs.map(|(short, long)| {
            let [x, y, z] = [0.0, short, long * golden];
            [DVec3::new(y, x, z), DVec3::new(z, y, x), DVec3::new(x, z, y)][k].normalize()
        })
    };
    (0..3).flat_map(along).collect()
}

/// The 20 faces: triples of neighbouring vertices, counter-clockwise as seen from outside.
fn faces(corners: &[DVec3]) -> Vec<[u32; 3]> {
    // The cosine of the angle between neighbours is 1/√5; that of the next farther vertices is the
    // negative.
    let near = |a: usize, b: usize| corners[a].dot(corners[b]) > 0.0;
    let mut faces = Vec::with_capacity(20);
    for a in 0..corners.len() {
        for b in a + 1..corners.len() {
            for c in (b + 1..corners.len()).filter(|&c| near(a, b) && near(b, c) && near(c, a)) {
                let outside = corners[a].dot(corners[b].cross(corners[c])) > 0.0;
                let [b, c] = if outside { [b, c] } else { [c, b] };
                faces.push([a, b, c].map(|k| k as u32));
            }
        }
    }
    faces
}

/// The icosahedron with every triangle split into four `level` times, and new vertices moved to the
/// sphere.
pub(super) fn mesh(level: u32) -> Mesh {
    let mut positions = corners();
    let mut triangles = faces(&positions);
    for _ in 0..level {
        triangles = split(&triangles, &mut positions);
    }
    let normals: Vec<[DVec3; 3]> =
        triangles.iter().map(|t| t.map(|k| positions[k as usize])).collect();
    // On the unit sphere a vertex is its own normal; every triangle has an area.
    let facet = |places: &[DVec3; 3]| {
        Facet::of_polygon(places).unwrap_or(Facet::of_vertices(places, places))
    };
    let facets = normals.iter().map(facet).collect();
    Mesh {
        positions,
        triangles,
        normals,
        facets,
        materials: Vec::new(),
        material_indices: Vec::new(),
    }
}

/// Each triangle's four quarters; midpoints are shared between neighbours.
fn split(triangles: &[[u32; 3]], positions: &mut Vec<DVec3>) -> Vec<[u32; 3]> {
    let mut known = HashMap::new();
    let mut middle = |a: u32, b: u32| {
        *known.entry((a.min(b), a.max(b))).or_insert_with(|| {
            positions.push((positions[a as usize] + positions[b as usize]).normalize());
            // There are at most 20 · 4^7 triangles, so indices fit.
            (positions.len() - 1) as u32
        })
    };
    let quarters = |&[a, b, c]: &[u32; 3]| {
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
    };
    triangles.iter().flat_map(quarters).collect()
}
