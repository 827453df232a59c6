//! Shapes that need no file.
mod icosahedron;
mod sphere;
mod teapot;
mod torus;

use glam::DVec3;

use crate::Facet;
use crate::mesh::Mesh;

/// A built-in shape, y up, with its parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Primitive {
    /// Newell's teapot of 32 bicubic patches, 3.15 high, standing on y = 0; `level` cells along
    /// each patch edge.
    Teapot {
        /// 1 to 64.
        level: u32,
    },
    /// The unit sphere, poles on the y axis: 4 `level` cells around and 2 `level` from pole to
    /// pole.
    Sphere {
        /// 1 to 256.
        level: u32,
    },
    /// A torus around the y axis, radius 1 to the tube's middle: 4 `level` cells around and 2
    /// `level` around the tube.
    Torus {
        /// 2 to 256.
        level: u32,
        /// Radius of the tube, above 0 and below 1.
        tube: f64,
    },
    /// The icosahedron in the unit sphere with normals shared at vertices; each level splits every
    /// triangle in four.
    Icosahedron {
        /// 0 to 7.
        level: u32,
    },
}

/// Names of the shapes, as scene files have them.
pub const NAMES: [&str; 4] = ["teapot", "sphere", "torus", "icosahedron"];

impl Primitive {
    /// The shape with that name and its default parameters.
    pub fn by_name(name: &str) -> Option<Primitive> {
        match name {
            "teapot" => Some(Primitive::Teapot { level: 12 }),
            "sphere" => Some(Primitive::Sphere { level: 16 }),
            "torus" => Some(Primitive::Torus { level: 16, tube: 0.4 }),
            "icosahedron" => Some(Primitive::Icosahedron { level: 0 }),
            _ => None,
        }
    }

    /// The same shape, tessellated at `level`; the error is the range of its levels.
    pub fn at_level(self, level: u32) -> Result<Primitive, std::ops::RangeInclusive<u32>> {
        let (range, shape) = match self {
            Primitive::Teapot { .. } => (1..=64, Primitive::Teapot { level }),
            Primitive::Sphere { .. } => (1..=256, Primitive::Sphere { level }),
            Primitive::Torus { tube, .. } => (2..=256, Primitive::Torus { level, tube }),
            Primitive::Icosahedron { .. } => (0..=7, Primitive::Icosahedron { level }),
        };
        if range.contains(&level) { Ok(shape) } else { Err(range) }
    }

    /// The shape's triangles, counter-clockwise seen from outside, and its exact normals.
    ///
    /// Levels outside the stated ranges are clamped.
    pub fn mesh(self) -> Mesh {
        match self {
            Primitive::Teapot { level } => teapot::mesh(level.clamp(1, 64)),
            Primitive::Sphere { level } => sphere::mesh(level.clamp(1, 256)),
            Primitive::Torus { level, tube } => torus::mesh(level.clamp(2, 256), tube),
            Primitive::Icosahedron { level } => icosahedron::mesh(level.min(7)),
        }
    }
}

/// Vertices on a grid, with their normals.
struct Grid {
    /// Cells along the second parameter.
    columns: u32,
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
}

impl Grid {
    /// Samples a surface, given as position and unit normal, at the corners of `rows` times
    /// `columns` cells; the closure is called with the indices of a corner.
    fn sample(
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
    fn append_to(self, mesh: &mut Mesh) {
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
fn empty() -> Mesh {
    Mesh { positions: Vec::new(), triangles: Vec::new(), normals: Vec::new(), facets: Vec::new() }
}
