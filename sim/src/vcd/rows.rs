//! The lines of some clocks while they are made: a row of text for each clock.
//!
//! A signal's lines are made for all these clocks before the next signal's, and so its column is
//! read from front to back, and what is known of the signal is at hand.
use std::io::{self, ErrorKind, IoSlice, Write};

use super::record::{ROOM, Record};
use crate::Lanes;
use crate::changes::{BLOCK, ones};

/// Bytes that rows may take, so that memory stays small for designs of many signals.
const MOST: usize = 4 << 20;

/// Rows of text, each with the same room.
pub struct Rows {
    text: Vec<u8>,
    /// From the beginning of a row to that of the next.
    stride: usize,
    /// Where the text of each row ends.
    ends: Box<[usize; BLOCK]>,
}

impl Rows {
    /// Empty rows for so many bytes each; at least one row, and up to [`BLOCK`].
    pub fn new(longest: usize) -> Rows {
        // The longest text never spoils the next row.
        let stride = longest + ROOM;
        let rows = (MOST / stride).clamp(1, BLOCK);
        let mut rows = Rows { text: vec![0; rows * stride], stride, ends: Box::new([0; BLOCK]) };
        rows.clear();
        rows
    }

    /// Number of rows.
    pub fn count(&self) -> usize {
        self.text.len() / self.stride
    }

    /// Appends lines that say the values of a signal to the rows whose bits are set.
    pub fn values(&mut self, rows: u64, record: &Record, lanes: Lanes) {
        match record.width.div_ceil(8) {
            1 if record.width == 1 => {
                self.lines(rows, lanes, |value, room| record.bit(value, room))
            }
            1 => self.lines(rows, lanes, |value, room| record.vector::<1>(value, room)),
            2 => self.lines(rows, lanes, |value, room| record.vector::<2>(value, room)),
            3 => self.lines(rows, lanes, |value, room| record.vector::<3>(value, room)),
            4 => self.lines(rows, lanes, |value, room| record.vector::<4>(value, room)),
            5 => self.lines(rows, lanes, |value, room| record.vector::<5>(value, room)),
            6 => self.lines(rows, lanes, |value, room| record.vector::<6>(value, room)),
            7 => self.lines(rows, lanes, |value, room| record.vector::<7>(value, room)),
            _ => self.lines(rows, lanes, |value, room| record.vector::<8>(value, room)),
        }
    }

    fn lines(&mut self, rows: u64, lanes: Lanes, line: impl Fn(i64, &mut [u8; ROOM]) -> usize) {
        match lanes {
            Lanes::Narrow(lanes) => {
                ones(rows).for_each(|row| self.append(row, |room| line(lanes[row].into(), room)))
            }
            Lanes::Wide(lanes) => {
                ones(rows).for_each(|row| self.append(row, |room| line(lanes[row], room)))
            }
            Lanes::Constant(value, _) => {
                ones(rows).for_each(|row| self.append(row, |room| line(value, room)))
            }
        }
    }

    #[inline(always)]
    fn append(&mut self, row: usize, line: impl FnOnce(&mut [u8; ROOM]) -> usize) {
        let end = self.ends[row];
        // There is room for the longest text of a clock.
        if let Some(room) = self.text[end..].first_chunk_mut() {
            self.ends[row] = end + line(room);
        }
    }

    /// Appends the line that says a single bit to a row.
    pub fn bit(&mut self, row: usize, record: &Record, bit: bool) {
        self.append(row, |room| record.bit(bit.into(), room));
    }

    /// Appends a short line to a row.
    pub fn line(&mut self, row: usize, line: &[u8]) {
        let end = self.ends[row];
        self.ends[row] = end + line.len();
        self.text[end..end + line.len()].copy_from_slice(line);
    }

    /// Writes the first rows and empties all.
    ///
    /// # Errors
    /// What the system says if `out` cannot be written.
    pub fn write(&mut self, count: usize, out: &mut impl Write) -> io::Result<()> {
        let mut pieces = [IoSlice::new(&[]); BLOCK];
        for ((row, &end), piece) in self.ends[..count].iter().enumerate().zip(&mut pieces) {
            *piece = IoSlice::new(&self.text[row * self.stride..end]);
        }
        write_all(out, &mut pieces[..count])?;
        self.clear();
        Ok(())
    }

    fn clear(&mut self) {
        for (row, end) in self.ends.iter_mut().enumerate() {
            *end = row * self.stride;
        }
    }
}

/// Writes all pieces, with no copy of them if `out` takes several at a time.
fn write_all(out: &mut impl Write, mut pieces: &mut [IoSlice]) -> io::Result<()> {
    while !pieces.is_empty() {
        match out.write_vectored(pieces) {
            Ok(0) => return Err(ErrorKind::WriteZero.into()),
            Ok(count) => IoSlice::advance_slices(&mut pieces, count),
            Err(error) if error.kind() == ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(())
}
