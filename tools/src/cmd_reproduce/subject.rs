//! The mesh that is drawn.
use std::path::Path;

use specula_scene::mesh::Mesh;
use specula_scene::primitive::Primitive;
use specula_scene::{Frame, SceneError};

use crate::error::ToolError;
use crate::scene;

/// Width and height of pictures.
pub const SIZE: (u32, u32) = (320, 240);

/// A mesh, and its picture.
pub struct Subject {
    /// Its name.
    pub name: String,
    /// All of it.
    pub mesh: Mesh,
    /// What is seen of it.
    pub frame: Frame,
}

impl Subject {
    /// The mesh of a file, or the teapot.
    pub fn load(file: Option<&Path>) -> Result<Subject, ToolError> {
        let (scene, mesh) = match file {
            // What is passed over is told where the mesh is loaded as a scene.
            Some(path) => {
                (path.display().to_string(), Mesh::read(path).map_err(SceneError::from)?.0)
            }
            None => ("teapot".to_owned(), Primitive::Teapot { level: 8 }.mesh()),
        };
        let scene = scene::load(&scene, Some(SIZE))?;
        Ok(Subject { name: scene.name, mesh, frame: scene.frame })
    }
}
