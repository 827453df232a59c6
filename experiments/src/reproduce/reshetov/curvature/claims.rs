//! Claims about figure 8.
use specula_golden::exact::formula::consistent::{
    Scaling, pixel_angle, rational_q, reflection, vertex_angle,
};
use specula_golden::exact::formula::diffuse::lambert;
use specula_golden::exact::method::consistent::consistent_cosine;
use specula_scene::mesh::normals::newell;
use specula_scene::{Frame, Triangle, VertexCone};
use specula_spec::FULL_SCALE;

use super::super::super::claim::{Claim, HALF_LSB, Ruling, exact};
use super::super::inward::enters;
use super::{modulated, zigzag};
use crate::stress::draw::{Draw, turned};

/// Width and height of the picture whose triangles are looked at.
const SIZE: (u32, u32) = (160, 120);
/// Rays that are drawn for each triangle.
const RAYS: u32 = 2000;
/// Seed of the rays.
const SEED: u64 = 2010;

/// The largest difference of diffuse light between vertices of a frame, in LSBs.
fn contrast(frame: &Frame, shade: impl Fn(&VertexCone) -> f64) -> f64 {
    let shades = || frame.triangles.iter().flat_map(|triangle| &triangle.cones).map(&shade);
    let (low, high) = (shades().fold(f64::INFINITY, f64::min), shades().fold(0.0, f64::max));
    FULL_SCALE * (high - low)
}

/// The contrast of N·L, or of N_c·L, of what becomes of the zigzag.
fn of_phong() -> f64 {
    zigzag(SIZE).map_or(f64::NAN, |frame| {
        let light = frame.lights[0].direction;
        contrast(&frame, |cone| lambert(cone.axis, light))
    })
}

fn of_consistent(change: fn(&Frame) -> Frame) -> f64 {
    zigzag(SIZE).map_or(f64::NAN, |frame| {
        let light = frame.lights[0].direction;
        contrast(&change(&frame), |cone| {
            let angle = vertex_angle(cone.cosine, Scaling::RATIONAL);
            consistent_cosine(
                cone.axis,
                rational_q(pixel_angle([angle; 3], [1.0, 0.0, 0.0])),
                light,
            )
        })
    })
}

/// Number of rays from in front of the zigzag's faces that modulated normals reflect into them.
fn entering() -> f64 {
    let Ok(frame) = zigzag(SIZE) else { return f64::NAN };
    let mut draw = Draw::new(SEED, 8);
    let of_triangle = |triangle: &Triangle| {
        let Some(face) = newell(&triangle.positions) else { return 0 };
        let face = face * face.z.signum();
        let angles = triangle.cones.map(|cone| vertex_angle(cone.cosine, Scaling::RATIONAL));
        let mut enters = || {
            let incoming = turned(face, libm::acos(draw.unit()), draw.unit());
            let q = rational_q(pixel_angle(angles, draw.weights()));
            enters(reflection(triangle.cones[0].axis, incoming, q), face)
        };
        (0..RAYS).filter(|_| enters()).count()
    };
    modulated(&frame).triangles.iter().map(of_triangle).sum::<usize>() as f64
}

const SHADED: &str = "figure 8: with equal vertex normals Phong shading of a zigzag is flat";
const MODULATED: &str = "angles modulated by curvature show the zigzag";

fn flat(lsb: f64) -> Ruling {
    Ruling::of(lsb < FULL_SCALE * HALF_LSB, "it is not")
}

fn visible(lsb: f64) -> Ruling {
    Ruling::of(lsb > FULL_SCALE * HALF_LSB, "they do not")
}

/// Claims about figure 8, for folds of 40 degrees and a light 60 degrees to their side. That of the
/// modulated angles was computed in Python from cos((β + γ)/2) of a ridge and a valley.
pub(in crate::reproduce) const CLAIMS: [Claim; 4] = [
    exact(SHADED, "largest difference of N.L in LSB", (0.0, 1e-9), of_phong, flat),
    exact(
        "nor do consistent normals show it, whose angles are equal too",
        "largest difference of N_c.L in LSB",
        (0.0, 1e-9),
        || of_consistent(Frame::clone),
        flat,
    ),
    exact(
        MODULATED,
        "largest difference of N_c.L in LSB",
        (32.988_652, 5e-6),
        || of_consistent(modulated),
        visible,
    ),
    exact(MODULATED, "rays reflected into the zigzag", (0.0, 0.0), entering, |rays| {
        Ruling::of(rays == 0.0, "they reflect into it")
    }),
];
