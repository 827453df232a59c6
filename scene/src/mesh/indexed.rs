//! A mesh in memory.
use glam::DVec3;

use crate::{Facet, PartialMaterial};

/// A triangle mesh with unit normals at the corners of its triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Positions of vertices.
    pub positions: Vec<DVec3>,
    /// Triangles as indices of `positions`, counter-clockwise as seen from outside if the file
    /// follows that rule; there is at least one.
    pub triangles: Vec<[u32; 3]>,
    /// Unit normals at each triangle's corners.
    pub normals: Vec<[DVec3; 3]>,
    /// The polygon that each triangle belongs to, with its normal on the side from which the
    /// triangle's corners go counter-clockwise; triangles of one polygon have the same.
    pub facets: Vec<Facet>,
    /// What the file says about its surfaces, in the order of their first use; empty if it says
    /// nothing.
    pub materials: Vec<PartialMaterial>,
    /// The material of each triangle, as an index of `materials`; empty if that is.
    pub material_indices: Vec<u32>,
}
