//! Claims about figure 1.
use specula_scene::primitive::Primitive;

use super::super::super::claim::{Claim, Ruling, exact};
use super::{Normals, Rays, Surroundings, mirrored};

/// A mesh in a picture of a width and height.
type Subject = (Primitive, (u32, u32));

const TORUS: Subject = (Primitive::Torus { level: 3, tube: 0.4 }, (160, 120));
const ICOSAHEDRON: Subject = (Primitive::Icosahedron { level: 0 }, (160, 120));
/// Its 1280 triangles have vertex normals up to 5.4547 degrees from their own.
const FINE: Subject = (Primitive::Icosahedron { level: 3 }, (320, 240));

/// The rays of a picture; none if it could not be made.
fn rays((shape, size): Subject, normals: Normals, surroundings: Surroundings) -> Rays {
    mirrored(&shape.mesh(), size, normals, surroundings)
        .map_or_else(Rays::default, |picture| picture.rays)
}

/// Number of rays that enter the surface.
fn inward(subject: Subject, normals: Normals, surroundings: Surroundings) -> f64 {
    rays(subject, normals, surroundings).inward.iter().sum::<u64>() as f64
}

/// Two pixels whose centres are on an edge may be another face's in another program.
const fn share(of: f64, rays: f64) -> (f64, f64) {
    (of / rays, 2.0 / rays)
}

fn some(share: f64) -> Ruling {
    Ruling::of(share > 0.0, "none do")
}

fn none(rays: f64) -> Ruling {
    Ruling::of(rays == 0.0, "some do")
}

const TRACED: &str = "figure 1a: Phong's normals reflect into a mesh that mirrors itself";
const CLEAN: &str = "figures 1b and 1d: consistent normals never do";
const GRAZING: &str =
    "figure 1e: on a fine mesh, here 1280 triangles, only at grazing angles or silhouettes";

/// Claims about figure 1. The counts are those of a program in Python, which finds what is visible
/// by a depth buffer and tries every triangle for what is reflected.
pub(in crate::reproduce) const CLAIMS: [Claim; 8] = [
    exact(
        TRACED,
        "share of first reflections, torus of 144 triangles",
        share(981.0, 8744.0),
        || rays(TORUS, Normals::Phong, Surroundings::Itself).share(0),
        some,
    ),
    exact(
        TRACED,
        "share of reflections of reflections",
        share(110.0, 563.0),
        || rays(TORUS, Normals::Phong, Surroundings::Itself).share(1),
        some,
    ),
    exact(
        "figure 1c: so they do into an environment",
        "share of reflections, icosahedron",
        share(884.0, 7406.0),
        || rays(ICOSAHEDRON, Normals::Phong, Surroundings::Environment).share(0),
        some,
    ),
    exact(
        CLEAN,
        "reflections, torus that mirrors itself",
        (0.0, 0.0),
        || inward(TORUS, Normals::Consistent, Surroundings::Itself),
        none,
    ),
    exact(
        CLEAN,
        "reflections, icosahedron in an environment",
        (0.0, 0.0),
        || inward(ICOSAHEDRON, Normals::Consistent, Surroundings::Environment),
        none,
    ),
    exact(
        GRAZING,
        "share of reflections",
        share(82.0, 36_566.0),
        || rays(FINE, Normals::Phong, Surroundings::Environment).share(0),
        some,
    ),
    exact(
        GRAZING,
        "largest cosine between the eye and a face that it happens on",
        (0.136_551_806_2, 1e-9),
        || rays(FINE, Normals::Phong, Surroundings::Environment).steepest,
        // The sine of twice that angle: a reflection at a normal a from the face's enters a face
        // that is seen at 90 - 2a degrees or more.
        |cosine| Ruling::of(cosine < 0.189_257, "it happens where the face is seen more steeply"),
    ),
    exact(
        CLEAN,
        "reflections, the fine mesh in an environment",
        (0.0, 0.0),
        || inward(FINE, Normals::Consistent, Surroundings::Environment),
        none,
    ),
];
