//! Surfaces that are sampled on a grid.
use glam::DVec3;

use crate::Facet;
use crate::mesh::Mesh;

/// Vertices on a grid, with their normals.
pub struct Grid {
    /// Cells along the second parameter.
    columns: u32,
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
}

impl Grid {
    /// Samples a surface, given as position and unit normal, at the corners of `rows` times
    /// `columns` cells; the closure is called with the indices of a corner.
    pub fn sample(
        rows: u32,
        columns: u32,
        mut surface: impl FnMut(u32, u32) -> (DVec3, DVec3),
    ) -> Grid {
        let corners = (0..=rows).flat_map(|i| (0..=columns).map(move |j| (i, j)));
        let (positions, normals) = corners.map(|(i, j)| surface(i, j)).unzip();
        Grid { columns, positions, normals }
    }

    /// Appends the grid's triangles to a mesh: two for each cell, without those that have no area,
    /// each with the orientation of its normals.
    pub fn append_to(self, mesh: &mut Mesh) {
        // Levels are bounded, so indices fit.
        let (across, rows) =
            (self.columns + 1, self.positions.len() as u32 / (self.columns + 1) - 1);
        let first = mesh.positions.len() as u32;
        for i in 0..rows {
            for j in 0..self.columns {
                let [a, b] = [i * across + j, i * across + j + 1];
                let [c, d] = [a + across, b + across];
                for triangle in [[a, b, d], [a, d, c]] {
                    if let Some((outward, facet)) = self.outward(triangle) {
                        mesh.facets.push(facet);
                        mesh.triangles.push(outward.map(|k| first + k));
                        mesh.normals.push(outward.map(|k| self.normals[k as usize]));
                    }
                }
            }
        }
        mesh.positions.extend(self.positions);
    }

    /// The triangle, reversed if necessary so that its own normal agrees with its vertex normals;
    /// `None` if it has no area.
    fn outward(&self, triangle: [u32; 3]) -> Option<([u32; 3], Facet)> {
        let facet = Facet::of_polygon(&triangle.map(|k| self.positions[k as usize]))?;
        let normals: DVec3 = triangle.iter().map(|&k| self.normals[k as usize]).sum();
        Some(if facet.normal.dot(normals) >= 0.0 {
            (triangle, facet)
        } else {
            ([triangle[0], triangle[2], triangle[1]], Facet { normal: -facet.normal, ..facet })
        })
    }
}

/// An empty mesh.
pub fn empty() -> Mesh {
    Mesh {
        positions: Vec::new(),
        triangles: Vec::new(),
        normals: Vec::new(),
        facets: Vec::new(),
        materials: Vec::new(),
        material_indices: Vec::new(),
    }
}
