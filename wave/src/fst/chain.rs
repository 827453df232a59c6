//! The chain of offsets in a block of values: where each signal's values are, and how many bytes
//! they unpack to.
//!
//! fst-reader reads the same chain, but allocates whatever length is stated; so the lengths are
//! checked here first.
use std::io::{self, Read, Seek, SeekFrom};

use super::check::{MAX_BYTES, ValueBlock, unpacks};
use super::error::wrong;
use super::integer::{signed, variable};

/// Where a signal's values are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ValueLocation {
    /// The signal has no values in this block.
    None,
    /// The values are those of the signal with that number.
    SameAs(usize),
    /// The values are at an offset.
    At(u64),
}

/// The kind of block whose chain has signed entries.
const SIGNED: u8 = 8;

/// Checks that the values of some signals lie inside the file, and unpack to no more than
/// [`MAX_BYTES`] bytes.
///
/// # Errors
pub fn check(
    input: &mut (impl Read + Seek),
    block: &ValueBlock,
    signals: &[usize],
) -> io::Result<()> {
    let (at, length) = block.chain;
    input.seek(SeekFrom::Start(at))?;
    let mut chain = vec![];
    input.take(length).read_to_end(&mut chain)?;
    let places = places(&chain, block)?;
    let mut total = 0;
    for &signal in signals {
        total += match places.get(signal) {
            Some(&ValueLocation::At(offset)) => unpacked(input, block, offset)?,
            Some(&ValueLocation::SameAs(other)) => match places.get(other) {
                Some(&ValueLocation::At(offset)) => unpacked(input, block, offset)?,
                _ => {
                    return Err(wrong("values of a signal are said to be another's that has none"));
                }
            },
            Some(ValueLocation::None) | None => 0,
        };
        if total > MAX_BYTES {
            return Err(wrong("the values of its signals are too many to be unpacked"));
        }
    }
    Ok(())
}

/// The unpacked length of what is at an offset.
fn unpacked(input: &mut (impl Read + Seek), block: &ValueBlock, offset: u64) -> io::Result<u64> {
    input.seek(SeekFrom::Start(block.values + offset))?;
    let room = block.chain.0 - block.values - offset;
    match variable(input)? {
        // A length of 0 says that the values are not packed.
        0 => Ok(room),
        length if unpacks(room, length) => Ok(length),
        _ => Err(wrong("values of a signal are longer than they can be")),
    }
}

fn places(chain: &[u8], block: &ValueBlock) -> io::Result<Vec<ValueLocation>> {
    let mut places = Places { places: vec![], block, offset: 0, alias: 0 };
    let mut rest = chain;
    while !rest.is_empty() {
        match block.kind {
            SIGNED if rest[0] & 1 == 1 => places.signed(signed(&mut rest)? >> 1)?,
            SIGNED => places.none(variable(&mut rest)? >> 1)?,
            _ => match variable(&mut rest)? {
                0 => {
                    let other = variable(&mut rest)?;
                    places.same_as(other.wrapping_sub(1))?;
                }
                entry if entry & 1 == 1 => places.forward(entry >> 1)?,
                entry => places.none(entry >> 1)?,
            },
        }
    }
    Ok(places.places)
}

/// The places found while a chain is read.
struct Places<'a> {
    places: Vec<ValueLocation>,
    block: &'a ValueBlock,
    offset: u64,
    alias: u64,
}

impl Places<'_> {
    fn signed(&mut self, entry: i64) -> io::Result<()> {
        match entry {
            0 => self.same_as(self.alias),
            1.. => self.forward(entry.unsigned_abs()),
            _ => {
                self.alias = entry.unsigned_abs() - 1;
                self.same_as(self.alias)
            }
        }
    }

    fn same_as(&mut self, other: u64) -> io::Result<()> {
        let other = usize::try_from(other).ok().filter(|_| other < self.block.signals);
        self.push(ValueLocation::SameAs(
            other.ok_or_else(|| wrong("it has values of signals that it does not list"))?,
        ))
    }

    fn forward(&mut self, by: u64) -> io::Result<()> {
        let room = self.block.chain.0 - self.block.values;
        let offset = self.offset.checked_add(by).filter(|&offset| by > 0 && offset < room);
        self.offset = offset
            .ok_or_else(|| wrong("values of a signal are said to be outside of their block"))?;
        self.push(ValueLocation::At(self.offset))
    }

    fn none(&mut self, signals: u64) -> io::Result<()> {
        if signals > self.block.signals - self.places.len() as u64 {
            return Err(wrong("it has values of signals that it does not list"));
        }
        // A block has no more signals than the file declares.
        self.places.resize(self.places.len() + signals as usize, ValueLocation::None);
        Ok(())
    }

    fn push(&mut self, place: ValueLocation) -> io::Result<()> {
        if self.places.len() as u64 >= self.block.signals {
            return Err(wrong("it has values of signals that it does not list"));
        }
        self.places.push(place);
        Ok(())
    }
}
