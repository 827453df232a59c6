//! Text gathered into large pieces on its way out.
use std::io::{self, Write};

use super::record::{ROOM, Record};

/// Bytes that are written at a time: few calls of the system, and less than a core's second cache.
const PIECE: usize = 256 << 10;
/// Digits of the largest number.
const DIGITS: usize = 20;

/// A text under way to `out`.
pub struct Text<W: Write> {
    out: W,
    buffer: Vec<u8>,
    /// Bytes of the buffer that are text.
    length: usize,
}

impl<W: Write> Text<W> {
    /// An empty text.
    pub fn new(out: W) -> Text<W> {
        Text { out, buffer: vec![0; PIECE], length: 0 }
    }

    /// Adds the line that says what a variable has become.
    #[inline]
    pub fn value(&mut self, record: &Record, value: i64) {
        if self.buffer.len() - self.length < ROOM {
            self.grow();
        }
        if let Some(room) = self.buffer[self.length..].first_chunk_mut() {
            self.length += record.write(value, room);
        }
    }

    /// Adds a time.
    pub fn time(&mut self, time: u64) {
        let mut line = [b'\n'; DIGITS + 2];
        let (mut at, mut rest) = (DIGITS + 1, time);
        loop {
            at -= 1;
            line[at] = b'0' + (rest % 10) as u8;
            rest /= 10;
            if rest == 0 {
                break;
            }
        }
        line[at - 1] = b'#';
        self.line(&line[at - 1..]);
    }

    /// Adds a line, no longer than [`ROOM`] and its end included.
    pub fn line(&mut self, line: &[u8]) {
        if self.buffer.len() - self.length < line.len() {
            self.grow();
        }
        self.buffer[self.length..self.length + line.len()].copy_from_slice(line);
        self.length += line.len();
    }

    /// Makes more room than a line needs.
    #[cold]
    fn grow(&mut self) {
        self.buffer.resize(self.buffer.len() + PIECE, 0);
    }

    /// Writes what has been gathered if it is a large piece. Memory stays flat if this is called now and then.
    ///
    /// # Errors
    /// What the system says if `out` cannot be written.
    pub fn write_pieces(&mut self) -> io::Result<()> {
        if self.length < PIECE { Ok(()) } else { self.write() }
    }

    /// Writes what has been gathered, then `text`.
    ///
    /// # Errors
    /// What the system says if `out` cannot be written.
    pub fn write_through(&mut self, text: &str) -> io::Result<()> {
        self.write()?;
        self.out.write_all(text.as_bytes())
    }

    /// Writes what has been gathered.
    ///
    /// # Errors
    /// What the system says if `out` cannot be written.
    pub fn flush(&mut self) -> io::Result<()> {
        self.write()?;
        self.out.flush()
    }

    fn write(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buffer[..self.length])?;
        self.length = 0;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_decimal() {
        let mut out = vec![];
        let mut text = Text::new(&mut out);
        [0, 905, u64::MAX].into_iter().for_each(|time| text.time(time));
        text.flush().unwrap();
        assert_eq!(String::from_utf8(out).unwrap(), "#0\n#905\n#18446744073709551615\n");
    }

    #[test]
    fn nothing_is_lost_between_pieces() {
        let mut out = vec![];
        let mut text = Text::new(&mut out);
        let record = Record::new(40, "!");
        for value in 0..100_000 {
            text.value(&record, value);
            if value % 30_000 == 0 {
                text.write_pieces().unwrap();
            }
        }
        text.flush().unwrap();
        let wanted: String = (0..100_000).map(|value| format!("b{value:b} !\n")).collect();
        assert!(out == wanted.as_bytes());
    }
}
