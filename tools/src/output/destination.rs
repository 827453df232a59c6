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
    /// What is undone when the program is interrupted.
    pub fn interrupts(&self) -> &Interrupts {
        &self.interrupts
    }
}
