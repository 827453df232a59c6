//! A folder in which what programs have in common is kept, so that each compiles its core alone.
use std::fs::{self, File};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::PathBuf;

use super::common::{self, Common};
use super::{Effort, HEADERS, Kind, VERILATOR};
use crate::SimError;

/// A folder that stays, for those who build many programs. Any number of threads and processes may
/// use it at once.
///
/// With a core of some hundred signals it is seven eighths of the time that [`Effort::FastBuild`]
/// takes.
#[derive(Clone, Debug)]
pub struct Library {
    folder: PathBuf,
}

impl Library {
    /// The library in a folder, which is made when the first program is built.
    pub fn new(folder: impl Into<PathBuf>) -> Library {
        Library { folder: folder.into() }
    }

    /// What programs of this kind have in common; made unless it is there.
    pub(super) fn common(&self, kind: Kind, effort: Effort) -> Result<Common, SimError> {
        let unusable = || SimError::file(format!("use the folder {}", self.folder.display()));
        let folder = self.folder.join(name(kind, effort)?);
        fs::create_dir_all(&self.folder).map_err(unusable())?;
        // Held until the end of this function: others wait, and find what is made here.
        let lock = self.lock().map_err(unusable())?;
        if !folder.exists() {
            let begun = tempfile::tempdir_in(&self.folder).map_err(unusable())?;
            common::make(begun.path(), kind, effort)?;
            // What is there is whole.
            fs::rename(begun.keep(), &folder).map_err(unusable())?;
        }
        drop(lock);
        Common::within(folder)
    }

    fn lock(&self) -> io::Result<File> {
        let file = File::create(self.folder.join("lock"))?;
        file.lock()?;
        Ok(file)
    }
}

/// The name of what goes with a Verilator, its options and the compiler's, and the headers.
fn name(kind: Kind, effort: Effort) -> Result<String, SimError> {
    let mut hasher = DefaultHasher::new();
    (VERILATOR.version()?, kind.options(), effort.option(), HEADERS).hash(&mut hasher);
    Ok(format!("{}-{:016x}", kind.directory(), hasher.finish()))
}
