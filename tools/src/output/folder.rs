//! The folder that a run writes, checked before the run.
use std::collections::HashSet;
use std::env;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::{REPORT, TEMPORARY};
use crate::error::OutputError;

/// A folder that can be written or replaced.
#[derive(Clone, Debug)]
pub struct Destination {
    /// As the user wrote it.
    pub shown: PathBuf,
    /// Where it is, symbolic links followed.
    pub(super) place: PathBuf,
    /// Files that may be taken away when it is replaced.
    pub(super) own: HashSet<String>,
}

impl Destination {
    /// Checks that `folder` can be written; `files` are the names that will stand in it.
    ///
    /// # Errors
    /// [`OutputError`] if something is in the way that Specula did not write, or the system does not let us write there.
    pub fn check(folder: &Path, files: &[String]) -> Result<Destination, OutputError> {
        let place = place_of(folder)?;
        let mut own: HashSet<String> = files.iter().cloned().collect();
        if place.exists() {
            own.extend(own_files(folder, &place, &own)?);
            refuse_current(folder, &place)?;
        }
        probe(folder)?;
        Ok(Destination { shown: folder.to_owned(), place, own })
    }
}

/// The absolute path of `folder`, which is a folder or is not there.
fn place_of(folder: &Path) -> Result<PathBuf, OutputError> {
    let there = |path: &Path| path.symlink_metadata().is_ok();
    // Each folder above must be one too; the last ancestor of a relative path is the empty one, the current folder.
    if let Some(at) = folder.ancestors().find(|path| there(path)).filter(|path| !path.is_dir()) {
        return Err(OutputError::NotAFolder { folder: folder.to_owned(), at: at.to_owned() });
    }
    let absolute = if there(folder) { folder.canonicalize() } else { std::path::absolute(folder) };
    let absolute = absolute.map_err(OutputError::system(folder))?;
    if absolute.file_name().is_none() {
        return Err(OutputError::system(folder)(io::Error::new(io::ErrorKind::InvalidInput, "it has no name")));
    }
    Ok(absolute)
}

/// What of an earlier run's report is read again.
#[derive(Deserialize)]
struct Earlier {
    files: Vec<String>,
}

/// The files of the run that wrote the folder; none if there is no report but nothing of anybody else's either.
fn own_files(folder: &Path, place: &Path, expected: &HashSet<String>) -> Result<Vec<String>, OutputError> {
    let report = fs::read(place.join(REPORT)).ok().and_then(|text| serde_json::from_slice::<Earlier>(&text).ok());
    if let Some(earlier) = report {
        return Ok(earlier.files);
    }
    let names: io::Result<Vec<String>> = fs::read_dir(place)
        .and_then(|entries| entries.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned())).collect());
    let names = names.map_err(OutputError::system(folder))?;
    // The first of them by name, so that the same folder gives the same message.
    match names.into_iter().filter(|name| name == REPORT || !expected.contains(name)).min() {
        Some(foreign) => Err(OutputError::Foreign { folder: folder.to_owned(), foreign }),
        None => Ok(vec![]),
    }
}

/// A shell that stands in a folder which is replaced stands in a deleted one afterwards.
fn refuse_current(folder: &Path, place: &Path) -> Result<(), OutputError> {
    let current = env::current_dir().and_then(|current| current.canonicalize()).map_err(OutputError::system(folder))?;
    if current.starts_with(place) { Err(OutputError::Current { folder: folder.to_owned() }) } else { Ok(()) }
}

/// Tries to write where the folder's nearest existing ancestor is, so that a long run does not end in a refusal.
fn probe(folder: &Path) -> Result<(), OutputError> {
    let above = folder.parent().unwrap_or(folder);
    let there = above.ancestors().find(|path| path.exists()).unwrap_or(Path::new("."));
    let there = if there.as_os_str().is_empty() { Path::new(".") } else { there };
    let probe = tempfile::Builder::new().prefix(TEMPORARY).tempdir_in(there);
    probe.map(drop).map_err(|reason| OutputError::System { path: folder.to_owned(), reason })
}
