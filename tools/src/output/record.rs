//! The record that is written before a folder is replaced, so that another program can finish the
//! replacement.
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;

use serde::{Deserialize, Serialize};
use specula_scene::regular::read_regular;

use super::disk::Disk;
use super::hidden::RECORD;

/// Largest record that is read, in bytes.
const LONGEST: u64 = 64 << 20;

/// A folder that is being replaced.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Record {
    /// The kind of replacement.
    pub step: Step,
    /// The files that Specula wrote into the folder as it was.
    pub old: BTreeSet<String>,
    /// The files of the new folder.
    pub new: BTreeSet<String>,
}

/// How a folder is replaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Step {
    /// Both folders are exchanged, and the user's files are moved back.
    Exchange,
    /// Files are moved one by one, where folders cannot be exchanged.
    FileByFile,
}

impl Record {
    /// Reads the record of a temporary folder; `None` if it has none, or one that Specula did not
    /// write.
    pub fn of(temporary: &Path) -> Option<Record> {
        serde_json::from_slice(&read_regular(&temporary.join(RECORD), LONGEST).ok()?).ok()
    }

    /// Writes the record into a temporary folder. Once this returns, the record survives a power
    /// cut.
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
