//! What perspective pictures are taken of, for the rasteriser and for a ray caster.
use std::path::Path;

use glam::DVec3;
use specula_fixtures::ray_caster::{CastCamera, CastTriangle, RayCaster};
use specula_scene::mesh::Mesh;
use specula_scene::primitive::Primitive;
use specula_scene::{Frame, SceneError, parse};

/// The folder of the meshes.
pub const MESHES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures/meshes");

/// An object, as a scene file has it and as a mesh.
#[derive(Clone)]
pub struct Model {
    table: String,
    triangles: Vec<CastTriangle>,
}

impl Model {
    /// A primitive, as a scene file has it, mirrored.
    pub fn mirrored(table: &str, primitive: Primitive) -> Model {
        let mirror = DVec3::new(-1.0, 1.0, 1.0);
        Model {
            table: format!("{table}\nscale = [-1, 1, 1]\n"),
            triangles: triangles(&primitive.mesh(), mirror),
        }
    }

    /// A mesh of the fixtures.
    pub fn file(name: &str) -> Model {
        Model::read(&format!("{MESHES}/{name}"))
    }

    /// A mesh file.
    pub fn read(path: &str) -> Model {
        let (mesh, warnings) = Mesh::read(Path::new(path)).expect("the mesh is right");
        assert!(warnings.is_empty(), "{warnings:?}");
        Model { table: format!("mesh = '{path}'\n"), triangles: triangles(&mesh, DVec3::ONE) }
    }
}

fn triangles(mesh: &Mesh, scale: DVec3) -> Vec<CastTriangle> {
    let triangle = |(corners, normals): (&[u32; 3], &[DVec3; 3])| CastTriangle {
        places: corners.map(|k| mesh.positions[k as usize] * scale),
        normals: normals.map(|normal| normal * scale),
    };
    mesh.triangles.iter().zip(&mesh.normals).map(triangle).collect()
}

/// A model before a camera.
#[derive(Clone)]
pub struct Shot {
    /// What is seen.
    pub model: Model,
    /// From where.
    pub camera: CastCamera,
}

impl Shot {
    /// The rasteriser's picture.
    pub fn frame(&self, interpolation: &str) -> Result<Frame, SceneError> {
        let CastCamera { eye, target, field_of_view, near, size } = self.camera;
        let text = format!(
            "size = [{}, {}]\n[camera]\nkind = \"perspective\"\neye = {:?}\ntarget = {:?}\nfield_of_view = {field_of_view:?}\nnear = {near:?}\ninterpolation = {interpolation:?}\n[[object]]\n{}",
            size.0,
            size.1,
            eye.to_array(),
            target.to_array(),
            self.model.table
        );
        parse("shot.toml", text).map(|scene| scene.frame)
    }

    /// The judge of it.
    pub fn caster(&self) -> RayCaster {
        RayCaster::new(self.camera, self.model.triangles.clone())
    }
}

/// A camera with a field of view of 50 degrees, which sees what is at least so far away.
pub fn camera(eye: [f64; 3], target: [f64; 3], near: f64) -> CastCamera {
    let [eye, target] = [eye, target].map(DVec3::from_array);
    CastCamera { eye, target, field_of_view: 50.0, near, size: (160, 120) }
}
