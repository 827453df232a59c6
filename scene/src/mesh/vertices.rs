//! Which corners of a mesh's triangles are one vertex, and which triangles are around it.
use std::collections::HashMap;

use glam::DVec3;

use super::Mesh;
use super::normals::{direction_of, newell};
use crate::grouped::Grouped;

/// Places count as equal if they agree to within this share of the mesh's extent: corners computed
/// on both sides of a seam do, apart from rounding.
const PLACE: f64 = 1.0 / (1u64 << 32) as f64;

/// Unit normals count as equal if their components agree to within this.
const NORMAL: f64 = 1.0 / (1u64 << 20) as f64;

/// What identifies corners that belong to one vertex with one normal: place and normal, in units of
/// [`PLACE`] and [`NORMAL`].
type Key = [i64; 6];

/// Vertices with one normal, and the triangles around them.
#[derive(Debug)]
pub(crate) struct Vertices {
    /// The vertex at each triangle's corners.
    at_corners: Vec<[u32; 3]>,
    /// Triangles around each vertex, once for each of their corners there.
    around: Grouped,
}

impl Vertices {
    /// Those of a mesh.
    pub fn of(mesh: &Mesh) -> Vertices {
        let positions = || mesh.triangles.iter().flatten().map(|&k| mesh.positions[k as usize]);
        let extent =
            positions().fold(f64::MIN_POSITIVE, |extent, p| extent.max(p.abs().max_element()));
        let mut known: HashMap<Key, u32> = HashMap::with_capacity(mesh.positions.len());
        let corners = (0..mesh.triangles.len()).map(|triangle| {
            keys(mesh, triangle, extent).map(|key| {
                // A mesh has at most three times as many as MAX_TRIANGLES.
                let new = known.len() as u32;
                *known.entry(key).or_insert(new)
            })
        });
        let at_corners: Vec<[u32; 3]> = corners.collect();
        let of_corner = |(triangle, corners): (u32, &[u32; 3])| corners.map(|k| (k, triangle));
        let around = Grouped::new(known.len(), (0..).zip(&at_corners).flat_map(of_corner));
        Vertices { at_corners, around }
    }

    /// The number of triangles.
    pub fn triangles(&self) -> usize {
        self.at_corners.len()
    }

    /// The number of vertices.
    pub fn count(&self) -> usize {
        self.around.groups()
    }

    /// The vertices at a triangle's corners.
    pub fn at_corners(&self, triangle: usize) -> [u32; 3] {
        self.at_corners[triangle]
    }

    /// The triangles around a vertex.
    pub fn around(&self, vertex: u32) -> &[u32] {
        self.around.of(vertex)
    }
}

fn keys(mesh: &Mesh, triangle: usize, extent: f64) -> [Key; 3] {
    let places = mesh.triangles[triangle].map(|k| mesh.positions[k as usize]);
    let own = || newell(&places).unwrap_or(DVec3::Z);
    let raw = |x: f64, unit: f64| (x / unit).round() as i64;
    std::array::from_fn(|v| {
        let normal = direction_of(mesh.normals[triangle][v]).unwrap_or_else(own);
        let [x, y, z] = places[v].to_array().map(|x| raw(x, extent * PLACE));
        let [along_x, along_y, along_z] = normal.to_array().map(|x| raw(x, NORMAL));
        [x, y, z, along_x, along_y, along_z]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Facet;
    use crate::primitive::Primitive;

    /// An octahedron's corners have one normal each for all of their four faces.
    #[test]
    fn faces_are_around_the_vertices_that_they_share() {
        let mesh = Primitive::Sphere { level: 1 }.mesh();
        let vertices = Vertices::of(&mesh);
        assert_eq!((mesh.triangles.len(), vertices.count()), (8, 6));
        for vertex in 0..6 {
            let around = vertices.around(vertex);
            let is_at = |&triangle: &u32| vertices.at_corners(triangle as usize).contains(&vertex);
            assert!(around.len() == 4 && around.is_sorted() && around.iter().all(is_at));
        }
    }

    /// Corners at one place, but for rounding, are one vertex across a seam; with normals of their own
    /// they are vertices of their own.
    #[test]
    fn vertices_are_shared_across_seams_and_not_across_creases() {
        let tilted = DVec3::new(0.6, 0.0, 0.8);
        let normals = vec![[DVec3::Z; 3], [DVec3::Z; 3], [tilted; 3]];
        let corner = |off: f64| [DVec3::new(1.0 + off, 0.5, -0.0), DVec3::Y, DVec3::X * off];
        let positions = [corner(0.0), corner(1e-15), corner(0.0)].concat();
        let facets = vec![Facet { normal: DVec3::Z, middle: DVec3::ZERO }; 3];
        let triangles = vec![[0, 1, 2], [3, 4, 5], [6, 7, 8]];
        let (materials, material_indices) = (vec![], vec![]);
        let mesh = Mesh { positions, triangles, normals, facets, materials, material_indices };
        let vertices = Vertices::of(&mesh);
        let first = |triangle: usize| vertices.at_corners(triangle)[0];
        assert_eq!(vertices.around(first(0)), [0, 1]);
        assert_eq!((first(1), vertices.around(first(2))), (first(0), &[2][..]));
    }
}
