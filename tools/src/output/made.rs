//! Folders that had to be made on the way to a place.
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Folders that were made, outermost first. Unless they are kept, those that are still empty go again.
#[derive(Debug, Default)]
pub struct MadeFolders {
    made: Vec<PathBuf>,
}

impl MadeFolders {
    /// Makes `folder` and every missing one above it.
    pub fn make(folder: &Path) -> io::Result<MadeFolders> {
        let mut folders = MadeFolders::default();
        let missing: Vec<&Path> = folder.ancestors().take_while(|f| !f.as_os_str().is_empty() && !f.exists()).collect();
        for folder in missing.into_iter().rev() {
            match fs::create_dir(folder) {
                Ok(()) => folders.made.push(folder.to_owned()),
                // Somebody else was quicker, and it is theirs to take away.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Ok(folders)
    }

    /// Leaves them there.
    pub fn keep(mut self) {
        self.made.clear();
    }
}

impl Drop for MadeFolders {
    fn drop(&mut self) {
        for folder in self.made.iter().rev() {
            // One that holds something, or is gone already, is nothing to complain of.
            let _ = fs::remove_dir(folder);
        }
    }
}
