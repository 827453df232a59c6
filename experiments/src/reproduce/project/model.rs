//! The project's models, each lit from infinity and from a place.
use std::fmt::Write;
use std::path::Path;

use glam::{DAffine3, DVec3};
use specula_scene::mesh::{Mesh, MeshError};
use specula_scene::picture::camera::Camera;
use specula_scene::picture::{Light, LightSource, LightSpace, Object, Scene};
use specula_scene::primitive::Primitive;
use specula_scene::{Frame, SceneError, defaults};

/// A model.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Its name.
    pub name: String,
    /// Its shape.
    pub mesh: Mesh,
}

impl Model {
    /// Newell's teapot, 12 by 12 cells a patch.
    pub fn teapot() -> Model {
        Model { name: "teapot".to_owned(), mesh: Primitive::Teapot { level: 12 }.mesh() }
    }

    /// A torus of 64 by 32 cells.
    pub fn torus() -> Model {
        Model { name: "torus".to_owned(), mesh: Primitive::Torus { level: 16, tube: 0.4 }.mesh() }
    }

    /// A stand-in for a scan: 20 480 small triangles of a bumpy, rough ball, whose normals are the
    /// means of its faces' as a scan's are.
    ///
    /// # Errors
    /// [`MeshError`], if the ball were no mesh.
    pub fn stand_in() -> Result<Model, MeshError> {
        let ball = Primitive::Icosahedron { level: 5 }.mesh();
        let mut text = String::new();
        for (number, &place) in ball.positions.iter().enumerate() {
            let DVec3 { x, y, z } = place * bumps(place, number);
            // Writing to a String cannot fail.
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        for corners in &ball.triangles {
            let [a, b, c] = corners.map(|corner| corner + 1);
            let _ = writeln!(text, "f {a} {b} {c}");
        }
        let (mesh, _) = Mesh::from_bytes(Path::new("stand-in.obj"), text.as_bytes())?;
        Ok(Model { name: "stand-in for a scan".to_owned(), mesh })
    }

    /// The model, filling a picture of `size` pixels, under one light at infinity or, with the eye
    /// near too, at a place one and a half radii from its middle.
    ///
    /// # Errors
    /// [`SceneError`] if none of its triangles can be seen.
    pub fn frame(&self, size: (u32, u32), illumination: Illumination) -> Result<Frame, SceneError> {
        let (middle, radius) = self.ball();
        let view = Camera::default();
        let source = match illumination {
            Illumination::Infinity => defaults::light().source,
            Illumination::Places => {
                LightSource::Point { position: middle + 1.5 * radius * LAMP, attenuation: None }
            }
        };
        let space = match illumination {
            Illumination::Infinity => LightSpace::View,
            Illumination::Places => LightSpace::World,
        };
        let eye = (illumination == Illumination::Places)
            .then(|| middle + 3.0 * radius * view.direction.normalize());
        let scene = Scene {
            size,
            background: defaults::BACKGROUND,
            camera: Camera { eye, ..view },
            ambient: defaults::AMBIENT,
            lights: vec![Light { source, space, colour: [1.0; 3] }],
            objects: vec![Object {
                mesh: self.mesh.clone().into(),
                primitive: None,
                place: DAffine3::IDENTITY,
                material: defaults::material().into(),
            }],
        };
        scene.frame().map_err(|error| SceneError::picture(&self.name, error))
    }

    /// The middle of the model's box, and half of its diagonal.
    fn ball(&self) -> (DVec3, f64) {
        let all = || self.mesh.positions.iter().copied();
        let low = all().fold(DVec3::INFINITY, DVec3::min);
        let high = all().fold(DVec3::NEG_INFINITY, DVec3::max);
        (low.midpoint(high), low.distance(high) / 2.0)
    }
}

/// Where light and eye are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Illumination {
    /// Both at infinity.
    Infinity,
    /// Both at places near the model.
    Places,
}

impl Illumination {
    /// Both of them.
    pub const ALL: [Illumination; 2] = [Illumination::Infinity, Illumination::Places];

    /// The name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Illumination::Infinity => "at infinity",
            Illumination::Places => "at places",
        }
    }
}

/// The direction from the model's middle to the lamp: the left above the eye, in the world.
const LAMP: DVec3 = DVec3::new(-0.2, 0.6, 0.77);

/// The radius of the stand-in in the direction of a vertex: waves of three wave lengths, and
/// roughness of half a per cent that depends on the vertex's number alone.
fn bumps(place: DVec3, number: usize) -> f64 {
    let wave = |x: f64| libm::sin(x);
    let scattered = (number as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
    let rough = scattered as f64 / f64::from(1u32 << 24) - 0.5;
    1.0 + 0.12 * wave(5.0 * place.x + 1.0) * wave(4.0 * place.y)
        + 0.06 * wave(9.0 * place.z + 2.0)
        + 0.005 * rough
}
