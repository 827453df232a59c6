//! Reading a VCD or FST file, with every way in which it can be wrong.
use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;

use wellen::viewers::{self, BodyResult, HeaderResult};
use wellen::{FileFormat, Hierarchy, LoadOptions, Signal, SignalRef, SignalSource, TimeTable, WellenError};

use super::error::WaveError;
use super::fst_check;
use super::guard::guarded;
use super::variables::clean;

/// Width of a signal in bits, at most: its reader makes room for all of them, whether or not the file has them.
const WIDEST: u32 = 1 << 20;

/// What the reader keeps of a file.
pub struct Waves {
    /// Scopes and variables.
    pub hierarchy: Hierarchy,
    /// Where values come from.
    pub source: SignalSource,
    /// The times at which something happens.
    pub times: TimeTable,
    /// The signals that have been loaded.
    pub signals: HashMap<SignalRef, Signal>,
}

impl Waves {
    /// Opens a file and reads it.
    ///
    /// # Errors
    /// [`WaveError`] if it is not there, not a dump, or damaged.
    pub fn read(path: &Path) -> Result<Waves, WaveError> {
        let mut input = open(path).map_err(|reason| WaveError::Unreadable { path: path.to_owned(), reason })?;
        match viewers::detect_file_format(&mut input) {
            FileFormat::Vcd => {}
            FileFormat::Fst => fst_check::check(&mut input).map_err(|wrong| damaged(path, &wrong.to_string()))?,
            FileFormat::Ghw | FileFormat::Unknown => return Err(WaveError::Kind { path: path.to_owned() }),
        }
        read(path, input)
    }
}

fn open(path: &Path) -> io::Result<BufReader<File>> {
    let file = File::open(path)?;
    // A folder can be opened, and a pipe cannot be read twice.
    if file.metadata()?.is_file() { Ok(BufReader::new(file)) } else { Err(io::Error::other("it is not a regular file")) }
}

/// Reads from an open file and not from a path: that way wellen maps no memory that somebody else may cut off, and stays on this thread, where
/// it may print a warning though standard output is locked.
fn read(path: &Path, input: BufReader<File>) -> Result<Waves, WaveError> {
    let refused = |error| match error {
        WellenError::FailedToLoad(_, reason) => damaged(path, &reason),
        WellenError::UnknownFileFormat => WaveError::Kind { path: path.to_owned() },
        WellenError::Io(reason) => WaveError::Unreadable { path: path.to_owned(), reason },
    };
    let panicked = |said: String| damaged(path, &said);
    let header = guarded(|| viewers::read_header(input, &LoadOptions::default())).map_err(panicked)?.map_err(refused)?;
    let HeaderResult { hierarchy, body, .. } = header;
    if let Some(width) =
        hierarchy.all_vars().filter_map(|variable| hierarchy[variable].length(&hierarchy)).find(|&width| width > WIDEST)
    {
        return Err(damaged(path, &format!("a signal has {width} bits")));
    }
    let BodyResult { source, time_table } =
        guarded(|| viewers::read_body(body, &hierarchy, None)).map_err(panicked)?.map_err(refused)?;
    Ok(Waves { hierarchy, source, times: time_table, signals: HashMap::new() })
}

/// The error for what the reader says, which may be long and hold pieces of the file.
pub fn damaged(path: &Path, said: &str) -> WaveError {
    const LONGEST: usize = 120;
    // wellen's words for a header without an end.
    let said = if said.starts_with("I/O operation failed") { "it ends too early" } else { said };
    let line = clean(said.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or("it cannot be understood"));
    let reason = if line.chars().count() > LONGEST { line.chars().take(LONGEST).chain("...".chars()).collect() } else { line };
    WaveError::Damaged { path: path.to_owned(), reason }
}
