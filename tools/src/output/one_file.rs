//! A file alone, wherever the user wants it.
use std::io;
use std::path::Path;

use super::TEMPORARY;
use crate::error::OutputError;

/// Lets `write` make a file beside `path`, and moves it there once it is complete. The folder has to be there.
///
/// # Errors
/// [`OutputError`] if the system refuses.
pub fn write_file(path: &Path, write: impl FnOnce(&Path) -> io::Result<()>) -> Result<(), OutputError> {
    let beside = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let publish = || {
        let temporary = tempfile::Builder::new().prefix(TEMPORARY).tempdir_in(beside)?;
        // With the same ending, by which pictures are told apart.
        let new = temporary.path().join(path.file_name().ok_or(io::ErrorKind::InvalidInput)?);
        write(&new)?;
        std::fs::rename(&new, path)
    };
    publish().map_err(OutputError::system(path))
}
