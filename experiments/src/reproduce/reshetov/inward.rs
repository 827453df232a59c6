//! Reflections that enter a mesh, with Phong's and with consistent normals, for points all over its
//! faces (numerics N2c).
use glam::DVec3;
use specula_golden::exact::formula::consistent::{
    Scaling, cosine, pixel_angle, q, rational_q, reflection, vertex_angle,
};
use specula_scene::mesh::Mesh;
use specula_scene::picture::{ConedFace, coned_faces};
use specula_scene::primitive::Primitive;
use specula_spec::FULL_SCALE;

use super::super::claim::{Claim, Ruling, exact};
use crate::stress::draw::{Draw, turned};

/// Approximate number of rays for each mesh.
const RAYS: usize = 200_000;
/// Seed of the rays.
const SEED: u64 = 2010;

/// Statistics of rays from all directions in front of the faces of a mesh, as many for each face,
/// at any point of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inward {
    /// Number of triangles with an area.
    pub triangles: usize,
    /// The largest angle between a vertex normal and a face around it, in degrees.
    pub widest: f64,
    /// Share of rays that Phong's normals reflect into the face.
    pub phong: f64,
    /// Share of rays that come from behind Phong's normal.
    pub behind: f64,
    /// Share of rays that consistent normals with q reflect into the face.
    pub trigonometric: f64,
    /// Share of rays that consistent normals with q~ reflect into the face.
    pub rational: f64,
    /// The least n·r with q~.
    pub least: f64,
    /// Mean difference of N_c·I from N·I with q~, in LSBs.
    pub change: f64,
}

/// By how much n·r in f64 may be below 0 because of rounding.
const ROUNDING: f64 = 1e-12;

/// Whether a reflected ray enters a face.
pub(super) fn enters(reflected: DVec3, outward: DVec3) -> bool {
    reflected.dot(outward) < -ROUNDING
}

/// Counts rays.
pub fn count(mesh: &Mesh) -> Inward {
    let faces = coned_faces(mesh);
    let each = RAYS.div_ceil(faces.len().max(1));
    let rays = (faces.len() * each) as f64;
    let mut draw = Draw::new(SEED, 0);
    let mut sum = Inward {
        triangles: faces.len(),
        widest: widest(&faces),
        least: f64::INFINITY,
        ..Inward::default()
    };
    for face in &faces {
        let angles = [Scaling::TRIGONOMETRIC_LINEAR, Scaling::RATIONAL]
            .map(|scaling| face.cones.map(|cone| vertex_angle(cone.cosine.max(0.0), scaling)));
        for _ in 0..each {
            sum.add(face, angles, &mut draw);
        }
    }
    for share in [&mut sum.phong, &mut sum.behind, &mut sum.trigonometric, &mut sum.rational] {
        *share /= rays;
    }
    Inward { change: sum.change * FULL_SCALE / rays, ..sum }
}

fn widest(faces: &[ConedFace]) -> f64 {
    let least =
        faces.iter().flat_map(|face| face.cones).map(|cone| cone.cosine).fold(1.0, f64::min);
    libm::acos(least).to_degrees()
}

impl Inward {
    /// Adds a ray to the sums.
    fn add(&mut self, face: &ConedFace, [trigonometric, rational]: [[f64; 3]; 2], draw: &mut Draw) {
        let incoming = turned(face.outward, libm::acos(draw.unit()), draw.unit());
        let weights = draw.weights();
        let normal =
            (0..3).map(|v| weights[v] * face.cones[v].axis).sum::<DVec3>().normalize_or_zero();
        let reflected = |q: f64| reflection(normal, incoming, q);
        let by_rational = rational_q(pixel_angle(rational, weights));
        let enters = |q: f64| f64::from(u8::from(enters(reflected(q), face.outward)));
        self.phong += enters(1.0);
        self.behind += f64::from(u8::from(normal.dot(incoming) < 0.0));
        self.trigonometric += enters(q(pixel_angle(trigonometric, weights)));
        self.rational += enters(by_rational);
        self.least = self.least.min(reflected(by_rational).dot(face.outward));
        self.change += (cosine(incoming, reflected(by_rational)) - normal.dot(incoming)).abs();
    }
}

/// The meshes for which rays are counted.
pub const MESHES: [(&str, Primitive); 8] = [
    ("icosahedron", ICOSAHEDRON),
    ("its faces in 4", Primitive::Icosahedron { level: 1 }),
    ("in 16", Primitive::Icosahedron { level: 2 }),
    ("in 64", Primitive::Icosahedron { level: 3 }),
    ("sphere, 8 x 4 cells", Primitive::Sphere { level: 2 }),
    ("torus, 12 x 6 cells", Primitive::Torus { level: 3, tube: 0.4 }),
    ("teapot, 4 x 4 cells a patch", Primitive::Teapot { level: 4 }),
    ("teapot, 8 x 8 cells a patch", Primitive::Teapot { level: 8 }),
];

const ICOSAHEDRON: Primitive = Primitive::Icosahedron { level: 0 };

const PHONG: &str = "Phong's normals reflect into coarse meshes";
const CONSISTENT: &str = "consistent normals never do";

fn some(share: f64) -> Ruling {
    Ruling::of(share > 0.0, "they do not")
}

fn no_ray(share: f64) -> Ruling {
    Ruling::of(share == 0.0, "they do")
}

/// Tolerance: of 200 000 rays a share of 0.2 is known to 0.003, three standard deviations.
const RAY_TOLERANCE: f64 = 3e-3;

/// Claims about icosahedra, which the project's measurement also used.
pub(super) const CLAIMS: [Claim; 6] = [
    exact(
        PHONG,
        "share of rays, icosahedron",
        (0.211, RAY_TOLERANCE),
        || count(&ICOSAHEDRON.mesh()).phong,
        some,
    ),
    exact(
        PHONG,
        "share of rays, 80 triangles",
        (0.105, RAY_TOLERANCE),
        || count(&MESHES[1].1.mesh()).phong,
        some,
    ),
    exact(
        PHONG,
        "share of rays, 320 triangles",
        (0.052, RAY_TOLERANCE),
        || count(&MESHES[2].1.mesh()).phong,
        some,
    ),
    exact(
        PHONG,
        "share of rays, 1280 triangles",
        (0.026, RAY_TOLERANCE),
        || count(&MESHES[3].1.mesh()).phong,
        some,
    ),
    exact(
        CONSISTENT,
        "share of rays, icosahedron, q~",
        (0.0, 0.0),
        || count(&ICOSAHEDRON.mesh()).rational,
        no_ray,
    ),
    exact(
        CONSISTENT,
        "share of rays, icosahedron, q",
        (0.0, 0.0),
        || count(&ICOSAHEDRON.mesh()).trigonometric,
        no_ray,
    ),
];
