//! What is written down before a folder is replaced, so that another program can finish it.
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

use serde::{Deserialize, Serialize};
use specula_scene::regular::read_regular;

use super::disk::Disk;
use super::temporary::RECORD;

/// The longest record that is read, in bytes.
const LONGEST: u64 = 64 << 20;

/// A folder that is being replaced.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Record {
    /// How far it is.
    pub step: Step,
    /// The files that Specula wrote into the folder as it was.
    pub old: BTreeSet<String>,
    /// The files of the new one.
    pub new: BTreeSet<String>,
}

/// How a folder is replaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Step {
    /// Both folders change places, and what is the user's goes back.
    Exchange,
    /// File by file, where folders cannot change places.
    FileByFile,
}

impl Record {
    /// Reads that of a temporary folder; none if it has none, or none that was written here.
    pub fn of(temporary: &Path) -> Option<Record> {
        serde_json::from_slice(&read_regular(&temporary.join(RECORD), LONGEST).ok()?).ok()
    }

    /// Writes it into a temporary folder. When this returns, it outlasts a power cut.
    pub fn write(&self, temporary: &Path, disk: &mut dyn Disk) -> io::Result<()> {
        let begun = temporary.join("record");
        let mut file = File::create(&begun)?;
        file.write_all(&serde_json::to_vec(self)?)?;
        file.sync_all()?;
        disk.rename(&begun, &temporary.join(RECORD))
    }

    /// Whether the file `name` is Specula's.
    pub fn has(&self, name: &str) -> bool {
        self.old.contains(name) || self.new.contains(name)
    }
}
