//! Scene files, in TOML; documented in `docs/scene-format.md`.
mod build;
mod camera;
mod check;
mod core;
mod light;
mod object;
mod raw;
mod sequence;
mod shown;
mod source;
mod span;
mod values;

use std::ops::Range;
use std::path::Path;

pub use self::core::CoreTable;
pub use self::source::SourceFile;

use crate::mesh::Warning;
use crate::picture::Scene;
use crate::picture::project::PictureError;
use crate::sequence::{FrameSource, MovingScene, Script, Sequence};
use crate::{Frame, SceneError, Surface};

use shown::Shown;

/// A pointer to the documentation of the keys.
const KEYS: &str = "docs/scene-format.md lists every key with its unit, range and default";

/// A scene file that has been read: the scene, and its table for the core if it has one.
pub(crate) struct SceneFile {
    /// What it shows.
    pub shown: Shown,
    pub core: Option<CoreTable>,
    /// What was skipped in the meshes.
    pub warnings: Vec<Warning>,
    /// The place of the camera's table, if the file has one.
    camera: Option<(SourceFile, Range<usize>)>,
}

impl SceneFile {
    /// Reads a scene from the text of a file. Paths of meshes are relative to `folder`, or without
    /// one to the current folder.
    ///
    /// # Errors
    /// A [`SceneError`] that points at the wrong place in the text.
    pub fn parse(source: &SourceFile, folder: Option<&Path>) -> Result<SceneFile, SceneError> {
        let raw: raw::File = source.parse(KEYS)?;
        let core = raw.core.as_ref().map(|table| CoreTable::new(source.clone(), table.span()));
        let camera = raw.camera.as_ref().map(|camera| (source.clone(), camera.span()));
        let mut warnings = Vec::new();
        Ok(SceneFile {
            shown: build::build(raw, source, folder, &mut warnings)?,
            core,
            warnings,
            camera,
        })
    }

    /// A scene that does not come from a scene file, with the warnings about its mesh.
    pub fn without_text(scene: Scene, warnings: Vec<Warning>) -> SceneFile {
        SceneFile { shown: Shown::Objects(scene), core: None, warnings, camera: None }
    }

    /// A scene that moves over `frames` frames, at least one, and does not come from a scene file.
    pub fn moving(scene: Scene, frames: u32, script: Script, warnings: Vec<Warning>) -> SceneFile {
        let shown = Shown::Moving { scene, frames, script };
        SceneFile { shown, core: None, warnings, camera: None }
    }

    /// What is to be shaded, in a picture of `size` pixels if given; `name` is the scene's name in
    /// errors.
    ///
    /// # Errors
    /// A [`SceneError`], which points at the camera if that is at fault.
    pub fn view(&self, name: &str, size: Option<(u32, u32)>) -> Result<View, SceneError> {
        match (&self.shown, size) {
            (Shown::Objects(scene), size) => {
                let scene = sized(scene, size);
                let frame = scene.frame().map_err(|error| self.error(name, error))?;
                Ok(View::still(frame, scene.surfaces()))
            }
            (Shown::Moving { scene, frames, script }, size) => {
                let scene = MovingScene::new(sized(scene, size), *frames, script.clone());
                View::of_sequence(Sequence::new(name, FrameSource::Moving(scene.into()))?)
            }
            (Shown::Rows(rows), None) => {
                let frame = rows.frame().map_err(|error| self.error(name, error))?;
                Ok(View::still(frame, vec![]))
            }
            (Shown::Rows(_), Some(_)) => Err(self.error(name, PictureError::OwnSize)),
        }
    }

    fn error(&self, name: &str, error: PictureError) -> SceneError {
        match (&self.camera, &error) {
            (Some((source, at)), error)
                if !matches!(error, PictureError::Size(..) | PictureError::OwnSize) =>
            {
                source.error(at.clone(), error.to_string(), error.help())
            }
            _ => SceneError::picture(name, error),
        }
    }
}

/// The scene in a picture of another size, if one is given.
fn sized(scene: &Scene, size: Option<(u32, u32)>) -> Scene {
    Scene { size: size.unwrap_or(scene.size), ..scene.clone() }
}

/// What a scene shows: a frame, which is the first one with something in it where it moves.
pub(crate) struct View {
    pub frame: Frame,
    /// Its number among the frames of a scene that moves.
    pub number: u32,
    /// The surfaces that objects represent, one for each material; `None` where the surface is
    /// unknown. Empty for spans that the file gives directly.
    pub surfaces: Vec<Option<Surface>>,
    /// All frames, if the scene moves.
    pub sequence: Option<Sequence>,
}

impl View {
    fn still(frame: Frame, surfaces: Vec<Option<Surface>>) -> View {
        View { frame, number: 0, surfaces, sequence: None }
    }

    /// The first frame in which something is visible.
    pub fn of_sequence(sequence: Sequence) -> Result<View, SceneError> {
        let (number, frame) = sequence.first_visible()?;
        let surfaces = sequence.surfaces(number)?;
        Ok(View { frame, number, surfaces, sequence: Some(sequence) })
    }
}
