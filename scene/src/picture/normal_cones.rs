//! Cones about vertex normals that contain the normals of all faces around the vertex [Reshetov,
//! Soupikov and Mark; methods D].
use std::collections::HashMap;

use glam::DVec3;

use crate::VertexCone;

/// Places count as equal if they agree to within this share of the object's extent: corners
/// computed on both sides of a seam do, apart from rounding.
const PLACE: f64 = 1.0 / (1u64 << 32) as f64;

/// Unit normals count as equal if their components agree to within this.
const NORMAL: f64 = 1.0 / (1u64 << 20) as f64;

/// Repair is given up after this many reflections; 2 of 19 000 random fans were not repaired then
/// (extremes row 48).
const MAX_REFLECTIONS: usize = 200;

/// A triangle, with what cones need.
pub(super) struct Face {
    /// Its corners.
    pub places: [DVec3; 3],
    /// Unit normals at the corners.
    pub normals: [DVec3; 3],
    /// Its own normal, on the side to which these point; `None` for a triangle without area.
    pub outward: Option<DVec3>,
}

/// What identifies corners that belong to one vertex with one normal: place and normal, in units of
/// [`PLACE`] and [`NORMAL`].
type Key = [i64; 6];

/// The faces around vertices.
pub(super) struct VertexFans {
    extent: f64,
    fans: HashMap<Key, Vec<DVec3>>,
}

impl VertexFans {
    /// The faces around the corners of `wanted`, found among all `faces` of an object whose
    /// coordinates do not exceed `extent`.
    pub fn around(
        wanted: impl Iterator<Item = Face>,
        faces: impl Iterator<Item = Face>,
        extent: f64,
    ) -> VertexFans {
        let mut fans = VertexFans { extent, fans: HashMap::new() };
        for face in wanted {
            for key in fans.keys(&face) {
                fans.fans.entry(key).or_default();
            }
        }
        for face in faces {
            let Some(outward) = face.outward else { continue };
            for key in fans.keys(&face) {
                if let Some(fan) = fans.fans.get_mut(&key) {
                    fan.push(outward);
                }
            }
        }
        fans
    }

    /// The cones at a face's corners.
    pub fn cones(&self, face: &Face) -> [VertexCone; 3] {
        let keys = self.keys(face);
        let fan = |v: usize| self.fans.get(&keys[v]).map(Vec::as_slice).unwrap_or_default();
        std::array::from_fn(|v| cone(face.normals[v], fan(v)))
    }

    fn keys(&self, face: &Face) -> [Key; 3] {
        let raw = |x: f64, unit: f64| (x / unit).round() as i64;
        std::array::from_fn(|v| {
            let place = face.places[v].to_array().map(|x| raw(x, self.extent * PLACE));
            let normal = face.normals[v].to_array().map(|x| raw(x, NORMAL));
            [place[0], place[1], place[2], normal[0], normal[1], normal[2]]
        })
    }
}

/// The cone of a vertex with this normal, which is repaired if necessary, by reflections at the
/// plane of the worst face [methods D, with ε = 1].
fn cone(normal: DVec3, faces: &[DVec3]) -> VertexCone {
    let axis = repaired(normal, faces, 1.0);
    let cosine = faces.iter().map(|face| axis.dot(*face)).fold(1.0, f64::min);
    VertexCone { axis, cosine }
}

/// A vertex normal, moved while it is more than 90 degrees from one of `faces`: N ← N - (1 + ε)(N·n)n
/// for the worst one [Reshetov, Soupikov and Mark, §3.2]. It is as good as it has become after 200
/// steps.
///
/// Steps with ε = `overshoot`, above 0 and up to 1, end sooner the larger it is; with 1 they end whenever normals
/// within 90 degrees of all faces are there and span a cone.
pub fn repaired(normal: DVec3, faces: &[DVec3], overshoot: f64) -> DVec3 {
    let mut axis = normal;
    for _ in 0..MAX_REFLECTIONS {
        let worst = faces.iter().copied().min_by(|a, b| axis.dot(*a).total_cmp(&axis.dot(*b)));
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
        let VertexCone { axis, cosine } = cone(normal, &faces);
        assert_eq!(axis, DVec3::Z);
        assert!((cosine - 0.2_f64.sqrt()).abs() < 1e-15);
    }

    /// Row 48 of docs/extremes.md.
    #[test]
    fn a_normal_beyond_90_degrees_is_turned_back() {
        let (normal, faces) = fan(3.0, DVec3::new(1.0, 0.2, 0.1));
        assert!(faces.iter().any(|face| normal.dot(*face) < 0.0));
        let VertexCone { axis, cosine } = cone(normal, &faces);
        assert!(cosine > 0.0 && faces.iter().all(|face| axis.dot(*face) >= cosine));
        assert!((axis.length() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn what_cannot_be_repaired_ends() {
        let VertexCone { axis, cosine } = cone(DVec3::Z, &[DVec3::X, DVec3::NEG_X, DVec3::NEG_Z]);
        assert!(cosine <= 0.0 && axis.is_finite());
    }

    #[test]
    fn vertices_are_shared_across_seams_and_not_across_creases() {
        let corner = |normals: [DVec3; 3], outward: DVec3, off: f64| Face {
            places: [DVec3::new(1.0 + off, 0.5, -0.0), DVec3::Y, outward],
            normals,
            outward: Some(outward),
        };
        let smooth = [DVec3::Z; 3];
        let tilted = DVec3::new(0.6, 0.0, 0.8);
        let faces = || {
            [
                corner(smooth, DVec3::Z, 0.0),
                corner(smooth, tilted, 1e-15),
                corner([tilted; 3], tilted, 0.0),
            ]
            .into_iter()
        };
        let fans = VertexFans::around(faces(), faces(), 1.0);
        let cosines: Vec<f64> = faces().map(|face| fans.cones(&face)[0].cosine).collect();
        assert_eq!(cosines[..2], [0.8, 0.8]);
        assert!((cosines[2] - 1.0).abs() < 1e-15);
    }
}
