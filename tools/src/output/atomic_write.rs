//! Writing a single file atomically: it is complete, or it does not exist.
use std::fs;
use std::io;
use std::path::Path;

use super::created_dirs::CreatedDirs;
use super::error::OutputError;
use super::folder::settle_leftovers;
use super::interrupt::Interrupts;
use super::temporary::Temporary;

/// Calls `write` with the path of a temporary file next to `path`, and moves that file to `path`
/// once it is complete. The folder is created if it does not exist; a link to a file remains a
/// link.
///
/// # Errors
/// [`OutputError`] if the operating system refuses.
pub fn write_file(
    path: &Path,
    interrupts: &Interrupts,
    write: impl FnOnce(&Path) -> io::Result<()>,
) -> Result<(), OutputError> {
    let shown = path;
    let followed = path.is_symlink().then(|| path.canonicalize().ok()).flatten();
    let path = followed.as_deref().unwrap_or(path);
    if path.metadata().is_ok_and(|about| !about.is_file() && !about.is_dir()) {
        let reason = io::Error::other("it is not a regular file");
        return Err(OutputError::system(shown)(reason));
    }
    let beside =
        path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    if let Some(at) = beside
        .ancestors()
        .find(|path| path.symlink_metadata().is_ok())
        .filter(|path| !path.is_dir())
    {
        return Err(OutputError::NotAFolder { folder: beside.to_owned(), at: at.to_owned() });
    }
    settle_leftovers([beside]);
    let publish = || {
        let created = CreatedDirs::create(beside, interrupts)?;
        let temporary = Temporary::new_in(beside, interrupts)?;
        // The file keeps its extension, by which picture formats are distinguished.
        let new = temporary.path().join(path.file_name().ok_or(io::ErrorKind::InvalidInput)?);
        write(&new)?;
        fs::rename(&new, path)?;
        drop(temporary);
        created.keep();
        Ok(())
    };
    publish().map_err(OutputError::system(shown))
}
