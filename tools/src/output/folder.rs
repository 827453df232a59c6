//! The output folder of a run, checked before the run.
use std::env;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::destination::Destination;
use super::disk::System;
use super::error::OutputError;
use super::interrupt::Interrupts;
use super::leftovers::settle;
use super::own::Contents;
use super::temporary::Temporary;

impl Destination {
    /// Checks that `folder` can be written; `files` are the names that may stand in it. What killed
    /// programs have left there or next to it is settled first, with a message.
    ///
    /// # Errors
    /// [`OutputError`] if something that Specula did not write is in the way, or if the operating
    /// system does not let us write there.
    pub fn check(
        folder: &Path,
        files: &[String],
        interrupts: &Interrupts,
    ) -> Result<Destination, OutputError> {
        let place = absolute_path(folder)?;
        settle_leftovers(place.parent().into_iter().chain([place.as_path()]));
        if place.exists() {
            refuse_foreign(folder, &place, files)?;
            refuse_current(folder, &place)?;
        }
        probe(folder, interrupts)?;
        Ok(Destination { shown: folder.to_owned(), place, interrupts: interrupts.clone() })
    }
}

/// Settles what killed programs have left in folders that are written into.
pub fn settle_leftovers<'a>(folders: impl IntoIterator<Item = &'a Path>) {
    let mut stderr = io::stderr().lock();
    for settled in folders.into_iter().flat_map(|folder| settle(folder, &mut System)) {
        // The files are in place even if standard error is closed.
        let _ = writeln!(stderr, "{settled}");
    }
}

/// The absolute path of `folder`, which is a folder or does not exist.
fn absolute_path(folder: &Path) -> Result<PathBuf, OutputError> {
    let there = |path: &Path| path.symlink_metadata().is_ok();
    // Each ancestor must be a folder too; the last ancestor of a relative path is empty and stands
    // for the current folder.
    if let Some(at) = folder.ancestors().find(|path| there(path)).filter(|path| !path.is_dir()) {
        return Err(OutputError::NotAFolder { folder: folder.to_owned(), at: at.to_owned() });
    }
    let absolute = if there(folder) { folder.canonicalize() } else { std::path::absolute(folder) };
    let absolute = absolute.map_err(OutputError::system(folder))?;
    if absolute.file_name().is_none() {
        return Err(OutputError::system(folder)(io::Error::new(
            io::ErrorKind::InvalidInput,
            "it has no name",
        )));
    }
    Ok(absolute)
}

/// Refuses foreign files: without a report of Specula's, any; with one, those whose names may be
/// written.
fn refuse_foreign(folder: &Path, place: &Path, files: &[String]) -> Result<(), OutputError> {
    let contents = Contents::of(place).map_err(OutputError::system(folder))?;
    let folder = folder.to_owned();
    // The first of them by name is reported, so that the same folder gives the same message.
    match contents.foreign.first() {
        Some(foreign) if !contents.has_report => {
            Err(OutputError::Foreign { folder, foreign: foreign.clone() })
        }
        _ => match contents.clash(files) {
            Some(name) => Err(OutputError::InTheWay { folder, name: name.clone() }),
            None => Ok(()),
        },
    }
}

/// Refuses the current folder: a shell whose current folder is replaced is in a deleted one
/// afterwards.
fn refuse_current(folder: &Path, place: &Path) -> Result<(), OutputError> {
    let current = env::current_dir()
        .and_then(|current| current.canonicalize())
        .map_err(OutputError::system(folder))?;
    if current.starts_with(place) {
        Err(OutputError::Current { folder: folder.to_owned() })
    } else {
        Ok(())
    }
}

/// Tries to write into the nearest existing ancestor of the folder, so that a long run does not end
/// in a refusal.
fn probe(folder: &Path, interrupts: &Interrupts) -> Result<(), OutputError> {
    let above = folder.parent().unwrap_or(folder);
    let there = above.ancestors().find(|path| path.exists()).unwrap_or(Path::new("."));
    let there = if there.as_os_str().is_empty() { Path::new(".") } else { there };
    let probe = Temporary::new_in(there, interrupts);
    probe.map(drop).map_err(|reason| OutputError::System { path: folder.to_owned(), reason })
}
