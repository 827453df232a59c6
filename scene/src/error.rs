//! Errors in what a user gives.
use std::sync::Arc;

use miette::{Diagnostic, NamedSource, SourceSpan};
use thiserror::Error;

use crate::mesh::MeshError;
use crate::picture::project::PictureError;

/// The reason why a scene cannot be loaded: what is wrong, where, and what would be right.
#[derive(Debug, Error, Diagnostic)]
pub enum SceneError {
    /// The name is neither that of a built-in scene nor that of a file that can be read as one.
    #[error("`{scene}` is neither a built-in scene nor a file of a known kind")]
    #[diagnostic(code(scene::unknown))]
    Unknown {
        /// The scene that the user asked for.
        scene: String,
        /// The built-in scenes and the known kinds of file.
        #[help]
        help: String,
    },
    /// A file cannot be read, or is not text.
    #[error("{kind} `{path}`: {reason}")]
    #[diagnostic(code(scene::unreadable))]
    Unreadable {
        /// The kind of file that was expected.
        kind: &'static str,
        /// The file.
        path: String,
        /// The reason.
        reason: String,
        /// What would be right.
        #[help]
        help: String,
    },
    /// Something is wrong at a place in a scene file or in a spec file.
    #[error("{problem}")]
    #[diagnostic(code(scene::file))]
    File {
        /// What is wrong.
        problem: String,
        /// What would be right.
        #[help]
        help: String,
        /// The file.
        #[source_code]
        text: Arc<NamedSource<String>>,
        /// The place in the file.
        #[label("here")]
        at: SourceSpan,
    },
    /// Something is wrong with a mesh that was given as the scene.
    #[error("{error}")]
    #[diagnostic(code(scene::mesh))]
    Mesh {
        /// What is wrong, and where.
        error: MeshError,
        /// What would be right.
        #[help]
        help: String,
    },
    /// A file in a folder of frames does not go with the others.
    #[error("frame `{file}` {wrong}")]
    #[diagnostic(code(scene::frames))]
    Unlike {
        /// The file.
        file: String,
        /// What is wrong with it.
        wrong: String,
        /// What would be right.
        #[help]
        help: String,
    },
    /// The scene is well formed, but cannot be drawn.
    #[error("scene `{scene}`: {error}")]
    #[diagnostic(code(scene::picture))]
    Picture {
        /// The scene.
        scene: String,
        /// What is wrong.
        error: PictureError,
        /// What would be right.
        #[help]
        help: String,
    },
}

impl From<MeshError> for SceneError {
    fn from(error: MeshError) -> SceneError {
        let help = error.help();
        SceneError::Mesh { error, help }
    }
}

impl SceneError {
    /// The error of drawing the scene `scene`.
    pub fn picture(scene: &str, error: PictureError) -> SceneError {
        let help = error.help();
        SceneError::Picture { scene: scene.to_owned(), error, help }
    }
}
