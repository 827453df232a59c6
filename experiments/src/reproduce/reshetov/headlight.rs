//! A light at the camera: dot products below 0, with which figures 9 and 13 compare both normals.
use glam::DVec3;
use specula_golden::exact::formula::consistent::{Scaling, pixel_angle, rational_q, vertex_angle};
use specula_golden::exact::method::consistent::consistent_cosine;
use specula_scene::frame::EYE;
use specula_scene::picture::camera::Camera;
use specula_scene::picture::{Light, LightSource, LightSpace, Object, Scene};
use specula_scene::primitive::Primitive;
use specula_scene::{Frame, SceneError, Span, defaults};
use specula_spec::FULL_SCALE;
use specula_testbench::Image;

use super::super::claim::{Claim, Ruling, exact};
use super::super::painted::{painted, rounded};

/// What is made of a dot product with the vector to the light, which is that to the eye.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Display {
    /// Phong's, red where it is below 0 (figures 9 and 13a).
    Marked,
    /// Phong's, clamped to 0 or more, with some ambient light (13b).
    Clamped,
    /// The same on a texture (13c).
    Textured,
    /// The consistent normal's, which is never below 0 (9 and 13d).
    Consistent,
    /// The same on a texture (13e).
    ConsistentTextured,
}

impl Display {
    /// All of them, as figure 13 has them.
    pub const ALL: [Display; 5] = [
        Display::Marked,
        Display::Clamped,
        Display::Textured,
        Display::Consistent,
        Display::ConsistentTextured,
    ];

    /// The name in pictures.
    pub const fn name(self) -> &'static str {
        match self {
            Display::Marked => "Phong, below 0 is red",
            Display::Clamped => "clamped",
            Display::Textured => "clamped, texture",
            Display::Consistent => "consistent",
            Display::ConsistentTextured => "consistent, texture",
        }
    }

    fn colour(self, frame: &Frame, span: &Span, i: u32) -> [f64; 3] {
        let [phong, consistent] = dot_products(frame, span, span.weights(i));
        let lit = |cosine: f64| FULL_SCALE * (AMBIENT + (1.0 - AMBIENT) * cosine.max(0.0));
        let textured = |cosine: f64| {
            (lit(cosine) * texture(frame.position_at(span, span.weights(i)))).to_array()
        };
        match self {
            Display::Marked if phong < 0.0 => RED,
            Display::Marked => [FULL_SCALE * phong; 3],
            Display::Clamped => [lit(phong); 3],
            Display::Textured => textured(phong),
            Display::Consistent => [FULL_SCALE * consistent; 3],
            Display::ConsistentTextured => textured(consistent),
        }
    }
}

const RED: [f64; 3] = [FULL_SCALE, 0.0, 0.0];
const AMBIENT: f64 = 0.15;

/// Squares in two colours, a fifth of a unit wide.
fn texture(place: DVec3) -> DVec3 {
    const COLOURS: [DVec3; 2] = [DVec3::new(0.95, 0.75, 0.45), DVec3::new(0.45, 0.30, 0.20)];
    let squares = (place * 5.0).floor();
    COLOURS[squares.element_sum().rem_euclid(2.0) as usize]
}

/// A frame with a light at the camera.
pub fn headlight(frame: &Frame, display: Display) -> Image {
    painted(frame, |span, i| rounded(display.colour(frame, span, i)))
}

/// N·I and N_c·I of I = V at a point of a span's triangle.
fn dot_products(frame: &Frame, span: &Span, weights: [f64; 3]) -> [f64; 2] {
    let triangle = &frame.triangles[span.triangle];
    let normal = frame.normal_at(span, weights).normalize_or(EYE);
    let axis: DVec3 = (0..3).map(|v| weights[v] * triangle.cones[v].axis).sum();
    let angles = triangle.cones.map(|cone| vertex_angle(cone.cosine.max(0.0), Scaling::RATIONAL));
    let q = rational_q(pixel_angle(angles, weights));
    [normal.dot(EYE), consistent_cosine(axis.normalize_or(EYE), q, EYE)]
}

/// What a light at the camera shows of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DotProducts {
    /// Number of pixels.
    pub pixels: u64,
    /// Those with N·V below 0: red, or flat where they are clamped.
    pub below: u64,
    /// Those with N_c·V below 0.
    pub consistent_below: u64,
    /// Mean difference of N_c·V and N·V, clamped to 0 or more, in LSBs.
    pub change: f64,
}

/// Counts them.
pub fn dot_products_of(frame: &Frame) -> DotProducts {
    let mut counted = DotProducts::default();
    for (span, i) in frame.spans.iter().flat_map(|span| (0..span.length).map(move |i| (span, i))) {
        let [phong, consistent] = dot_products(frame, span, span.weights(i));
        counted.pixels += 1;
        counted.below += u64::from(phong < 0.0);
        counted.consistent_below += u64::from(consistent < 0.0);
        counted.change += FULL_SCALE * (consistent - phong.max(0.0)).abs();
    }
    DotProducts { change: counted.change / counted.pixels.max(1) as f64, ..counted }
}

/// The meshes of figure 9, with their numbers of triangles.
pub const SPHERES: [(&str, Primitive); 3] = [
    ("80 triangles", Primitive::Icosahedron { level: 1 }),
    ("320 triangles", Primitive::Icosahedron { level: 2 }),
    ("1280 triangles", Primitive::Icosahedron { level: 3 }),
];

/// A shape alone in a picture of `size` pixels.
///
/// # Errors
/// [`SceneError`] if the picture has no room for it.
pub fn alone(shape: Primitive, size: (u32, u32)) -> Result<Frame, SceneError> {
    let scene = Scene {
        size,
        background: defaults::BACKGROUND,
        camera: Camera::default(),
        ambient: defaults::AMBIENT,
        lights: vec![Light {
            source: LightSource::Directional { direction: EYE },
            space: LightSpace::View,
            colour: [1.0; 3],
        }],
        objects: vec![Object {
            mesh: shape.mesh().into(),
            primitive: Some(shape),
            place: glam::DAffine3::IDENTITY,
            material: defaults::material().into(),
        }],
    };
    scene.frame().map_err(|error| SceneError::picture("a sphere", error))
}

/// Width and height of the pictures that claims count.
const SIZE: (u32, u32) = (160, 120);

fn measured(level: u32, number: fn(DotProducts) -> f64) -> f64 {
    alone(Primitive::Icosahedron { level }, SIZE)
        .map_or(f64::NAN, |frame| number(dot_products_of(&frame)))
}

const SMOOTHER: &str =
    "figure 9: the smoother a mesh, the more alike both shadings are (1 % of full scale)";
const BELOW: &str =
    "figure 9: with Phong's normals dot products fall below 0, with consistent ones never";

fn alike(lsb: f64) -> Ruling {
    Ruling::of(
        lsb < 0.01 * FULL_SCALE,
        "coarse meshes differ; the difference halves with the edges' lengths",
    )
}

fn some(pixels: f64) -> Ruling {
    Ruling::of(pixels > 0.0, "they do not")
}

fn none(pixels: f64) -> Ruling {
    Ruling::of(pixels == 0.0, "they do")
}

/// Claims about figure 9, a light at the camera. The numbers are those of a program in Python with a
/// depth buffer of its own, corners on the same grid of 1/256 pixel; a pixel's centre on an edge may
/// be in either face.
pub(super) const CLAIMS: [Claim; 5] = [
    exact(
        SMOOTHER,
        "mean difference in LSB, 80 triangles",
        (24.441_80, 1e-4),
        || measured(1, |m| m.change),
        alike,
    ),
    exact(
        SMOOTHER,
        "mean difference in LSB, 320 triangles",
        (13.581_76, 1e-4),
        || measured(2, |m| m.change),
        alike,
    ),
    exact(
        SMOOTHER,
        "mean difference in LSB, 1280 triangles",
        (7.176_47, 1e-4),
        || measured(3, |m| m.change),
        alike,
    ),
    exact(
        BELOW,
        "pixels of 80 triangles, Phong",
        (82.0, 1.0),
        || measured(1, |m| m.below as f64),
        some,
    ),
    exact(
        BELOW,
        "the same, consistent",
        (0.0, 0.0),
        || measured(1, |m| m.consistent_below as f64),
        none,
    ),
];
