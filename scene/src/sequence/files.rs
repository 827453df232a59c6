//! A folder whose scene files and meshes are frames.
use std::fs;
use std::path::{Path, PathBuf};

use crate::error::SceneError;
use crate::file::{CoreTable, SceneFile};
use crate::load::{is_scene_file, read};
use crate::mesh::{self, Warning};
use crate::picture::{LightSource, Scene};

use super::MOST_FRAMES;

/// A folder's scene files and meshes, a frame each, in the order of their names.
#[derive(Clone, Debug)]
pub struct FrameFiles {
    files: Vec<PathBuf>,
    /// Width and height of every picture in pixels, if they are not as the files say.
    size: Option<(u32, u32)>,
}

/// What is in the files besides their scenes.
#[derive(Debug, Default)]
pub(crate) struct Besides {
    /// The first file's table for the core.
    pub core: Option<CoreTable>,
    /// What was skipped in the meshes.
    pub warnings: Vec<Warning>,
}

impl FrameFiles {
    /// The frames in a folder, whose files are all read once.
    ///
    /// # Errors
    /// [`SceneError`] if there are none or too many, if one of them cannot be read or moves by
    /// itself, or if it has other lights, pixels or eyes than the first one.
    pub(crate) fn new(
        folder: &Path,
        size: Option<(u32, u32)>,
    ) -> Result<(FrameFiles, Besides), SceneError> {
        let files = files_in(folder)?;
        let frames = FrameFiles { files, size };
        let (first, mut besides) = frames.checked(0)?;
        for index in 1..frames.files.len() {
            let (scene, others) = frames.checked(index)?;
            if kinds(&scene) != kinds(&first) {
                return Err(unlike(&frames.files[index], &frames.files[0]));
            }
            besides.warnings.extend(others.warnings);
        }
        Ok((frames, besides))
    }

    /// The number of frames.
    pub fn frames(&self) -> u32 {
        // There are MOST_FRAMES at most.
        self.files.len() as u32
    }

    /// The scene of frame number `index`, counted from 0.
    ///
    /// # Errors
    /// [`SceneError`] if its file cannot be read any more.
    pub fn scene(&self, index: u32) -> Result<Scene, SceneError> {
        self.checked(index as usize).map(|(scene, _)| scene)
    }

    fn checked(&self, index: usize) -> Result<(Scene, Besides), SceneError> {
        let path = &self.files[index];
        let SceneFile { shown, core, warnings, .. } = read(path)?;
        let scene = shown.into_still().ok_or_else(|| SceneError::Unlike {
            file: path.display().to_string(),
            wrong: "is no scene of objects that stand still".into(),
            help: "a folder's files are frames: each shows objects, without a `[sequence]`".into(),
        })?;
        let size = self.size.unwrap_or(scene.size);
        Ok((Scene { size, ..scene }, Besides { core, warnings }))
    }
}

/// A folder's scene files and meshes, in the order of their names.
fn files_in(folder: &Path) -> Result<Vec<PathBuf>, SceneError> {
    let unreadable = |reason: String, help: &str| SceneError::Unreadable {
        kind: "folder of frames",
        path: folder.display().to_string(),
        reason,
        help: help.into(),
    };
    let entries = fs::read_dir(folder)
        .and_then(Iterator::collect::<Result<Vec<fs::DirEntry>, _>>)
        .map_err(|error| unreadable(error.to_string(), "check the path"))?;
    let mut files: Vec<PathBuf> = entries.iter().map(fs::DirEntry::path).collect();
    files.retain(|path| is_scene_file(path) || mesh::extension(path).is_some());
    files.sort();
    match files.len() {
        0 => Err(unreadable(
            "it has neither scene files nor meshes".into(),
            "each frame is a scene file (`.toml`) or a mesh, in the order of their names",
        )),
        count if count > MOST_FRAMES as usize => Err(unreadable(
            format!("it has {count} scene files and meshes"),
            "a sequence has at most 10000 frames",
        )),
        _ => Ok(files),
    }
}

fn unlike(file: &Path, first: &Path) -> SceneError {
    SceneError::Unlike {
        file: file.display().to_string(),
        wrong: format!("has another picture, other kinds of lights or another kind of eye than `{}`", first.display()),
        help: "one core shades all frames: give each as many lights of each kind, in one order, and one `size`".into(),
    }
}

/// What all frames must have alike: the picture's size, the kind of each light, and where the eye is.
fn kinds(scene: &Scene) -> ((u32, u32), Vec<u8>, bool) {
    let kind = |source: &LightSource| match source {
        LightSource::Directional { .. } => 0,
        LightSource::Point { .. } => 1,
        LightSource::Spot { .. } => 2,
    };
    let lights = scene.lights.iter().map(|light| kind(&light.source)).collect();
    (scene.size, lights, scene.camera.eye.is_some())
}
