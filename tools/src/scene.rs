//! Loading of scenes for commands; warnings about their meshes go to standard error.
use std::io::{self, Write};

use specula_scene::{LoadedScene, SceneError};

/// Names that `run` took for a scene in earlier versions, with what replaces them.
const MOVED: [(&str, &str); 1] =
    [("figure9", "`specula reproduce figure9` shades Lyon's figure 9, which is no scene")];

/// Loads a scene as [`specula_scene::load`] does, and writes its warnings to standard error.
///
/// # Errors
/// Errors of [`specula_scene::load`]; for a name that has been replaced, the help names its
/// replacement.
pub fn load(scene: &str, size: Option<(u32, u32)>) -> Result<LoadedScene, SceneError> {
    let loaded = specula_scene::load(scene, size).map_err(with_new_place)?;
    let mut out = io::stderr().lock();
    for warning in &loaded.warnings {
        // A closed standard error is no reason to stop.
        let _ = writeln!(out, "warning: {warning}");
    }
    Ok(loaded)
}

fn with_new_place(error: SceneError) -> SceneError {
    let SceneError::Unknown { scene, help } = error else { return error };
    let moved = MOVED.iter().find(|(name, _)| *name == scene);
    let help = moved.map_or(help, |(_, place)| (*place).to_owned());
    SceneError::Unknown { scene, help }
}
