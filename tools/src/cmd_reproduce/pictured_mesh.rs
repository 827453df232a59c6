//! The mesh of which pictures are drawn.
use std::path::Path;

use specula_scene::mesh::Mesh;
use specula_scene::primitive::Primitive;
use specula_scene::{Frame, SceneError};

use crate::error::ToolError;
use crate::scene;

/// Width and height of pictures.
pub const SIZE: (u32, u32) = (320, 240);

/// A mesh and its frame.
pub struct PicturedMesh {
    /// Its name.
    pub name: String,
    /// The whole mesh.
    pub mesh: Mesh,
    /// Its visible spans.
    pub frame: Frame,
}

impl PicturedMesh {
    /// Loads the mesh of a file, or the teapot.
    pub fn load(file: Option<&Path>) -> Result<PicturedMesh, ToolError> {
        let (scene, mesh) = match file {
            // Warnings about what is skipped are given where the mesh is loaded as a scene.
            Some(path) => {
                (path.display().to_string(), Mesh::read(path).map_err(SceneError::from)?.0)
            }
            None => ("teapot".to_owned(), Primitive::Teapot { level: 8 }.mesh()),
        };
        let scene = scene::load(&scene, Some(SIZE))?;
        Ok(PicturedMesh { name: scene.name, mesh, frame: scene.frame })
    }
}
