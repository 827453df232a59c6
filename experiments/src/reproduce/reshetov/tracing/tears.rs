//! Where Snyder and Barr's fix tears the reflection.
use specula_scene::picture::coned_faces;
use specula_scene::primitive::Primitive;

use super::super::super::angle::angle_between;
use super::super::super::claim::{Claim, Ruling, exact};
use super::super::inward::enters;
use super::mirror::{Face, Normals};

/// The jump of the reflected direction, in degrees, along a line from a vertex of an icosahedron's
/// face to the face's middle, where Phong's reflection passes through the face.
///
/// The incoming vector is `incidence` degrees from the face's normal, away from the vertex, in the
/// plane of both normals.
fn jump(normals: Normals, incidence: f64) -> f64 {
    let faces = coned_faces(&Primitive::Icosahedron { level: 0 }.mesh());
    let face = Face::from(&faces[0]);
    let across = (face.normals[0] - face.normals[0].dot(face.outward) * face.outward).normalize();
    let (sine, cosine) = libm::sincos(incidence.to_radians());
    let incoming = cosine * face.outward - sine * across;
    let along = |t: f64| [1.0 - t + t / 3.0, t / 3.0, t / 3.0];
    let reflected = |normals: Normals, t: f64| normals.reflect(&face, along(t), incoming);
    // Phong's reflection enters the face at the vertex and not in the middle.
    let (mut inside, mut outside) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = (inside + outside) / 2.0;
        if enters(reflected(Normals::Phong, middle), face.outward) {
            inside = middle
        } else {
            outside = middle
        }
    }
    angle_between(reflected(normals, inside), reflected(normals, outside)).to_degrees()
}

const TEARS: &str = "Snyder and Barr's fix creates discontinuities";

fn torn(degrees: f64) -> Ruling {
    Ruling::of(degrees > 1e-6, "it does not")
}

/// Claims about continuity. Where Phong's reflection lies in the face, the face's is its image by
/// both mirrors, turned by twice the angle between their normals: by 90 degrees less the incidence.
pub(in crate::reproduce::reshetov) const CLAIMS: [Claim; 3] = [
    exact(
        TEARS,
        "degrees that r jumps by, 30 degrees of incidence",
        (60.0, 1e-6),
        || jump(Normals::Repaired, 30.0),
        torn,
    ),
    exact(TEARS, "the same, 60 degrees", (30.0, 1e-6), || jump(Normals::Repaired, 60.0), torn),
    exact(
        "at the same place consistent normals create none",
        "degrees that r jumps by, 30 degrees of incidence",
        (0.0, 1e-6),
        || jump(Normals::Consistent, 30.0),
        |degrees| Ruling::of(degrees < 1e-6, "they do"),
    ),
];
