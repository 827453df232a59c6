//! Ctrl-C and its kin: what is half done is undone before the program ends.
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

use super::temporary;

/// What is half done. Copies are of the same list.
#[derive(Clone, Debug, Default)]
pub struct Interrupts {
    undo: Arc<Mutex<Vec<Undo>>>,
}

/// How something that is half done is undone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Undo {
    /// A temporary folder goes with all that is in it.
    Temporary(PathBuf),
    /// A folder that was created on the way is removed if it is empty.
    Created(PathBuf),
}

/// While it lives, no signal ends the program: what has to be done as a whole is.
#[derive(Debug)]
pub struct Held<'a>(MutexGuard<'a, Vec<Undo>>);

impl Interrupts {
    /// Undoes what is half done when SIGINT, SIGTERM or SIGHUP comes, and ends with status 128 +
    /// signal. Signals that the program's parent had it ignore, as `nohup` does, stay
    /// ignored.
    ///
    /// # Errors
    /// What the system says if it takes no handler.
    #[cfg(unix)]
    pub fn watch() -> io::Result<Interrupts> {
        let interrupts = Interrupts::default();
        let ignored = ignored_signals();
        let heard = ENDING.into_iter().filter(|signal| ignored >> (signal - 1) & 1 == 0);
        let mut signals = signal_hook::iterator::Signals::new(heard)?;
        let shared = interrupts.clone();
        thread::Builder::new().name("signals".to_owned()).spawn(move || {
            if let Some(signal) = signals.forever().next() {
                // Any other thread that wants it waits until the program has ended.
                let held = shared.hold();
                held.0.iter().rev().for_each(Undo::carry_out);
                std::process::exit(128 + signal);
            }
        })?;
        Ok(interrupts)
    }

    /// Elsewhere the next run removes what is left.
    #[cfg(not(unix))]
    pub fn watch() -> io::Result<Interrupts> {
        Ok(Interrupts::default())
    }

    /// It is done, or undone.
    pub fn forget(&self, undo: &Undo) {
        self.hold().forget(undo);
    }

    /// Waits until no signal is being acted on, and keeps others off.
    pub fn hold(&self) -> Held<'_> {
        // Who panicked has left a list that can be read.
        Held(self.undo.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Held<'_> {
    /// Something is half done from now on.
    pub fn add(&mut self, undo: Undo) {
        self.0.push(undo);
    }

    /// It is done, or undone.
    pub fn forget(&mut self, undo: &Undo) {
        self.0.retain(|other| other != undo);
    }
}

impl Undo {
    fn carry_out(&self) {
        match self {
            Undo::Temporary(folder) => remove_while_written(folder),
            // One that holds something, or is gone already, is nothing to complain of.
            Undo::Created(folder) => drop(fs::remove_dir(folder)),
        }
    }
}

/// Tries to remove a folder into which another thread writes, at most.
const TRIES: u32 = 100;
/// Time between two tries.
const PAUSE: Duration = Duration::from_millis(5);

fn remove_while_written(folder: &Path) {
    for _ in 0..TRIES {
        if temporary::remove(folder).is_ok() || folder.symlink_metadata().is_err() {
            return;
        }
        thread::sleep(PAUSE);
    }
}

/// Signals that end a program and leave it time.
#[cfg(unix)]
const ENDING: [i32; 3] =
    [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM, signal_hook::consts::SIGHUP];

/// The signals that this process ignores, a bit each from signal 1 on; none where Linux does not
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
