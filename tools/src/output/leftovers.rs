//! Recovery after programs that were killed: the user's files are put back, Specula's are removed.
use std::fmt;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::REPORT;
use super::disk::Disk;
use super::hidden::{FOLDER, LOCK, PREFIX, RECORD, remove};
use super::publish::finish;
use super::record::{Record, Step};

/// What was done about a leftover.
#[derive(Debug)]
pub enum Settled {
    /// The folder held no foreign file and has been removed.
    Removed(PathBuf),
    /// The folder whose replacement was interrupted now has everything that belongs in it.
    Finished(PathBuf),
    /// The leftover is unchanged, for the given reason.
    Left(PathBuf, String),
}

impl fmt::Display for Settled {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Settled::Removed(path) => {
                write!(f, "removed `{}`, which an interrupted program had left", path.display())
            }
            Settled::Finished(path) => {
                write!(
                    f,
                    "put everything in its place in `{}`, where a program had been interrupted",
                    path.display()
                )
            }
            Settled::Left(path, reason) => {
                write!(
                    f,
                    "an interrupted program has left `{}`, and it stays there: {reason}",
                    path.display()
                )
            }
        }
    }
}

/// Settles everything that killed programs have left in a folder. What belongs to programs that
/// still run is left alone. A folder that does not exist or cannot be listed has no leftovers.
pub fn settle(place: &Path, disk: &mut dyn Disk) -> Vec<Settled> {
    let Ok(entries) = fs::read_dir(place) else { return vec![] };
    let is_leftover = |entry: &fs::DirEntry| {
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        is_folder && entry.file_name().to_string_lossy().starts_with(PREFIX)
    };
    let mut found: Vec<PathBuf> =
        entries.flatten().filter(is_leftover).map(|entry| entry.path()).collect();
    found.sort();
    found.iter().filter_map(|leftover| settle_one(leftover, place, disk)).collect()
}

fn settle_one(leftover: &Path, place: &Path, disk: &mut dyn Disk) -> Option<Settled> {
    let left = |reason: String| Some(Settled::Left(leftover.to_owned(), reason));
    let lock = match File::open(leftover.join(LOCK)) {
        Ok(lock) => lock,
        // It belongs to a program that was killed at once, or to one that will lock it in a moment
        // and, if it is removed, take another folder.
        Err(error)
            if error.kind() == io::ErrorKind::NotFound && fs::remove_dir(leftover).is_ok() =>
        {
            return None;
        }
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return left(
                "nothing tells whose files are in it; look through it and remove it".to_owned(),
            );
        }
        // It belongs to another user.
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => return None,
        Err(error) => return left(error.to_string()),
    };
    match lock.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => return None,
        Err(TryLockError::Error(error)) => return left(error.to_string()),
    }
    let settled = match Record::of(leftover) {
        None if leftover.join(RECORD).symlink_metadata().is_ok() => {
            return left("its record is damaged; look through it and remove it".to_owned());
        }
        None => Settled::Removed(leftover.to_owned()),
        Some(record) => match finished(leftover, place, &record, disk) {
            Ok(settled) => settled,
            Err((path, reason)) => {
                return left(format!("`{}` cannot be moved: {reason}", path.display()));
            }
        },
    };
    match remove(leftover) {
        Ok(()) => Some(settled),
        Err(error) => left(error.to_string()),
    }
}

/// Finishes the replacement of the folder that is in a leftover.
fn finished(
    leftover: &Path,
    place: &Path,
    record: &Record,
    disk: &mut dyn Disk,
) -> Result<Settled, (PathBuf, io::Error)> {
    let held = leftover.join(FOLDER);
    let failed = |reason| (held.clone(), reason);
    let mut settled = Settled::Removed(leftover.to_owned());
    let entries = match fs::read_dir(&held) {
        // It was being removed.
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(settled),
        entries => entries.map_err(failed)?,
    };
    for entry in entries {
        let entry = entry.map_err(failed)?;
        let (from, to) = (entry.path(), place.join(entry.file_name()));
        if !needs_finishing(&from, record).map_err(failed)? {
            continue;
        }
        if !to.exists() {
            disk.make_folder(&to).map_err(failed)?;
        }
        finish(&from, &to, record, disk)?;
        settled = Settled::Finished(to);
    }
    Ok(settled)
}

/// Whether the folder contains something that has to be moved.
fn needs_finishing(from: &Path, record: &Record) -> io::Result<bool> {
    let names =
        fs::read_dir(from)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let names: Vec<String> = names.collect::<io::Result<_>>()?;
    Ok(match record.step {
        Step::Exchange => names.iter().any(|name| !record.has(name)),
        // The report is moved last.
        Step::FileByFile => names.iter().any(|name| name == REPORT),
    })
}
