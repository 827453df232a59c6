//! What a mesh file shows when it is the scene itself.
use std::path::Path;

use super::indexed::Mesh;
use super::limits::extension;
use super::warning::{Notices, Warning};
use super::{Beside, MeshError, MeshProblem, file_beside, glb, parse, read_file};
use crate::picture::Light;
use crate::picture::camera::Camera;
use crate::sequence::NodeMotions;

/// A mesh, with what lights it and from where it is seen, as far as its file says so.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// All that is shown.
    pub mesh: Mesh,
    /// The lights, at most [`crate::limits::MOST_LIGHTS`].
    pub lights: Vec<Light>,
    /// The camera.
    pub camera: Option<Camera>,
    /// How it moves, if it does.
    pub movement: Option<Movement>,
}

/// How what a file shows moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Movement {
    /// The parts of the mesh that move each as a whole, each in the coordinates of its node.
    pub meshes: Vec<Mesh>,
    /// The number of frames, 1 to [`crate::sequence::MOST_FRAMES`].
    pub frames: u32,
    /// The motions of the meshes, the lights and the camera.
    pub motions: NodeMotions,
}

impl Model {
    /// Reads a file as [`Mesh::read`] does, with its lights and its camera.
    ///
    /// # Errors
    /// The errors of [`Mesh::read`].
    pub fn read(path: &Path) -> Result<(Model, Vec<Warning>), MeshError> {
        let bytes = read_file(path).map_err(|problem| MeshError::new(path, None, problem))?;
        Model::from_bytes(path, &bytes, &|name| file_beside(path, name))
    }

    /// Reads a file from its bytes as [`Mesh::from_bytes_beside`] does.
    ///
    /// # Errors
    /// The errors of [`Mesh::read`].
    pub fn from_bytes(
        path: &Path,
        bytes: &[u8],
        beside: &Beside<'_>,
    ) -> Result<(Model, Vec<Warning>), MeshError> {
        let extension =
            extension(path).ok_or_else(|| MeshError::new(path, None, MeshProblem::Extension))?;
        let mut notices = Notices::default();
        let model = match extension {
            "glb" => glb::model(bytes, &mut notices),
            _ => parse(extension, bytes, beside, &mut notices).map(Model::of_mesh),
        };
        let model = model.map_err(|at| MeshError::new(path, at.line, at.problem))?;
        Ok((model, notices.into_warnings(path)))
    }

    /// A mesh of which nothing else is known.
    fn of_mesh(mesh: Mesh) -> Model {
        Model { mesh, lights: Vec::new(), camera: None, movement: None }
    }
}
