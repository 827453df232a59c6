//! A folder that results go into.
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use super::interrupt::Interrupts;

/// A folder that can be created or replaced.
#[derive(Clone, Debug)]
pub struct Destination {
    /// The path as the user wrote it.
    pub shown: PathBuf,
    /// The absolute path, with symbolic links resolved.
    pub(super) place: PathBuf,
    pub(super) interrupts: Interrupts,
}

impl Destination {
    /// The path of a folder beside it, whose name is longer by a suffix, and that path as the user
    /// would write it.
    pub fn beside(&self, suffix: &str) -> (PathBuf, PathBuf) {
        let longer = |folder: &Path| {
            // Without a slash at its end.
            let mut name: OsString = folder.components().collect::<PathBuf>().into();
            name.push(suffix);
            PathBuf::from(name)
        };
        (longer(&self.place), longer(&self.shown))
    }

    /// What is undone when the program is interrupted.
    pub fn interrupts(&self) -> &Interrupts {
        &self.interrupts
    }
}
