//! Publication: a complete temporary folder is moved to its place.
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::REPORT;
use super::created_dirs::CreatedDirs;
use super::destination::Destination;
use super::disk::{Disk, System};
use super::error::OutputError;
use super::hidden::FOLDER;
use super::interrupt::Interrupts;
use super::own::Contents;
use super::record::{Record, Step};
use super::temporary::Temporary;
use crate::html::ReportFiles;

/// A folder that is being written. Unless it is published, nothing of it remains.
#[derive(Debug)]
pub struct Staging {
    destination: Destination,
    /// The new folder. It is inside the temporary one, which is private to the user as the result
    /// need not be, and has its final name.
    new: PathBuf,
    // Fields are dropped in this order: first what is in the folders that were created.
    temporary: Temporary,
    created: CreatedDirs,
}

impl Destination {
    /// Begins to write the folder.
    pub fn stage(&self) -> Result<Staging, OutputError> {
        let refused = OutputError::system(&self.shown);
        let begin = || {
            let created = CreatedDirs::create(self.parent(), self.interrupts())?;
            let temporary = Temporary::new_in(self.parent(), self.interrupts())?;
            let new =
                temporary.path().join(FOLDER).join(self.place.file_name().unwrap_or_default());
            fs::create_dir_all(&new)?;
            Ok(Staging { destination: self.clone(), new, temporary, created })
        };
        begin().map_err(refused)
    }

    fn parent(&self) -> &Path {
        // The path is absolute and has a name, so it has a parent.
        self.place.parent().unwrap_or(&self.place)
    }
}

impl Staging {
    /// The path of the file `name` while it is being written.
    pub fn file(&self, name: &str) -> PathBuf {
        self.new.join(name)
    }

    /// The path of a temporary file that is not published.
    pub fn scratch(&self, name: &str) -> PathBuf {
        self.temporary.path().join(name)
    }

    /// Turns the system's error into the error of having failed to write the file `name`, with its
    /// final path.
    pub fn failed(&self, name: &str) -> impl FnOnce(io::Error) -> OutputError + use<> {
        let path = self.destination.shown.join(name);
        move |reason| OutputError::System { path, reason }
    }

    /// Puts the folder in its place. Files of an earlier run are removed; any others stay.
    pub fn publish(self) -> Result<(), OutputError> {
        self.publish_by(&mut System)
    }

    pub(super) fn publish_by(self, disk: &mut dyn Disk) -> Result<(), OutputError> {
        let Staging { destination, new, temporary, created } = self;
        let interrupts: Interrupts = destination.interrupts().clone();
        let held = interrupts.hold();
        let published = if destination.place.exists() {
            replace(&destination, &new, temporary.path(), disk)
        } else {
            disk.rename(&new, &destination.place).map_err(OutputError::system(&destination.shown))
        };
        match published {
            // It must not be deleted with the temporary folder.
            Err(OutputError::Kept { .. }) => temporary.keep(held),
            _ => {
                drop(held);
                drop(temporary);
            }
        }
        if published.is_ok() {
            created.keep();
        }
        published
    }
}

impl ReportFiles for Staging {
    type Error = io::Error;

    fn content(&self, name: &str) -> io::Result<Option<Vec<u8>>> {
        // A report lists only files in its own folder.
        let is_a_name = Path::new(name).file_name().is_some_and(|file| file == name);
        let path = is_a_name.then(|| self.file(name)).filter(|path| path.is_file());
        path.map(fs::read).transpose()
    }
}

fn replace(
    destination: &Destination,
    new: &Path,
    temporary: &Path,
    disk: &mut dyn Disk,
) -> Result<(), OutputError> {
    let (shown, place) = (&destination.shown, &destination.place);
    let refused = || OutputError::system(shown);
    let contents = Contents::of(place).map_err(refused())?;
    let record = Record {
        step: Step::Exchange,
        old: contents.own.clone(),
        new: names_in(new).map_err(refused())?,
    };
    // A file may have been put there while the results were computed.
    if let Some(name) = contents.clash(&record.new) {
        return Err(OutputError::InTheWay { folder: shown.clone(), name: name.clone() });
    }
    record.write(temporary, disk).map_err(refused())?;
    let linked = link_others(place, new, &record, disk).map_err(refused())?;
    match disk.exchange(new, place) {
        Ok(()) => finish(new, place, &record, disk)
            .map_err(|(path, reason)| OutputError::Kept { path, reason }),
        Err(error) if error.kind() == io::ErrorKind::Unsupported => {
            linked
                .iter()
                .try_for_each(|name| disk.remove_file(&new.join(name)))
                .map_err(refused())?;
            let record = Record { step: Step::FileByFile, ..record };
            record.write(temporary, disk).map_err(refused())?;
            finish(new, place, &record, disk)
                .map_err(|(path, reason)| OutputError::Kept { path, reason })
        }
        Err(reason) => Err(refused()(reason)),
    }
}

fn names_in(folder: &Path) -> io::Result<BTreeSet<String>> {
    fs::read_dir(folder)?
        .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
        .collect()
}

/// Gives every foreign file a second name in the new folder, so that it is always present. What
/// cannot have one, such as a folder, is moved after the exchange.
fn link_others(
    place: &Path,
    new: &Path,
    record: &Record,
    disk: &mut dyn Disk,
) -> io::Result<Vec<OsString>> {
    let mut linked = vec![];
    for entry in fs::read_dir(place)? {
        let (entry_type, name) = entry.map(|entry| (entry.file_type(), entry.file_name()))?;
        let is_others = !record.has(&name.to_string_lossy());
        if is_others
            && entry_type?.is_file()
            && disk.link(&place.join(&name), &new.join(&name)).is_ok()
        {
            linked.push(name);
        }
    }
    Ok(linked)
}

/// Finishes the replacement of `place`: after an exchange, `from` contains what was there before;
/// file by file, `from` contains what is new. The result is the same however often this is done,
/// and whichever part of it was done before.
///
/// # Errors
/// A path that could not be moved, and the reason. It is where it was.
pub fn finish(
    from: &Path,
    place: &Path,
    record: &Record,
    disk: &mut dyn Disk,
) -> Result<(), (PathBuf, io::Error)> {
    match record.step {
        Step::Exchange => bring_back(from, place, record, disk),
        Step::FileByFile => file_by_file(from, place, record, disk),
    }
}

/// Moves foreign files back.
fn bring_back(
    from: &Path,
    place: &Path,
    record: &Record,
    disk: &mut dyn Disk,
) -> Result<(), (PathBuf, io::Error)> {
    let unlisted = |reason| (from.to_owned(), reason);
    for entry in fs::read_dir(from).map_err(unlisted)? {
        let name = entry.map_err(unlisted)?.file_name();
        if record.has(&name.to_string_lossy()) {
            continue;
        }
        let (path, to) = (from.join(&name), place.join(&name));
        if to.symlink_metadata().is_err() {
            disk.rename(&path, &to).map_err(|reason| (path, reason))?;
        } else if !is_same_file(&path, &to) {
            return Err((
                path,
                io::Error::new(io::ErrorKind::AlreadyExists, "another of its name is there"),
            ));
        }
    }
    Ok(())
}

/// Replaces old files by new ones, and removes old ones that have no successor. The report is moved
/// last: it marks the replacement as complete.
fn file_by_file(
    from: &Path,
    place: &Path,
    record: &Record,
    disk: &mut dyn Disk,
) -> Result<(), (PathBuf, io::Error)> {
    for name in record.new.iter().filter(|name| *name != REPORT && from.join(name).exists()) {
        put(name, from, place, disk)?;
    }
    for path in record.old.difference(&record.new).map(|name| place.join(name)) {
        if path.symlink_metadata().is_ok_and(|about| about.is_file()) {
            disk.remove_file(&path).map_err(|reason| (path, reason))?;
        }
    }
    put(REPORT, from, place, disk)
}

fn put(
    name: &str,
    from: &Path,
    place: &Path,
    disk: &mut dyn Disk,
) -> Result<(), (PathBuf, io::Error)> {
    let path = from.join(name);
    disk.rename(&path, &place.join(name)).map_err(|reason| (path, reason))
}

#[cfg(unix)]
fn is_same_file(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity =
        |path: &Path| path.symlink_metadata().map(|about| (about.dev(), about.ino())).ok();
    identity(one).is_some() && identity(one) == identity(other)
}

/// Folders are never exchanged on these systems, so no file has two names.
#[cfg(not(unix))]
fn is_same_file(_: &Path, _: &Path) -> bool {
    false
}

#[cfg(test)]
mod tests;
