//! Reflection at a point of a face, by each of the three kinds of normals that the paper compares.
use glam::DVec3;
use specula_golden::exact::formula::consistent::{
    Scaling, pixel_angle, rational_q, reflection, vertex_angle,
};
use specula_scene::picture::ConedFace;

use super::super::inward::enters;

/// A face of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Its unit normal, on the side to which its vertex normals point.
    pub outward: DVec3,
    /// Unit normals at its vertices.
    pub normals: [DVec3; 3],
    /// The same, repaired where one was more than 90 degrees from a face around it.
    pub axes: [DVec3; 3],
    /// The vertices' angles α in radians, enlarged for the rational q.
    pub angles: [f64; 3],
}

/// The normals that reflect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Normals {
    /// Phong's, interpolated.
    Phong,
    /// Phong's, and the face's where those reflect into the face [Snyder and Barr 1987].
    Repaired,
    /// Consistent ones, with the rational q.
    Consistent,
}

impl Normals {
    /// All of them.
    pub const ALL: [Normals; 3] = [Normals::Phong, Normals::Repaired, Normals::Consistent];

    /// The name in tables and pictures.
    pub const fn name(self) -> &'static str {
        match self {
            Normals::Phong => "Phong's normals",
            Normals::Repaired => "Snyder and Barr's fix",
            Normals::Consistent => "consistent normals",
        }
    }

    /// Reflects the unit vector `incoming`, which points away from the face on its outer side.
    pub fn reflect(self, face: &Face, weights: [f64; 3], incoming: DVec3) -> DVec3 {
        let about = |normal: DVec3, q: f64| reflection(normal, incoming, q);
        let phong = || about(interpolated(face.normals, weights, face.outward), 1.0);
        match self {
            Normals::Phong => phong(),
            Normals::Repaired => {
                let reflected = phong();
                if enters(reflected, face.outward) { about(face.outward, 1.0) } else { reflected }
            }
            Normals::Consistent => about(
                interpolated(face.axes, weights, face.outward),
                rational_q(pixel_angle(face.angles, weights)),
            ),
        }
    }
}

/// The unit normal at a point; the face's where the sum has no direction.
fn interpolated(normals: [DVec3; 3], weights: [f64; 3], face: DVec3) -> DVec3 {
    (0..3).map(|v| weights[v] * normals[v]).sum::<DVec3>().normalize_or(face)
}

impl From<&ConedFace> for Face {
    fn from(face: &ConedFace) -> Face {
        Face {
            outward: face.outward,
            normals: face.normals,
            axes: face.cones.map(|cone| cone.axis),
            angles: face.cones.map(|cone| vertex_angle(cone.cosine.max(0.0), Scaling::RATIONAL)),
        }
    }
}

impl Face {
    /// The face with its outer side where `direction` points to.
    pub fn facing(&self, direction: DVec3) -> Face {
        if self.outward.dot(direction) >= 0.0 {
            return self.clone();
        }
        Face {
            outward: -self.outward,
            normals: self.normals.map(|normal| -normal),
            axes: self.axes.map(|axis| -axis),
            angles: self.angles,
        }
    }
}
