//! Checks the lengths that an FST file states before a reader allocates what they ask for, or goes
//! where they point.
//!
//! fst-reader 0.17 takes them as they stand: a program that asks for exabytes is ended by the
//! system, with no error and not even a panic, and one that goes backwards by a length never ends.
//! The layout is that of GTKWave's `fstapi.c`: blocks of a kind, a length that counts itself, and
//! contents.
use std::io::{self, Read, Seek, SeekFrom};

use super::super::input::BEST_COMPRESSION;
use super::integer::{number, variable};

/// Bytes that anything in a file may unpack to.
pub const MOST: u64 = 1 << 30;
/// Instants in a block of values, at most.
const MOST_INSTANTS: u64 = 1 << 26;
/// Signals, at most.
const MOST_SIGNALS: u64 = 1 << 24;

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
/// Bytes before a block of values' first length: its own, begin, end, and the memory that its
/// writer used.
const VALUES_HEADER: u64 = 4 * 8;
/// Bytes at its end that describe its table of times: length, compressed length, number.
const TIMES_TRAILER: u64 = 3 * 8;

/// A block of values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueBlock {
    /// Its kind: how it says where a signal's values are.
    pub kind: u8,
    /// Its first time.
    pub first: u64,
    /// Its last time.
    pub last: u64,
    /// Its table of times: where it is, its compressed length and its length.
    pub times: (u64, u64, u64),
    /// The number of times in it.
    pub instants: u64,
    /// How many signals it has.
    pub signals: u64,
    /// Where values begin: offsets count from here.
    pub values: u64,
    /// The chain of offsets: where it is, and its length.
    pub chain: (u64, u64),
}

/// Checks an FST file, and gives its blocks of values.
///
/// # Errors
/// What is wrong with it, or what the system says.
pub fn check(input: &mut (impl Read + Seek)) -> io::Result<Vec<ValueBlock>> {
    let length = input.seek(SeekFrom::End(0))?;
    let mut checker = Checker { input, length, signals: None, hierarchy: false, blocks: vec![] };
    let mut at = 0;
    while let Some(next) = checker.block(at)? {
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
    /// The number of signals, as far as it is known.
    signals: Option<u64>,
    hierarchy: bool,
    blocks: Vec<ValueBlock>,
}

impl<I: Read + Seek> Checker<'_, I> {
    /// Checks the block at a place, and gives the place behind it. None at the end.
    fn block(&mut self, at: u64) -> io::Result<Option<u64>> {
        if at >= self.length {
            return Ok(None);
        }
        self.input.seek(SeekFrom::Start(at))?;
        let mut kind = [0];
        self.input.read_exact(&mut kind)?;
        let [kind] = kind;
        let (begin, length) = (at + 1, number(self.input)?);
        // So an unfinished file ends.
        if kind == kind::SKIPPED && length == 0 {
            return Ok(None);
        }
        let end = begin.checked_add(length).filter(|&end| length >= 8 && end <= self.length);
        let end =
            end.ok_or_else(|| wrong("a block goes beyond the file's end, which may be missing"))?;
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
            length >= 24 && unpacks(length - 24, unpacked) && signals <= unpacked.min(MOST_SIGNALS),
        )?;
        self.signals = Some(signals);
        Ok(())
    }

    fn names(&mut self, kind: u8, length: u64) -> io::Result<()> {
        let unpacked = number(self.input)?;
        // Behind a gzip header, whose first byte is at least there.
        let least = if kind == kind::HIERARCHY_ZLIB { 16 + 10 } else { 16 };
        possible(length >= least && unpacked <= MOST)?;
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
        possible(instants <= unpacked && instants <= MOST_INSTANTS)?;
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

/// Whether that many bytes can become that many.
pub fn unpacks(packed: u64, unpacked: u64) -> bool {
    unpacked <= packed.saturating_mul(BEST_COMPRESSION).min(MOST)
}

fn possible(possible: bool) -> io::Result<()> {
    if possible {
        Ok(())
    } else {
        Err(wrong("it states a length that no file of its size can have"))
    }
}

/// An error of the file's.
pub fn wrong(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}
