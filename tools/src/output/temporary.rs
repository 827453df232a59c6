//! Hidden temporary folders in which results are made before they are put in their places.
use std::fs::{File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::hidden::{LOCK, PREFIX, remove};
use super::interrupt::{Held, Interrupts, Undo};

/// A temporary folder of this program. It is removed with its contents when it is dropped.
#[derive(Debug)]
pub struct Temporary {
    path: PathBuf,
    /// `None` where the file system has no locks: then what a kill leaves is never removed.
    #[expect(dead_code, reason = "it is locked until it is closed")]
    lock: Option<File>,
    interrupts: Interrupts,
    kept: bool,
}

impl Temporary {
    /// Makes a temporary folder in an existing folder.
    pub fn new_in(place: &Path, interrupts: &Interrupts) -> io::Result<Temporary> {
        loop {
            let path = hidden_folder(place, interrupts)?;
            let lock = locked(&path);
            let temporary = |lock| Temporary {
                path: path.clone(),
                lock,
                interrupts: interrupts.clone(),
                kept: false,
            };
            match lock {
                Ok(Locked::Ours(lock)) => return Ok(temporary(Some(lock))),
                Ok(Locked::Impossible) => return Ok(temporary(None)),
                // Another program took it for a leftover before it was locked.
                Ok(Locked::Taken) => interrupts.forget(&Undo::Temporary(path)),
                Err(reason) => {
                    drop(temporary(None));
                    return Err(reason);
                }
            }
        }
    }

    /// The path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Leaves the folder where it is.
    pub fn keep(mut self, mut held: Held) {
        held.forget(&Undo::Temporary(self.path.clone()));
        self.kept = true;
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if !self.kept {
            // What cannot be removed now is removed by the next program that writes here.
            let _ = remove(&self.path);
            self.interrupts.forget(&Undo::Temporary(self.path.clone()));
        }
    }
}

enum Locked {
    Ours(File),
    Taken,
    Impossible,
}

/// Makes a folder that a signal's handler removes.
fn hidden_folder(place: &Path, interrupts: &Interrupts) -> io::Result<PathBuf> {
    let mut held = interrupts.hold();
    let path = tempfile::Builder::new().prefix(PREFIX).tempdir_in(place)?.keep();
    held.add(Undo::Temporary(path.clone()));
    Ok(path)
}

fn locked(folder: &Path) -> io::Result<Locked> {
    let path = folder.join(LOCK);
    let lock = match File::create_new(&path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Locked::Taken),
        lock => lock?,
    };
    Ok(match lock.try_lock() {
        Ok(()) if path.exists() => Locked::Ours(lock),
        Ok(()) | Err(TryLockError::WouldBlock) => Locked::Taken,
        Err(TryLockError::Error(_)) => Locked::Impossible,
    })
}
