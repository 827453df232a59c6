//! Faces of whole meshes.
use glam::{DAffine3, DMat3, DVec3};

use super::scene::Object;
use super::viewed::ViewedObject;
use crate::mesh::Mesh;
use crate::{PartialMaterial, VertexCone};

/// A triangle of a mesh among its neighbours.
#[derive(Clone, Debug, PartialEq)]
pub struct ConedFace {
    /// Its corners.
    pub corners: [DVec3; 3],
    /// Its unit normal, on the side to which its vertex normals point.
    pub outward: DVec3,
    /// Unit normals at its vertices.
    pub normals: [DVec3; 3],
    /// Cones about the normals.
    pub cones: [VertexCone; 3],
}

/// The triangles of a whole mesh that have an area, with the cones of their vertices.
pub fn coned_faces(mesh: &Mesh) -> Vec<ConedFace> {
    let object = Object {
        mesh: mesh.clone().into(),
        primitive: None,
        place: DAffine3::IDENTITY,
        material: PartialMaterial::default(),
    };
    let seen = ViewedObject::new(&object, 0, DMat3::IDENTITY);
    let all = 0..mesh.triangles.len();
    let fans = seen.fans(all.clone());
    let coned = |triangle: usize| {
        let face = seen.face(triangle);
        Some(ConedFace {
            corners: face.places,
            outward: face.outward?,
            normals: face.normals,
            cones: fans.cones(triangle, &face),
        })
    };
    all.filter_map(coned).collect()
}
