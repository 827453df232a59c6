//! Where in a block of values each signal's are, and how much they unpack to.
//!
//! fst-reader reads the same, but makes room for whatever is stated; so it is read here before.
use std::io::{self, Read, Seek, SeekFrom};

use super::check::{MOST, ValueBlock, unpacks, wrong};
use super::integer::{signed, variable};

/// Where a signal's values are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// It has none in this block.
    None,
    /// They are those of the signal with that number.
    SameAs(usize),
    /// Behind an offset.
    At(u64),
}

/// The kind of block whose chain has signed entries.
const SIGNED: u8 = 8;

/// Checks that some signals' values are where they can be, and unpack to no more than [`MOST`]
/// bytes.
///
/// # Errors
/// What is wrong, or what the system says.
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
            Some(&Place::At(offset)) => unpacked(input, block, offset)?,
            Some(&Place::SameAs(other)) => match places.get(other) {
                Some(&Place::At(offset)) => unpacked(input, block, offset)?,
                _ => {
                    return Err(wrong("values of a signal are said to be another's that has none"));
                }
            },
            Some(Place::None) | None => 0,
        };
        if total > MOST {
            return Err(wrong("the values of its signals are too many to be unpacked"));
        }
    }
    Ok(())
}

/// The length of what is at an offset, unpacked.
fn unpacked(input: &mut (impl Read + Seek), block: &ValueBlock, offset: u64) -> io::Result<u64> {
    input.seek(SeekFrom::Start(block.values + offset))?;
    let room = block.chain.0 - block.values - offset;
    match variable(input)? {
        // They are not packed.
        0 => Ok(room),
        length if unpacks(room, length) => Ok(length),
        _ => Err(wrong("values of a signal are longer than they can be")),
    }
}

fn places(chain: &[u8], block: &ValueBlock) -> io::Result<Vec<Place>> {
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

/// Places while a chain is read.
struct Places<'a> {
    places: Vec<Place>,
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
        self.push(Place::SameAs(
            other.ok_or_else(|| wrong("it has values of signals that it does not list"))?,
        ))
    }

    fn forward(&mut self, by: u64) -> io::Result<()> {
        let room = self.block.chain.0 - self.block.values;
        let offset = self.offset.checked_add(by).filter(|&offset| by > 0 && offset < room);
        self.offset = offset
            .ok_or_else(|| wrong("values of a signal are said to be outside of their block"))?;
        self.push(Place::At(self.offset))
    }

    fn none(&mut self, signals: u64) -> io::Result<()> {
        if signals > self.block.signals - self.places.len() as u64 {
            return Err(wrong("it has values of signals that it does not list"));
        }
        // No more than the file lists.
        self.places.resize(self.places.len() + signals as usize, Place::None);
        Ok(())
    }

    fn push(&mut self, place: Place) -> io::Result<()> {
        if self.places.len() as u64 >= self.block.signals {
            return Err(wrong("it has values of signals that it does not list"));
        }
        self.places.push(place);
        Ok(())
    }
}
