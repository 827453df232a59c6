//! A core's files alone.
use std::fs;
use std::path::{Path, PathBuf};

use super::made::MadeFolders;
use super::{REPORT, TEMPORARY};
use crate::error::OutputError;

/// Writes files, by name and text, into `folder`, which is made if it is not there; every other file in it stays. Returns their paths.
///
/// # Errors
/// [`OutputError`] if the system refuses, or the folder is a run's and its core is another one.
pub fn write_core(folder: &Path, files: &[(String, String)]) -> Result<Vec<PathBuf>, OutputError> {
    if let Some(at) = folder.ancestors().find(|path| path.symlink_metadata().is_ok()).filter(|path| !path.is_dir()) {
        return Err(OutputError::NotAFolder { folder: folder.to_owned(), at: at.to_owned() });
    }
    let differs = |(name, text): &(String, String)| fs::read(folder.join(name)).ok().as_deref() != Some(text.as_bytes());
    if folder.join(REPORT).exists() && files.iter().any(differs) {
        return Err(OutputError::OtherCore { folder: folder.to_owned() });
    }
    let write = || {
        let made = MadeFolders::make(folder)?;
        let temporary = tempfile::Builder::new().prefix(TEMPORARY).tempdir_in(folder)?;
        for (name, text) in files {
            fs::write(temporary.path().join(name), text)?;
        }
        for (name, _) in files {
            fs::rename(temporary.path().join(name), folder.join(name))?;
        }
        drop(temporary);
        made.keep();
        Ok(())
    };
    write().map_err(OutputError::system(folder))?;
    Ok(files.iter().map(|(name, _)| folder.join(name)).collect())
}
