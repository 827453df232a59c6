//! Folders that had to be made on the way to a place.
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::interrupt::{Interrupts, Undo};

/// Folders that were made, outermost first. Unless they are kept, those that are still empty go
/// again.
#[derive(Debug)]
pub struct CreatedDirs {
    created: Vec<PathBuf>,
    interrupts: Interrupts,
}

impl CreatedDirs {
    /// Makes `folder` and every missing one above it.
    pub fn create(folder: &Path, interrupts: &Interrupts) -> io::Result<CreatedDirs> {
        let mut folders = CreatedDirs { created: vec![], interrupts: interrupts.clone() };
        let missing: Vec<&Path> =
            folder.ancestors().take_while(|f| !f.as_os_str().is_empty() && !f.exists()).collect();
        for folder in missing.into_iter().rev() {
            let mut held = interrupts.hold();
            match fs::create_dir(folder) {
                Ok(()) => {
                    folders.created.push(folder.to_owned());
                    held.add(Undo::Created(folder.to_owned()));
                }
                // Somebody else was quicker, and it is theirs to take away.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => {
                    // Dropping what was made waits for the list.
                    drop(held);
                    return Err(error);
                }
            }
        }
        Ok(folders)
    }

    /// Leaves them there.
    pub fn keep(mut self) {
        self.forget();
        self.created.clear();
    }

    fn forget(&self) {
        let mut held = self.interrupts.hold();
        self.created.iter().for_each(|folder| held.forget(&Undo::Created(folder.clone())));
    }
}

impl Drop for CreatedDirs {
    fn drop(&mut self) {
        for folder in self.created.iter().rev() {
            // One that holds something, or is gone already, is nothing to complain of.
            let _ = fs::remove_dir(folder);
        }
        self.forget();
    }
}
