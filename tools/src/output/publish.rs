//! From a complete temporary folder to its place.
use std::collections::HashSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::made::MadeFolders;
use super::{Destination, TEMPORARY};
use crate::error::OutputError;
use crate::html::Beside;

/// A folder being written; unless it is published, nothing of it remains.
#[derive(Debug)]
pub struct Staging {
    destination: Destination,
    /// A folder inside the temporary one, since that is private to the user and the result need not be.
    new: PathBuf,
    // Dropped in this order: first what is in the folders that were made.
    temporary: TempDir,
    made: MadeFolders,
}

impl Destination {
    /// Begins to write.
    pub fn stage(&self) -> Result<Staging, OutputError> {
        let refused = OutputError::system(&self.shown);
        let begin = || {
            let made = MadeFolders::make(self.parent())?;
            let temporary = self.temporary()?;
            let new = temporary.path().join("new");
            fs::create_dir(&new)?;
            Ok(Staging { destination: self.clone(), new, temporary, made })
        };
        begin().map_err(refused)
    }

    fn parent(&self) -> &Path {
        // The place is absolute and has a name.
        self.place.parent().unwrap_or(&self.place)
    }

    fn temporary(&self) -> io::Result<TempDir> {
        tempfile::Builder::new().prefix(TEMPORARY).tempdir_in(self.parent())
    }
}

impl Staging {
    /// The path of the file `name` while it is being written.
    pub fn file(&self, name: &str) -> PathBuf {
        self.new.join(name)
    }

    /// The error of having failed to write the file `name`, by the path it would have had.
    pub fn failed(&self, name: &str) -> impl FnOnce(io::Error) -> OutputError + use<> {
        let path = self.destination.shown.join(name);
        move |reason| OutputError::System { path, reason }
    }

    /// Puts the folder in its place. Files of an earlier run go; any others that were there stay.
    pub fn publish(self) -> Result<(), OutputError> {
        let Staging { destination, new, temporary, made } = self;
        if destination.place.exists() {
            destination.replace(&new)?;
        } else {
            fs::rename(&new, &destination.place).map_err(OutputError::system(&destination.shown))?;
        }
        drop(temporary);
        made.keep();
        Ok(())
    }
}

impl Beside for Staging {
    fn file(&self, name: &str) -> Option<PathBuf> {
        // Nothing outside the folder is part of a report.
        let is_a_name = Path::new(name).file_name().is_some_and(|file| file == name);
        is_a_name.then(|| Staging::file(self, name))
    }
}

impl Destination {
    fn replace(&self, new: &Path) -> Result<(), OutputError> {
        let refused = || OutputError::system(&self.shown);
        let retired = self.temporary().map_err(refused())?;
        let old = retired.path().join("old");
        fs::rename(&self.place, &old).map_err(refused())?;
        if let Err(reason) = fs::rename(new, &self.place) {
            if fs::rename(&old, &self.place).is_err() {
                // It must not be deleted with the temporary folder.
                let _ = retired.keep();
            }
            return Err(refused()(reason));
        }
        move_others(&old, &self.place, &self.own).map_err(|(path, reason)| {
            let _ = retired.keep();
            OutputError::Kept { path, reason }
        })
    }
}

/// Moves everything but `own` from one folder to the other.
fn move_others(from: &Path, to: &Path, own: &HashSet<String>) -> Result<(), (PathBuf, io::Error)> {
    let unlisted = |reason| (from.to_owned(), reason);
    for entry in fs::read_dir(from).map_err(unlisted)? {
        let name = entry.map_err(unlisted)?.file_name();
        if !own.contains(name.to_string_lossy().as_ref()) {
            let path = from.join(&name);
            fs::rename(&path, to.join(&name)).map_err(|reason| (path, reason))?;
        }
    }
    Ok(())
}
