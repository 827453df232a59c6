//! A Verilog file alone.
use std::fs;
use std::path::{Path, PathBuf};

use super::made::MadeFolders;
use super::{REPORT, TEMPORARY};
use crate::error::OutputError;

/// Writes the file `name` into `folder`, which is made if it is not there; every other file in it stays. Returns its path.
///
/// # Errors
/// [`OutputError`] if the system refuses, or the folder is a run's and its Verilog is another one.
pub fn write_verilog(folder: &Path, name: &str, text: &str) -> Result<PathBuf, OutputError> {
    if let Some(at) = folder.ancestors().find(|path| path.symlink_metadata().is_ok()).filter(|path| !path.is_dir()) {
        return Err(OutputError::NotAFolder { folder: folder.to_owned(), at: at.to_owned() });
    }
    let path = folder.join(name);
    if folder.join(REPORT).exists() && fs::read(&path).ok().as_deref() != Some(text.as_bytes()) {
        return Err(OutputError::OtherCore { folder: folder.to_owned() });
    }
    let write = || {
        let made = MadeFolders::make(folder)?;
        let temporary = tempfile::Builder::new().prefix(TEMPORARY).tempdir_in(folder)?;
        let new = temporary.path().join(name);
        fs::write(&new, text)?;
        fs::rename(&new, &path)?;
        drop(temporary);
        made.keep();
        Ok(())
    };
    write().map_err(OutputError::system(&path))?;
    Ok(path)
}
