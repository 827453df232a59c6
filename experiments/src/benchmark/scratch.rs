//! The folder into which waveforms are written while they are measured.
use std::fs;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::MeasureError;

/// A folder in memory, which some systems have.
const IN_MEMORY: &str = "/dev/shm";
/// Bytes that must be free in it: somewhat more than a waveform of a measurement takes.
const ROOM: u64 = 4 << 30;

/// A temporary folder for one waveform at a time.
pub(crate) struct Scratch {
    directory: TempDir,
}

impl Scratch {
    /// A folder in memory if there is one with enough room, so that the speed of a disk does not
    /// matter; else a folder where temporary files are usually made.
    ///
    /// # Errors
    /// [`MeasureError::Scratch`] if no folder can be made.
    pub fn new() -> Result<Scratch, MeasureError> {
        let mut builder = tempfile::Builder::new();
        builder.prefix("specula-bench-");
        let in_memory = Path::new(IN_MEMORY);
        let made = if has_room(in_memory) { builder.tempdir_in(in_memory).ok() } else { None };
        let directory =
            made.map_or_else(|| builder.tempdir(), Ok).map_err(MeasureError::Scratch)?;
        Ok(Scratch { directory })
    }

    /// The file of the waveform that is being measured.
    pub fn file(&self) -> PathBuf {
        self.directory.path().join("waveform")
    }

    /// Removes the waveform, so that the next measurement does not have to. Not every one writes
    /// it, and an existing file is overwritten.
    pub fn clear(&self) {
        let _ = fs::remove_file(self.file());
    }
}

#[cfg(unix)]
fn has_room(directory: &Path) -> bool {
    rustix::fs::statvfs(directory)
        .is_ok_and(|system| system.f_bavail.saturating_mul(system.f_frsize) >= ROOM)
}

#[cfg(not(unix))]
fn has_room(_: &Path) -> bool {
    false
}
