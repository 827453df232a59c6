//! What hidden folders are called and hold, and how they are removed.
use std::fs;
use std::io;
use std::path::Path;

/// Beginning of the names of temporary folders. The next program that writes next to one deals with
/// what is left of it.
pub const PREFIX: &str = ".specula-";
/// A file in a temporary folder, locked as long as its program runs.
pub const LOCK: &str = "lock";
/// A file in a temporary folder: the record of the folder that is being replaced.
pub const RECORD: &str = "record.json";
/// A subfolder of a temporary folder: the folder of results has in it the name that it has or will
/// have next to the temporary one.
pub const FOLDER: &str = "folder";

/// Removes a temporary folder. The files that identify it are removed last, so that a kill leaves
/// what the next program understands.
pub fn remove(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = entry.path();
        match entry.file_name() {
            name if name == LOCK || name == RECORD => {}
            _ if entry.file_type()?.is_dir() => fs::remove_dir_all(path)?,
            _ => fs::remove_file(path)?,
        }
    }
    for name in [RECORD, LOCK] {
        match fs::remove_file(folder.join(name)) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
            _ => {}
        }
    }
    fs::remove_dir(folder)
}
