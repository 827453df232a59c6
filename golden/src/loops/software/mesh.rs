//! The connectivity that a renderer receives besides the spans: which corners of triangles are one
//! vertex.
use std::collections::HashMap;

use glam::DVec3;
use specula_scene::Frame;

use crate::loops::Edge;

/// A frame's triangles as a mesh.
///
/// It comes with the frame, as the weights of spans do; loops do not compute it.
#[derive(Clone, Debug)]
pub struct Mesh<'a> {
    /// The frame.
    pub frame: &'a Frame,
    /// Each vertex once.
    pub(super) vertices: Vec<Point>,
    /// The vertices of each triangle.
    pub(super) corners: Vec<[usize; 3]>,
}

/// A point of a surface at which light is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Point {
    /// N, a unit vector; 0 where there is none.
    pub normal: DVec3,
    /// The position in view space.
    pub position: DVec3,
    /// Index into the frame's materials.
    pub material: usize,
}

impl<'a> Mesh<'a> {
    /// The mesh of a frame. Corners with the same normal, position and material are one vertex.
    pub fn of(frame: &'a Frame) -> Mesh<'a> {
        let (mut numbers, mut vertices, mut corners) = (HashMap::new(), Vec::new(), Vec::new());
        for triangle in &frame.triangles {
            corners.push([0, 1, 2].map(|v| {
                let (normal, position) = (triangle.normals[v], triangle.positions[v]);
                let point = Point { normal, position, material: triangle.material };
                *numbers.entry(point.bits()).or_insert_with(|| {
                    vertices.push(point);
                    vertices.len() - 1
                })
            }));
        }
        Mesh { frame, vertices, corners }
    }

    /// The edge of each triangle, before its first line; `None` where weights are not linear in it on
    /// the screen, or where only spans are known.
    pub(super) fn edges(&self) -> impl Iterator<Item = Option<Edge>> {
        self.frame.triangles.iter().map(|triangle| triangle.linear_outline().map(Edge::of_outline))
    }
}

impl Point {
    /// The bits that distinguish points; 0 and -0 are the same number.
    fn bits(&self) -> ([u64; 6], usize) {
        let [[a, b, c], [d, e, f]] = [self.normal, self.position].map(|v| v.to_array());
        ([a, b, c, d, e, f].map(|component| (component + 0.0).to_bits()), self.material)
    }
}
