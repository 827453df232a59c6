//! Folders that had to be created above a path.
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::interrupt::{Interrupts, Undo};

/// Folders that were created, outermost first. Those that are still empty when this is dropped are
/// removed, unless they are kept.
#[derive(Debug)]
pub struct CreatedDirs {
    created: Vec<PathBuf>,
    interrupts: Interrupts,
}

impl CreatedDirs {
    /// Creates `folder` and every missing one above it.
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
                // Another program created it first, and may remove it.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => {
                    // Dropping `folders` locks the list, so the lock is released first.
                    drop(held);
                    return Err(error);
                }
            }
        }
        Ok(folders)
    }

    /// Keeps the folders even if they are empty.
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
            // It is no error if a folder holds something or is gone already.
            let _ = fs::remove_dir(folder);
        }
        self.forget();
    }
}
