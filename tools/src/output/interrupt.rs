//! Handling of Ctrl-C and similar signals: what is half done is undone before the program ends.
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use super::hidden;

/// The list of what is half done. Clones share the list.
#[derive(Clone, Debug, Default)]
pub struct Interrupts {
    undo: Arc<Mutex<Vec<Undo>>>,
}

/// How something that is half done is undone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Undo {
    /// A temporary folder is removed with all of its contents.
    Temporary(PathBuf),
    /// A folder that was created above a path is removed if it is empty.
    Created(PathBuf),
}

/// A lock that keeps signals from ending the program, so that what must be done as a whole is.
#[derive(Debug)]
pub struct Held<'a>(MutexGuard<'a, Vec<Undo>>);

impl Interrupts {
    /// Starts to watch for SIGINT, SIGTERM and SIGHUP. When one comes, what is half done is undone,
    /// and the program ends with status 128 + signal. Signals that the parent process had ignored,
    /// as `nohup` does, stay ignored.
    ///
    /// # Errors
    /// The operating system's error if no handler can be installed.
    #[cfg(unix)]
    pub fn watch() -> io::Result<Interrupts> {
        let interrupts = Interrupts::default();
        let ignored = ignored_signals();
        let heard = ENDING.into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
        let mut signals = signal_hook::iterator::Signals::new(heard)?;
        let shared = interrupts.clone();
        thread::Builder::new().name("signals".to_owned()).spawn(move || {
            if let Some(signal) = signals.forever().next() {
                // Any other thread that wants the lock waits until the program has ended.
                let held = shared.hold();
                held.0.iter().rev().for_each(Undo::carry_out);
                std::process::exit(128 + signal);
            }
        })?;
        Ok(interrupts)
    }

    /// Watches nothing: on other systems the next run removes what is left.
    #[cfg(not(unix))]
    pub fn watch() -> io::Result<Interrupts> {
        Ok(Interrupts::default())
    }

    /// Removes an entry that is done, or undone.
    pub fn forget(&self, undo: &Undo) {
        self.hold().forget(undo);
    }

    /// Waits until no signal is being handled, and keeps others off.
    pub fn hold(&self) -> Held<'_> {
        // A thread that panicked has left a list that can still be read.
        Held(self.undo.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Held<'_> {
    /// Adds something that is half done from now on.
    pub fn add(&mut self, undo: Undo) {
        self.0.push(undo);
    }

    /// Removes an entry that is done, or undone.
    pub fn forget(&mut self, undo: &Undo) {
        self.0.retain(|other| other != undo);
    }
}

impl Undo {
    fn carry_out(&self) {
        match self {
            Undo::Temporary(folder) => remove_while_written(folder),
            // It is no error if a folder holds something or is gone already.
            Undo::Created(folder) => drop(fs::remove_dir(folder)),
        }
    }
}

/// Largest number of attempts to remove a folder into which another thread writes.
const TRIES: u32 = 100;
/// Time between two attempts.
const PAUSE: Duration = Duration::from_millis(5);

fn remove_while_written(folder: &Path) {
    for _ in 0..TRIES {
        if hidden::remove(folder).is_ok() || folder.symlink_metadata().is_err() {
            return;
        }
        thread::sleep(PAUSE);
    }
}

/// Signals that end a program but leave it time to clean up.
#[cfg(unix)]
const ENDING: [i32; 3] =
    [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM, signal_hook::consts::SIGHUP];

/// The signals that this process ignores, one bit each, from signal 1 on; 0 where Linux does not
/// tell.
#[cfg(unix)]
fn ignored_signals() -> u64 {
    const LONGEST: u64 = 1 << 16;
    let status = specula_scene::regular::read_regular(Path::new("/proc/self/status"), LONGEST)
        .unwrap_or_default();
    let mask = |line: &str| u64::from_str_radix(line.strip_prefix("SigIgn:")?.trim(), 16).ok();
    String::from_utf8_lossy(&status).lines().find_map(mask).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_half_done_is_undone_and_nothing_else() {
        let place = tempfile::tempdir().unwrap();
        let [kept, created, temporary] =
            ["kept", "kept/created", "kept/created/temporary"].map(|name| place.path().join(name));
        fs::create_dir_all(temporary.join("folder/deep")).unwrap();
        fs::write(temporary.join("folder/deep/file"), "text").unwrap();
        let interrupts = Interrupts::default();
        for undo in [
            Undo::Created(kept.clone()),
            Undo::Created(created.clone()),
            Undo::Temporary(temporary),
        ] {
            interrupts.hold().add(undo);
        }
        interrupts.forget(&Undo::Created(kept.clone()));
        interrupts.hold().0.iter().rev().for_each(Undo::carry_out);
        assert!(kept.exists() && !created.exists());
    }
}
