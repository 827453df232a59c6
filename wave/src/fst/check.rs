//! Checks the lengths that an FST file states, before a reader allocates memory for them or seeks
//! by them.
//!
//! fst-reader 0.17 trusts them: a program that asks for exabytes is ended by the operating system,
//! without an error or even a panic, and one that seeks backwards by a length never ends. The
//! layout is that of GTKWave's `fstapi.c`: a block has a kind, a length that includes itself, and
//! contents.
use std::io::{self, Read, Seek, SeekFrom};

use super::super::input::BEST_COMPRESSION;
use super::error::wrong;
use super::integer::{number, variable};

/// Largest number of bytes that anything in a file may unpack to.
pub const MAX_BYTES: u64 = 1 << 30;
/// Largest number of instants in a block of values.
const MAX_INSTANTS: u64 = 1 << 26;
/// Largest number of signals.
const MAX_SIGNALS: u64 = 1 << 24;

/// Kinds of blocks.
mod kind {
    pub const HEADER: u8 = 0;
    pub const BLACKOUT: u8 = 2;
    pub const GEOMETRY: u8 = 3;
    pub const HIERARCHY_ZLIB: u8 = 4;
    pub const HIERARCHY_LZ4: u8 = 6;
    pub const HIERARCHY_LZ4_TWICE: u8 = 7;
    pub const VALUES: [u8; 3] = [1, 5, 8];
    pub const SKIPPED: u8 = 255;
}

/// The length of the header's block.
const HEADER: u64 = 329;
/// Bytes before the first length in a block of values: the block's own length, begin, end, and the
/// memory that its writer used.
const VALUES_HEADER: u64 = 4 * 8;
/// Bytes at the end of a block of values that describe its table of times: length, compressed
/// length, number.
const TIMES_TRAILER: u64 = 3 * 8;

/// A block of values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueBlock {
    /// The kind, which says how the block states where a signal's values are.
    pub kind: u8,
    /// Its first time.
    pub first: u64,
    /// Its last time.
    pub last: u64,
    /// The table of times: its place, its compressed length and its length.
    pub times: (u64, u64, u64),
    /// The number of times in the table.
    pub instants: u64,
    /// The number of signals in the block.
    pub signals: u64,
    /// The place where values begin; offsets count from here.
    pub values: u64,
    /// The chain of offsets: its place and its length.
    pub chain: (u64, u64),
}

/// Checks an FST file and gives its blocks of values.
///
/// # Errors
pub fn check(input: &mut (impl Read + Seek)) -> io::Result<Vec<ValueBlock>> {
    let length = input.seek(SeekFrom::End(0))?;
    let mut checker = Checker { input, length, signals: None, hierarchy: false, blocks: vec![] };
    let mut at = 0;
    while let Some(next) = checker.block(at).map_err(|reason| in_block(at, &reason))? {
        at = next;
    }
    if !checker.hierarchy || checker.signals.is_none() {
        return Err(wrong(
            "its list of signals is missing, which is written when the simulation ends",
        ));
    }
    if checker.blocks.iter().any(|block| Some(block.signals) > checker.signals) {
        return Err(wrong("it has values of signals that it does not list"));
    }
    Ok(checker.blocks)
}

struct Checker<'a, I> {
    input: &'a mut I,
    length: u64,
    /// The number of signals, once it is known.
    signals: Option<u64>,
    hierarchy: bool,
    blocks: Vec<ValueBlock>,
}

impl<I: Read + Seek> Checker<'_, I> {
    /// Checks the block at a place and gives the place behind it, or `None` at the end of the file.
    fn block(&mut self, at: u64) -> io::Result<Option<u64>> {
        if at >= self.length {
            return Ok(None);
        }
        self.input.seek(SeekFrom::Start(at))?;
        let mut kind = [0];
        self.input.read_exact(&mut kind)?;
        let [kind] = kind;
        let (begin, length) = (at + 1, number(self.input)?);
        // An unfinished file ends with such a block.
        if kind == kind::SKIPPED && length == 0 {
            return Ok(None);
        }
        let end = begin.checked_add(length).filter(|&end| length >= 8 && end <= self.length);
        let end =
            end.ok_or_else(|| wrong("it goes beyond the file's end, which may be missing"))?;
        match kind {
            kind::HEADER if length != HEADER => {
                return Err(wrong("its header has another length than all have"));
            }
            kind::BLACKOUT => {
                let count = variable(self.input)?;
                possible(count <= length)?;
            }
            kind::GEOMETRY => self.geometry(length)?,
            kind::HIERARCHY_ZLIB | kind::HIERARCHY_LZ4 | kind::HIERARCHY_LZ4_TWICE => {
                self.names(kind, length)?
            }
            kind if kind::VALUES.contains(&kind) => self.values(kind, begin, end)?,
            _ => {}
        }
        Ok(Some(end))
    }

    fn geometry(&mut self, length: u64) -> io::Result<()> {
        let (unpacked, signals) = (number(self.input)?, number(self.input)?);
        possible(
            length >= 24 && unpacks(length - 24, unpacked) && signals <= unpacked.min(MAX_SIGNALS),
        )?;
        self.signals = Some(signals);
        Ok(())
    }

    fn names(&mut self, kind: u8, length: u64) -> io::Result<()> {
        let unpacked = number(self.input)?;
        // The packed data are behind a gzip header, whose first byte must be there.
        let least = if kind == kind::HIERARCHY_ZLIB { 16 + 10 } else { 16 };
        possible(length >= least && unpacked <= MAX_BYTES)?;
        if kind == kind::HIERARCHY_LZ4_TWICE {
            let once = variable(self.input)?;
            possible(length >= least + 10 && unpacks(length, once) && unpacks(once, unpacked))?;
        } else {
            possible(unpacks(length, unpacked))?;
        }
        self.hierarchy = true;
        Ok(())
    }

    fn values(&mut self, kind: u8, begin: u64, end: u64) -> io::Result<()> {
        let length = end - begin;
        possible(length >= VALUES_HEADER + TIMES_TRAILER + 8)?;
        let (first, last) = (number(self.input)?, number(self.input)?);
        self.input.seek(SeekFrom::Start(end - TIMES_TRAILER))?;
        let (unpacked, packed, instants) =
            (number(self.input)?, number(self.input)?, number(self.input)?);
        possible(
            packed <= length - VALUES_HEADER - TIMES_TRAILER - 8 && unpacks(packed, unpacked),
        )?;
        possible(instants <= unpacked && instants <= MAX_INSTANTS)?;
        let times = (end - TIMES_TRAILER - packed, packed, unpacked);
        let chain_end = times.0 - 8;
        self.input.seek(SeekFrom::Start(chain_end))?;
        let chain = number(self.input)?;
        self.input.seek(SeekFrom::Start(begin + VALUES_HEADER))?;
        let (unpacked, packed, first_values) =
            (variable(self.input)?, variable(self.input)?, variable(self.input)?);
        possible(unpacks(packed, unpacked) && packed <= length)?;
        let behind = self.input.seek(SeekFrom::Current(packed as i64))?;
        possible(behind < chain_end)?;
        let signals = variable(self.input)?;
        let values = self.input.stream_position()?;
        possible(
            first_values <= unpacked.max(signals)
                && chain <= chain_end
                && chain_end - chain > values,
        )?;
        let chain = (chain_end - chain, chain);
        self.blocks.push(ValueBlock { kind, first, last, times, instants, signals, values, chain });
        Ok(())
    }
}

/// Whether `packed` bytes can unpack to `unpacked` bytes.
pub fn unpacks(packed: u64, unpacked: u64) -> bool {
    unpacked <= packed.saturating_mul(BEST_COMPRESSION).min(MAX_BYTES)
}

/// Adds the block that begins at `at` to an error's message.
fn in_block(at: u64, reason: &io::Error) -> io::Error {
    let said = match reason.kind() {
        io::ErrorKind::InvalidData => reason.to_string(),
        io::ErrorKind::UnexpectedEof => "it ends too early".to_owned(),
        kind => return io::Error::new(kind, reason.to_string()),
    };
    wrong(&format!("in the block at byte {at}: {said}"))
}

fn possible(possible: bool) -> io::Result<()> {
    if possible {
        Ok(())
    } else {
        Err(wrong("it states a length that no file of its size can have"))
    }
}
