//! Scenes for commands: loaded, and what was passed over in their meshes told.
use std::io::{self, Write};

use specula_scene::{LoadedScene, SceneError};

/// Loads a scene as [`specula_scene::load`] does, and tells its warnings on standard error.
pub fn load(scene: &str, size: Option<(u32, u32)>) -> Result<LoadedScene, SceneError> {
    let loaded = specula_scene::load(scene, size)?;
    let mut out = io::stderr().lock();
    for warning in &loaded.warnings {
        // Nothing can be said when nobody listens.
        let _ = writeln!(out, "warning: {warning}");
    }
    Ok(loaded)
}
