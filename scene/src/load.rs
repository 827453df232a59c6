//! Loads a scene by its name: a built-in scene, a scene file, or a mesh.
use std::path::Path;

use crate::file::{CoreTable, SceneFile, SourceFile, View};
use crate::mesh::error::listed;
use crate::mesh::{self, EXTENSIONS, Mesh, Model, Movement, Warning};
use crate::picture::{Object, Scene};
use crate::sequence::{Besides, FrameFiles, FrameSource, Script};
use crate::{Frame, Needs, PartialMaterial, SceneError, Sequence, Surface, builtin, defaults};

/// A scene with its visible spans, and its table for the core.
#[derive(Clone, Debug)]
pub struct LoadedScene {
    /// The file's stem or the built-in scene's name, reduced to `a`-`z`, `0`-`9` and `_` without a
    /// digit at the beginning, so that it can be part of a file's or module's name; at most 48
    /// characters.
    pub name: String,
    /// The frame to be shaded; of a scene that moves, the first one in which something is visible.
    pub frame: Frame,
    /// Its number among the frames of a scene that moves, counted from 0.
    pub number: u32,
    /// All frames, if the scene moves.
    pub sequence: Option<Sequence>,
    /// The curved surfaces that objects represent, where they are known: one for each of the
    /// frame's materials, or none at all.
    pub surfaces: Vec<Option<Surface>>,
    /// The `[core]` table of the scene file, if it has one.
    pub core: Option<CoreTable>,
    /// What was skipped in the scene's meshes: one warning of each kind for each file.
    pub warnings: Vec<Warning>,
}

impl LoadedScene {
    fn new(name: &str, view: View, core: Option<CoreTable>, warnings: Vec<Warning>) -> LoadedScene {
        let View { frame, number, surfaces, sequence } = view;
        LoadedScene { name: name.to_owned(), frame, number, sequence, surfaces, core, warnings }
    }

    /// The needs of its frame, or of all frames together if it moves.
    ///
    /// # Errors
    /// [`SceneError::Picture`] if a frame cannot be drawn.
    pub fn needs(&self) -> Result<Needs, SceneError> {
        match &self.sequence {
            None => Ok(Needs::of(&self.frame)),
            Some(sequence) => sequence.needs(),
        }
    }

    /// The scene as it is in a frame of its sequence, counted from 0; as it is if it does not move.
    ///
    /// # Errors
    /// [`SceneError`] if the frame cannot be drawn.
    pub fn in_frame(self, number: u32) -> Result<LoadedScene, SceneError> {
        let Some(sequence) = &self.sequence else { return Ok(self) };
        let (frame, surfaces) = (sequence.frame(number)?, sequence.surfaces(number)?);
        Ok(LoadedScene { frame, number, surfaces, ..self })
    }
}

/// Largest length of a name that is made from a file's name, in characters.
pub const LONGEST_NAME: usize = 48;

/// Loads a scene: the name of a built-in one, or the path of a scene file (`.toml`), a mesh
/// (`.obj`, `.ply`, `.stl`, `.glb`), or a folder of such files, each of which is a frame. `size` in pixels takes precedence over the scene's own.
///
/// A mesh fills the picture, seen from the front, a little to the right and above, with one light
/// and a grey material, as far as its file does not say otherwise.
///
/// # Errors
/// A [`SceneError`] that says what is wrong with the name, the file or the picture, where, and what
/// would be right.
pub fn load(scene: &str, size: Option<(u32, u32)>) -> Result<LoadedScene, SceneError> {
    let path = Path::new(scene);
    if let Some(text) = builtin::builtin_text(scene) {
        let source = SourceFile::new(&format!("{scene}.toml"), text.to_owned());
        return finish(scene, scene, SceneFile::parse(&source, None)?, size);
    }
    let name = module_name(path);
    if mesh::extension(path).is_some() || is_scene_file(path) {
        return finish(scene, &name, read(path)?, size);
    }
    if path.is_dir() {
        return folder(scene, &name, size);
    }
    let help = format!(
        "built-in scenes are {}; scene files end in `.toml`, meshes in {}, and a folder of such files is a sequence",
        listed(builtin::builtin_names()),
        EXTENSIONS.map(|extension| format!("`.{extension}`")).join(", ")
    );
    Err(SceneError::Unknown { scene: scene.to_owned(), help })
}

/// Reads a scene from the text of a scene file; `name` is the file's name in errors. Relative paths
/// of meshes start at the current folder.
///
/// # Errors
/// A [`SceneError`] that says what is wrong with the text, and where.
pub fn parse(name: &str, text: String) -> Result<LoadedScene, SceneError> {
    let source = SourceFile::new(name, text);
    finish(
        name,
        &module_name(Path::new(name)),
        SceneFile::parse(&source, Some(Path::new("")))?,
        None,
    )
}

/// Whether a path is that of a scene file.
pub(crate) fn is_scene_file(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// Reads a mesh, which is shown by itself, or a scene file.
pub(crate) fn read(path: &Path) -> Result<SceneFile, SceneError> {
    if is_scene_file(path) {
        let source = SourceFile::read("scene file", path)?;
        return SceneFile::parse(&source, path.parent());
    }
    let (model, warnings) = Model::read(path)?;
    Ok(model_scene(model, warnings))
}

/// A folder whose scene files and meshes are frames.
fn folder(scene: &str, name: &str, size: Option<(u32, u32)>) -> Result<LoadedScene, SceneError> {
    let (files, Besides { core, warnings }) = FrameFiles::new(Path::new(scene), size)?;
    let sequence = Sequence::new(scene, FrameSource::Files(files))?;
    let view = View::of_sequence(sequence)?;
    Ok(LoadedScene::new(name, view, core, warnings))
}

fn finish(
    scene: &str,
    name: &str,
    file: SceneFile,
    size: Option<(u32, u32)>,
) -> Result<LoadedScene, SceneError> {
    let view = file.view(scene, size)?;
    Ok(LoadedScene::new(name, view, file.core, file.warnings))
}

/// The scene that shows a mesh by itself.
fn model_scene(model: Model, warnings: Vec<Warning>) -> SceneFile {
    let Model { mesh, lights, camera, movement } = model;
    let scene = Scene {
        size: defaults::SIZE,
        background: defaults::BACKGROUND,
        camera: camera.unwrap_or_default(),
        ambient: defaults::AMBIENT,
        lights: if lights.is_empty() { vec![defaults::light()] } else { lights },
        objects: Vec::new(),
    };
    match movement {
        None => SceneFile::without_text(Scene { objects: vec![object(mesh)], ..scene }, warnings),
        Some(Movement { meshes, frames, motions }) => {
            let objects = meshes.into_iter().map(object).collect();
            let script = Script::Nodes(motions.into());
            SceneFile::moving(Scene { objects, ..scene }, frames, script, warnings)
        }
    }
}

/// A mesh as its file has it.
fn object(mesh: Mesh) -> Object {
    Object {
        mesh: mesh.into(),
        primitive: None,
        place: glam::DAffine3::IDENTITY,
        material: PartialMaterial::default(),
    }
}

/// A path's stem in the form of [`LoadedScene::name`].
pub fn module_name(path: &Path) -> String {
    let stem =
        path.file_stem().map(|stem| stem.to_string_lossy().to_lowercase()).unwrap_or_default();
    let plain =
        stem.chars().map(|c| if c.is_ascii_lowercase() || c.is_ascii_digit() { c } else { '_' });
    let name: String = plain.take(LONGEST_NAME - 1).collect();
    match name.chars().next() {
        None => "scene".to_owned(),
        Some(first) if first.is_ascii_digit() => format!("_{name}"),
        Some(_) => name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_can_be_part_of_file_and_module_names() {
        for (path, name) in [
            ("a/Bunny.ply", "bunny"),
            ("3d scan-v2.obj", "_3d_scan_v2"),
            ("\u{e9}t\u{e9}.stl", "_t_"),
            ("..", "scene"),
            ("", "scene"),
            ("x.tar.gz", "x_tar"),
        ] {
            assert_eq!(module_name(Path::new(path)), name);
        }
        assert_eq!(module_name(Path::new(&"9".repeat(300))).len(), LONGEST_NAME);
    }
}
