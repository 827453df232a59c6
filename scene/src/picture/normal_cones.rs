//! Cones about vertex normals that contain the normals of all faces around the vertex [Reshetov,
//! Soupikov and Mark; methods D].
use glam::DVec3;
use rayon::prelude::*;

use crate::VertexCone;
use crate::mesh::Vertices;

/// Repair is given up after this many reflections; 2 of 19 000 random fans were not repaired then
/// (extremes row 48).
const MAX_REFLECTIONS: usize = 200;

/// A triangle, with what cones need.
pub(super) struct Face {
    /// Its corners.
    pub places: [DVec3; 3],
    /// Unit normals at the corners.
    pub normals: [DVec3; 3],
    /// Its own unit normal, on the side from which its corners go counter-clockwise; `None` for a
    /// triangle without area.
    pub own: Option<DVec3>,
    /// The same on the side to which the normals at the corners point.
    pub outward: Option<DVec3>,
}

/// The cones of vertices, and the faces around them.
pub(super) struct VertexFans<'m> {
    vertices: &'m Vertices,
    /// The normal of each triangle that is around one of them, as in [`Face`].
    outward: Vec<Option<DVec3>>,
    /// For each of them the normal at one of its corners, and the cone about that.
    cones: Vec<Option<(DVec3, VertexCone)>>,
}

impl<'m> VertexFans<'m> {
    /// The fans around the corners of some triangles. `outward` gives the own normal of any triangle,
    /// `normal` that at one of its corners.
    pub fn around(
        triangles: impl Iterator<Item = usize>,
        vertices: &'m Vertices,
        outward: impl Fn(usize) -> Option<DVec3> + Sync,
        normal: impl Fn(usize, usize) -> DVec3 + Sync,
    ) -> VertexFans<'m> {
        let mut is_around = vec![false; vertices.triangles()];
        let mut first_corners = vec![None; vertices.count()];
        for triangle in triangles {
            for (v, vertex) in (0..3).zip(vertices.at_corners(triangle)) {
                let first = &mut first_corners[vertex as usize];
                if first.is_none() {
                    *first = Some((triangle as u32, v));
                    let around = vertices.around(vertex).iter();
                    around.for_each(|&triangle| is_around[triangle as usize] = true);
                }
            }
        }
        let own = |(triangle, &is_around): (usize, &bool)| {
            if is_around { outward(triangle) } else { None }
        };
        let outward = is_around.par_iter().enumerate().map(own).collect();
        let fans = VertexFans { vertices, outward, cones: vec![] };
        let cone = |(vertex, first): (usize, &Option<(u32, u32)>)| {
            let normal = first.map(|(triangle, v)| normal(triangle as usize, v as usize))?;
            Some((normal, fans.cone(vertex as u32, normal)))
        };
        let cones = first_corners.par_iter().enumerate().map(cone).collect();
        VertexFans { cones, ..fans }
    }

    /// The cones at the corners of a triangle, of which the face is given.
    pub fn cones(&self, triangle: usize, face: &Face) -> [VertexCone; 3] {
        let vertices = self.vertices.at_corners(triangle);
        std::array::from_fn(|v| match self.cones[vertices[v] as usize] {
            // Normals of one vertex may differ by a rounding.
            Some((normal, cone)) if normal == face.normals[v] => cone,
            _ => self.cone(vertices[v], face.normals[v]),
        })
    }

    fn cone(&self, vertex: u32, normal: DVec3) -> VertexCone {
        let around = self.vertices.around(vertex).iter();
        cone(normal, around.filter_map(|&face| self.outward[face as usize]))
    }
}

/// The cone of a vertex with this normal, which is repaired if necessary, by reflections at the
/// plane of the worst face [methods D, with ε = 1].
fn cone(normal: DVec3, faces: impl Iterator<Item = DVec3> + Clone) -> VertexCone {
    let axis = repaired(normal, faces.clone(), 1.0);
    let cosine = faces.map(|face| axis.dot(face)).fold(1.0, f64::min);
    VertexCone { axis, cosine }
}

/// A vertex normal, moved while it is more than 90 degrees from one of `faces`: N ← N - (1 + ε)(N·n)n
/// for the worst one [Reshetov, Soupikov and Mark, §3.2]. It is as good as it has become after 200
/// steps.
///
/// Steps with ε = `overshoot`, above 0 and up to 1, end sooner the larger it is; with 1 they end whenever normals
/// within 90 degrees of all faces are there and span a cone.
pub fn repaired(
    normal: DVec3,
    faces: impl Iterator<Item = DVec3> + Clone,
    overshoot: f64,
) -> DVec3 {
    let mut axis = normal;
    for _ in 0..MAX_REFLECTIONS {
        let worst = faces.clone().min_by(|a, b| axis.dot(*a).total_cmp(&axis.dot(*b)));
        match worst {
            Some(face) if axis.dot(face) < 0.0 => {
                axis = (axis - (1.0 + overshoot) * axis.dot(face) * face).normalize()
            }
            _ => break,
        }
    }
    axis
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square pyramid's top, `steep` times as high as half its base, and a vertex normal.
    fn fan(steep: f64, normal: DVec3) -> (DVec3, Vec<DVec3>) {
        let sides = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y];
        (normal.normalize(), sides.map(|side| (side * steep + DVec3::Z).normalize()).to_vec())
    }

    #[test]
    fn the_cone_of_a_pyramids_top_holds_its_sides() {
        let (normal, faces) = fan(2.0, DVec3::Z);
        let VertexCone { axis, cosine } = cone(normal, faces.iter().copied());
        assert_eq!(axis, DVec3::Z);
        assert!((cosine - 0.2_f64.sqrt()).abs() < 1e-15);
    }

    /// Row 48 of docs/extremes.md.
    #[test]
    fn a_normal_beyond_90_degrees_is_turned_back() {
        let (normal, faces) = fan(3.0, DVec3::new(1.0, 0.2, 0.1));
        assert!(faces.iter().any(|face| normal.dot(*face) < 0.0));
        let VertexCone { axis, cosine } = cone(normal, faces.iter().copied());
        assert!(cosine > 0.0 && faces.iter().all(|face| axis.dot(*face) >= cosine));
        assert!((axis.length() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn what_cannot_be_repaired_ends() {
        let VertexCone { axis, cosine } =
            cone(DVec3::Z, [DVec3::X, DVec3::NEG_X, DVec3::NEG_Z].into_iter());
        assert!(cosine <= 0.0 && axis.is_finite());
    }
}
