//! A mesh that rays meet.
use glam::DVec3;
use specula_scene::mesh::Mesh;
use specula_scene::picture::coned_faces;

use super::hierarchy::Hierarchy;
use super::mirror::Face;
use super::ray::Ray;

/// What a ray starts above the surface that it comes from, as a share of the mesh's extent: more
/// than coordinates are rounded by, and less than any picture shows.
const ABOVE: f64 = 1e-9;

/// A mesh with what reflection asks of its faces.
pub struct TracedMesh {
    triangles: Vec<[DVec3; 3]>,
    faces: Vec<Face>,
    hierarchy: Hierarchy,
    /// The distance from which on a ray meets triangles.
    nearest: f64,
}

/// A point of the surface that a ray meets.
pub struct Hit<'a> {
    /// The point.
    pub place: DVec3,
    /// The face.
    pub face: &'a Face,
    /// Barycentric weights of the point.
    pub weights: [f64; 3],
}

impl TracedMesh {
    /// Those faces of a mesh that have an area.
    pub fn new(mesh: &Mesh) -> TracedMesh {
        let coned = coned_faces(mesh);
        let triangles: Vec<[DVec3; 3]> = coned.iter().map(|face| face.corners).collect();
        let extent = triangles.iter().flatten().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        TracedMesh {
            faces: coned.iter().map(Face::from).collect(),
            hierarchy: Hierarchy::new(&triangles),
            triangles,
            nearest: extent * ABOVE,
        }
    }

    /// What a ray meets first.
    pub fn hit(&self, ray: Ray) -> Option<Hit<'_>> {
        let (face, crossing) = self.hierarchy.first(&self.triangles, ray, self.nearest)?;
        Some(Hit {
            place: ray.at(crossing.distance),
            face: &self.faces[face],
            weights: crossing.weights,
        })
    }
}
