//! A folder that results go into.
use std::path::PathBuf;

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
    /// The path of a folder beside it, whose name is longer by a suffix.
    pub fn beside(&self, suffix: &str) -> PathBuf {
        // It has a name.
        let mut name = self.place.file_name().unwrap_or_default().to_owned();
        name.push(suffix);
        self.place.with_file_name(name)
    }

    /// What is undone when the program is interrupted.
    pub fn interrupts(&self) -> &Interrupts {
        &self.interrupts
    }
}
