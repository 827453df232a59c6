//! Scene files, in TOML; documented in `docs/scene-format.md`.
mod build;
mod check;
mod core;
mod light;
mod object;
mod raw;
mod source;
mod span;
mod values;

use std::ops::Range;
use std::path::Path;

pub use self::core::CoreTable;
pub use self::source::SourceFile;

use crate::mesh::Warning;
use crate::picture::project::PictureError;
use crate::picture::{Rows, Scene};
use crate::{Frame, SceneError, Surface};

/// Where a scene file's keys are said.
const KEYS: &str = "docs/scene-format.md lists every key with its unit, range and default";

/// What a scene shows.
pub(crate) enum Shown {
    /// Objects, seen by a camera.
    Objects(Scene),
    /// Spans as they are given.
    Rows(Rows),
}

/// A scene file that was read: the scene, and its table for the core if it has one.
pub(crate) struct SceneFile {
    shown: Shown,
    pub core: Option<CoreTable>,
    /// What was passed over in the meshes.
    pub warnings: Vec<Warning>,
    /// Where the camera is, if the file has one.
    camera: Option<(SourceFile, Range<usize>)>,
}

impl SceneFile {
    /// Reads a scene from the text of a file; meshes are looked for beside `folder`'s files, or not
    /// at all without one.
    ///
    /// # Errors
    /// A [`SceneError`] that points at the wrong place in the text.
    pub fn parse(source: &SourceFile, folder: Option<&Path>) -> Result<SceneFile, SceneError> {
        let raw: raw::File = source.parse(KEYS)?;
        let core = raw.core.as_ref().map(|table| CoreTable::new(source.clone(), table.span()));
        let camera = raw.camera.as_ref().map(|camera| (source.clone(), camera.span()));
        let mut warnings = Vec::new();
        Ok(SceneFile {
            shown: build::shown(raw, source, folder, &mut warnings)?,
            core,
            warnings,
            camera,
        })
    }

    /// A scene that no scene file was read for, with what was passed over in its mesh.
    pub fn without_text(scene: Scene, warnings: Vec<Warning>) -> SceneFile {
        SceneFile { shown: Shown::Objects(scene), core: None, warnings, camera: None }
    }

    /// Makes the picture, `size` pixels large if given; `name` is the scene's in errors.
    ///
    /// # Errors
    /// A [`SceneError`], which points at the camera where the fault is its.
    pub fn frame(&mut self, name: &str, size: Option<(u32, u32)>) -> Result<Frame, SceneError> {
        let frame = match (&mut self.shown, size) {
            (Shown::Objects(scene), size) => {
                scene.size = size.unwrap_or(scene.size);
                scene.frame()
            }
            (Shown::Rows(rows), None) => rows.frame(),
            (Shown::Rows(_), Some(_)) => Err(PictureError::OwnSize),
        };
        frame.map_err(|error| match (&self.camera, &error) {
            (Some((source, at)), error)
                if !matches!(error, PictureError::Size(..) | PictureError::OwnSize) =>
            {
                source.error(at.clone(), error.to_string(), error.help())
            }
            _ => SceneError::picture(name, error),
        })
    }

    /// The surfaces that objects stand for, where known, one for each material; none of spans as
    /// they are given.
    pub fn surfaces(&self) -> Vec<Option<Surface>> {
        match &self.shown {
            Shown::Objects(scene) => scene.surfaces(),
            Shown::Rows(_) => vec![],
        }
    }
}
