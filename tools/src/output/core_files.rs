//! Writing a core's files into a folder that may hold others.
use std::fs;
use std::path::{Path, PathBuf};

use specula_scene::regular::read_regular;

use super::created_dirs::CreatedDirs;
use super::error::OutputError;
use super::folder::settle_leftovers;
use super::interrupt::Interrupts;
use super::own::Contents;
use super::temporary::Temporary;

/// Writes files, given by name and text, into `folder`, which is created if it does not exist;
/// every other file in it stays. Returns their paths.
///
/// # Errors
/// [`OutputError`] if the operating system refuses, if a foreign file has one of the names, or if
/// the folder is a run's and has another core.
pub fn write_core(
    folder: &Path,
    files: &[(String, String)],
    interrupts: &Interrupts,
) -> Result<Vec<PathBuf>, OutputError> {
    if let Some(at) = folder
        .ancestors()
        .find(|path| path.symlink_metadata().is_ok())
        .filter(|path| !path.is_dir())
    {
        return Err(OutputError::NotAFolder { folder: folder.to_owned(), at: at.to_owned() });
    }
    settle_leftovers([folder]);
    refuse(folder, files)?;
    let write = || {
        let created = CreatedDirs::create(folder, interrupts)?;
        let temporary = Temporary::new_in(folder, interrupts)?;
        for (name, text) in files {
            fs::write(temporary.path().join(name), text)?;
        }
        let held = interrupts.hold();
        for (name, _) in files {
            fs::rename(temporary.path().join(name), folder.join(name))?;
        }
        drop(held);
        drop(temporary);
        created.keep();
        Ok(())
    };
    write().map_err(OutputError::system(folder))?;
    Ok(files.iter().map(|(name, _)| folder.join(name)).collect())
}

fn refuse(folder: &Path, files: &[(String, String)]) -> Result<(), OutputError> {
    let contents = Contents::of(folder).map_err(OutputError::system(folder))?;
    if let Some(name) = contents.clash(files.iter().map(|(name, _)| name)) {
        return Err(OutputError::InTheWay { folder: folder.to_owned(), name: name.clone() });
    }
    let differs = |(name, text): &(String, String)| {
        let there = read_regular(&folder.join(name), text.len() as u64);
        there.ok().as_deref() != Some(text.as_bytes())
    };
    if contents.has_report && files.iter().any(differs) {
        return Err(OutputError::OtherCore { folder: folder.to_owned() });
    }
    Ok(())
}
