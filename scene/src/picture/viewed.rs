//! Objects in view space.
use glam::{DAffine3, DMat3, DVec3};
use rayon::prelude::*;

use super::coverage::Point;
use super::normal_cones::{Face, VertexFans};
use super::scene::Object;
use super::view::{Mark, View};
use crate::mesh::normals::{direction_of, newell, normal_matrix};
use crate::{Facet, Triangle, VertexCone};

/// The name of an object's triangle, or of a piece of it.
#[derive(Clone, Copy)]
pub(super) struct TriangleId {
    pub object: u32,
    pub triangle: u32,
    /// The number of the piece; 0 where it is whole.
    pub piece: u32,
}

/// An object in view space.
pub(super) struct ViewedObject<'a> {
    object: &'a Object,
    /// Where its materials begin among those of the frame.
    first_material: usize,
    place: DAffine3,
    positions: Vec<DVec3>,
    to_normals: DMat3,
}

impl<'a> ViewedObject<'a> {
    pub fn new(object: &'a Object, first_material: usize, rotation: DMat3) -> ViewedObject<'a> {
        let place = DAffine3::from_mat3(rotation) * object.place;
        let positions = object.mesh.positions.par_iter().map(|&p| place.transform_point3(p));
        let positions = positions.collect();
        let to_normals = normal_matrix(place.matrix3);
        ViewedObject { object, first_material, place, positions, to_normals }
    }

    /// The number of its triangles.
    pub fn triangles(&self) -> usize {
        self.object.mesh.triangles.len()
    }

    /// The corners that triangles use; meshes may have unused vertices.
    pub fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        self.object.mesh.triangles.iter().flatten().map(|&k| self.positions[k as usize])
    }

    /// The corners of a triangle.
    pub fn places(&self, triangle: usize) -> [DVec3; 3] {
        self.object.mesh.triangles[triangle].map(|k| self.positions[k as usize])
    }

    /// Where a view shows its vertices.
    pub fn marks(&self, view: &View) -> Vec<Mark> {
        view.marks(&self.positions)
    }

    /// Where a triangle's corners are among the vertices.
    pub fn indices(&self, triangle: usize) -> [usize; 3] {
        self.object.mesh.triangles[triangle].map(|k| k as usize)
    }

    /// A triangle of the object, turned to the side to which its vertex normals point.
    pub fn face(&self, triangle: usize) -> Face {
        let places = self.places(triangle);
        let own = newell(&places);
        let fallback = own.unwrap_or(DVec3::Z);
        let normals = std::array::from_fn(|v| self.normal(triangle, v).unwrap_or(fallback));
        let turned = |own: DVec3| if own.dot(normals.iter().sum()) < 0.0 { -own } else { own };
        Face { places, normals, own, outward: own.map(turned) }
    }

    /// The faces around the vertices of these triangles.
    pub fn fans(&self, triangles: impl Iterator<Item = usize>) -> VertexFans<'_> {
        let outward = |triangle| self.face(triangle).outward;
        let normal = |triangle, v| {
            let own = || newell(&self.places(triangle)).unwrap_or(DVec3::Z);
            self.normal(triangle, v).unwrap_or_else(own)
        };
        VertexFans::around(triangles, self.object.mesh.vertices(), outward, normal)
    }

    /// The unit normal at a triangle's corner, if it has a direction.
    fn normal(&self, triangle: usize, v: usize) -> Option<DVec3> {
        direction_of(self.to_normals * self.object.mesh.normals[triangle][v])
    }

    /// The triangle as it is shaded, with its normals on the visible side. The view shows it: the name
    /// is one that it gave.
    pub fn triangle(&self, name: TriangleId, fans: &VertexFans, view: &View) -> Triangle {
        let index = name.triangle as usize;
        let face = self.face(index);
        let piece = view.pieces(face.places).into_iter().nth(name.piece as usize);
        let towards_eye = view.towards_eye(face.places[0]);
        let outward = face.outward.unwrap_or_else(|| face.normals.iter().sum());
        let turn = if outward.dot(towards_eye) < 0.0 { -1.0 } else { 1.0 };
        let cones = fans.cones(index, &face);
        Triangle {
            normals: face.normals.map(|n| n * turn),
            facet: self.facet(index, &face, towards_eye),
            positions: face.places,
            outline: piece.as_ref().map(|piece| piece.points.map(Point::in_pixels)),
            perspective: piece.and_then(|piece| piece.perspective),
            cones: cones.map(|cone| VertexCone { axis: cone.axis * turn, ..cone }),
            material: self.first_material + self.object.material_index(index),
        }
    }

    /// The polygon of a triangle, with its normal on the side from which the triangle is seen.
    ///
    /// A mirror reverses the orientation of corners. `to_normals` nevertheless keeps a normal
    /// outside, so the side is determined for the reversed triangle.
    fn facet(&self, triangle: usize, face: &Face, towards_eye: DVec3) -> Facet {
        let facet = self.object.mesh.facets[triangle];
        let side = if self.place.matrix3.determinant() < 0.0 { -1.0 } else { 1.0 };
        let of_triangle = face.own.map(|normal| normal * side);
        let normal =
            direction_of(self.to_normals * facet.normal).or(of_triangle).unwrap_or(DVec3::Z);
        let turn = if of_triangle.unwrap_or(normal).dot(towards_eye) < 0.0 { -1.0 } else { 1.0 };
        Facet { normal: normal * turn, middle: self.place.transform_point3(facet.middle) }
    }
}

/// Objects in view space, each with its materials behind those of the objects before it.
pub(super) fn viewed(objects: &[Object], rotation: DMat3) -> Vec<ViewedObject<'_>> {
    let mut materials = 0;
    let viewed = objects.iter().map(|object| {
        let seen = ViewedObject::new(object, materials, rotation);
        materials += object.materials().len();
        seen
    });
    viewed.collect()
}

/// All corners of triangles.
pub(super) fn corners<'s>(seen: &'s [ViewedObject<'_>]) -> impl Iterator<Item = DVec3> + 's {
    seen.iter().flat_map(ViewedObject::corners)
}

/// The smallest and largest coordinates of all corners, if there are any.
pub(super) fn bounds(seen: &[ViewedObject<'_>]) -> Option<[DVec3; 2]> {
    let of_each = seen.iter().filter_map(|seen| seen.object.mesh.bounds(&seen.positions));
    of_each.reduce(|[a_low, a_high], [b_low, b_high]| [a_low.min(b_low), a_high.max(b_high)])
}

/// The middle of the triangle that is largest in the picture.
pub(super) fn middle_of_largest(seen: &[ViewedObject<'_>], view: &View) -> Option<DVec3> {
    let all = seen.iter().flat_map(|seen| (0..seen.triangles()).map(|t| seen.places(t)));
    let area = |&triangle: &[DVec3; 3]| view.seen_area(triangle);
    let largest = all.max_by(|a, b| area(a).total_cmp(&area(b)))?;
    Some(largest.iter().sum::<DVec3>() / 3.0)
}
