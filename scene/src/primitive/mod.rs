//! Shapes that need no file.
mod grid;
mod icosahedron;
mod sphere;
mod teapot;
mod torus;

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

    /// The same shape, tessellated at `level`.
    ///
    /// # Errors
    /// The range of levels that the shape can have, if `level` is not in it.
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
