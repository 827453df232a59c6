//! What an interrupted run leaves: the frames that are done, each with its picture.
//!
//! They are in a folder beside the one that the run is to write, which stays as it was until
//! everything is there (decision 0050).
use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::hash::{DefaultHasher, Hasher};
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::{Deserialize, Serialize};
use specula_scene::regular::read_regular;
use specula_testbench::Image;

use super::{ShadedFrame, picture_name};
use crate::output::{Destination, OutputError, PROGRAM, Staging};
use crate::picture;

/// What is added to the name of the folder that a run writes.
const SUFFIX: &str = ".partial";
/// Name of the journal.
const JOURNAL: &str = "frames.jsonl";
/// What is added to the name of a picture that is being written.
const NEW: &str = ".new";
/// Largest journal that is read, in bytes; a frame takes some hundred.
const LONGEST_JOURNAL: u64 = 64 << 20;
/// Largest picture that is read, in bytes: more than one of 8192 x 8192 pixels takes.
const LONGEST_PICTURE: u64 = 256 << 20;

/// The frames of a run that are done.
#[derive(Debug)]
pub struct Partial {
    folder: PathBuf,
    /// The journal, open for appending; it is locked until it is closed.
    journal: Mutex<File>,
}

/// What a folder holds of a run.
#[derive(Debug, Default)]
pub struct Known {
    /// The frames whose pictures are there, by their numbers.
    pub frames: BTreeMap<u32, ShadedFrame>,
    /// The folder as the user knows it, if what was in it is of another run and has been removed.
    pub replaced: Option<PathBuf>,
}

/// The first line of a journal.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Head {
    program: String,
    /// A hash of everything that decides what frames become.
    fingerprint: String,
}

/// Any other line.
#[derive(Debug, Serialize, Deserialize)]
struct Line {
    /// A hash of the picture's file.
    picture: String,
    frame: ShadedFrame,
}

impl Partial {
    /// Opens what an interrupted run left for this destination, or begins anew. While another run
    /// has it open, this one keeps its frames to itself.
    ///
    /// # Errors
    /// [`OutputError`] if something that Specula did not write is in its place, or if the operating
    /// system refuses.
    pub fn open(
        destination: &Destination,
        staging: &Staging,
        fingerprint: &str,
    ) -> Result<(Partial, Known), OutputError> {
        let (folder, shown) = destination.beside(SUFFIX);
        refuse_foreign(&folder, &shown)?;
        let begin = || {
            let (folder, journal) = match opened(&folder)? {
                Some(journal) => (folder, journal),
                None => {
                    let own = staging.scratch("partial");
                    let journal = opened(&own)?.ok_or(io::ErrorKind::WouldBlock)?;
                    (own, journal)
                }
            };
            let partial = Partial { folder, journal: Mutex::new(journal) };
            let head = Head { program: PROGRAM.to_owned(), fingerprint: fingerprint.to_owned() };
            let known = partial.continued(&head, &shown)?;
            Ok((partial, known))
        };
        begin().map_err(OutputError::system(&shown))
    }

    /// Reads the journal, and cuts off what is damaged at its end, or all of it if it is of another
    /// run.
    fn continued(&self, head: &Head, shown: &Path) -> io::Result<Known> {
        let bytes = read_regular(&self.folder.join(JOURNAL), LONGEST_JOURNAL)?;
        // A line that was being written has no end.
        let whole = bytes.iter().rposition(|&byte| byte == b'\n').map_or(0, |end| end + 1);
        let mut lines = bytes[..whole].split(|&byte| byte == b'\n');
        let first = lines.next().and_then(|line| serde_json::from_slice::<Head>(line).ok());
        if first.as_ref() == Some(head) {
            let lines = lines.filter_map(|line| serde_json::from_slice::<Line>(line).ok());
            let there = lines.filter(|line| self.has_picture(line));
            let frames = there.map(|Line { frame, .. }| (frame.frame, frame)).collect();
            self.cut(whole as u64)?;
            return Ok(Known { frames, replaced: None });
        }
        self.remove_pictures()?;
        self.cut(0)?;
        self.append(head)?;
        Ok(Known { replaced: (whole > 0).then(|| shown.to_owned()), ..Known::default() })
    }

    fn has_picture(&self, line: &Line) -> bool {
        let picture = self.folder.join(picture_name(line.frame.frame));
        read_regular(&picture, LONGEST_PICTURE).is_ok_and(|bytes| hash(&bytes) == line.picture)
    }

    /// Shortens the journal.
    fn cut(&self, bytes: u64) -> io::Result<()> {
        let mut journal = self.journal.lock().unwrap_or_else(PoisonError::into_inner);
        journal.set_len(bytes)?;
        journal.seek(SeekFrom::End(0)).map(drop)
    }

    fn append(&self, line: &impl Serialize) -> io::Result<()> {
        let text = serde_json::to_string(line)? + "\n";
        // A thread that panicked has left whole lines.
        let mut journal = self.journal.lock().unwrap_or_else(PoisonError::into_inner);
        // A line is written at once, so an interrupted program leaves a whole line or a damaged last
        // one.
        journal.write_all(text.as_bytes())?;
        journal.flush()
    }

    /// Adds a frame that is done; once this returns, it and its picture are there.
    ///
    /// # Errors
    /// The system's error if one of them cannot be written.
    pub fn add(&self, frame: &ShadedFrame, image: &Image) -> io::Result<()> {
        let (name, bytes) = (picture_name(frame.frame), picture::image_png(image)?);
        let new = self.folder.join(format!("{name}{NEW}"));
        fs::write(&new, &bytes)?;
        fs::rename(&new, self.folder.join(name))?;
        self.append(&Line { picture: hash(&bytes), frame: frame.clone() })
    }

    /// Gives the picture of a frame its place among the results; it stays here, too.
    ///
    /// # Errors
    /// The system's error if it cannot be linked or copied.
    pub fn put(&self, number: u32, staging: &Staging) -> io::Result<()> {
        let name = picture_name(number);
        let (from, to) = (self.folder.join(&name), staging.file(&name));
        match fs::hard_link(&from, &to) {
            Ok(()) => Ok(()),
            // Not every file system has links.
            Err(_) => fs::copy(&from, &to).map(drop),
        }
    }

    /// Removes everything, once the results are in their place.
    pub fn remove(self) {
        // The next run that writes there removes what cannot be removed now. The journal says whose
        // the folder is, so it is the last.
        if self.remove_pictures().is_ok() && fs::remove_file(self.folder.join(JOURNAL)).is_ok() {
            let _ = fs::remove_dir(&self.folder);
        }
    }

    fn remove_pictures(&self) -> io::Result<()> {
        for entry in fs::read_dir(&self.folder)? {
            let entry = entry?;
            if is_picture(&entry.file_name().to_string_lossy()) {
                fs::remove_file(entry.path())?;
            }
        }
        Ok(())
    }
}

/// The journal of a folder, which is made if it is not there; `None` while another program has it.
fn opened(folder: &Path) -> io::Result<Option<File>> {
    fs::create_dir_all(folder)?;
    let mut options = OpenOptions::new();
    let journal = options.create(true).append(true).open(folder.join(JOURNAL))?;
    match journal.try_lock() {
        Err(fs::TryLockError::WouldBlock) => Ok(None),
        // Where the file system has no locks, none is needed for a single run.
        Ok(()) | Err(fs::TryLockError::Error(_)) => Ok(Some(journal)),
    }
}

/// Refuses a folder that has something else in it, or something without a journal.
fn refuse_foreign(folder: &Path, shown: &Path) -> Result<(), OutputError> {
    let entries = match fs::read_dir(folder) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        entries => entries.map_err(OutputError::system(shown))?,
    };
    let journal = read_regular(&folder.join(JOURNAL), LONGEST_JOURNAL).ok();
    let begins = format!("{{\"program\":\"{PROGRAM}\"");
    // It may have been interrupted before, or while, it wrote the first line.
    let is_begun = |bytes: &Vec<u8>| bytes.iter().zip(begins.as_bytes()).all(|(a, b)| a == b);
    let is_ours = journal.as_ref().is_some_and(is_begun);
    let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut foreign: Vec<String> =
        names.filter(|name| !(is_ours && (name == JOURNAL || is_picture(name)))).collect();
    foreign.sort();
    match foreign.into_iter().next() {
        None => Ok(()),
        Some(foreign) => Err(OutputError::Foreign { folder: shown.to_owned(), foreign }),
    }
}

/// Whether a name is that of a frame's picture, or of one that is being written.
fn is_picture(name: &str) -> bool {
    let name = name.strip_suffix(NEW).unwrap_or(name);
    let number = name.strip_prefix("frame_").and_then(|rest| rest.strip_suffix(".png"));
    number.is_some_and(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()))
}

/// A hash of bytes. Another release of Rust may hash otherwise; then frames are shaded again.
pub(super) fn hash(bytes: &[u8]) -> String {
    let mut hasher = DefaultHasher::new();
    hasher.write(bytes);
    format!("{:016x}", hasher.finish())
}
