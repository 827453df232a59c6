//! Checks the lengths that an FST file states before a reader allocates what they ask for.
//!
//! fst-reader 0.17 takes them as they stand, and a program that asks for exabytes is ended by the system: no error, not even a panic. The layout
//! is that of GTKWave's `fstapi.c`: blocks of a kind, a length that counts itself, and contents.
use std::io::{self, Read, Seek, SeekFrom};

/// No compression in an FST file gives more than that many bytes for one.
const BEST_COMPRESSION: u64 = 1100;

/// Kinds of blocks.
mod kind {
    pub const BLACKOUT: u8 = 2;
    pub const GEOMETRY: u8 = 3;
    pub const HIERARCHY: [u8; 3] = [4, 6, 7];
    pub const VALUES: [u8; 3] = [1, 5, 8];
    pub const COMPRESSED_FILE: u8 = 254;
}

/// Bytes before a block of values' first length: its own, begin, end, and the memory that its writer used.
const VALUES_HEADER: u64 = 4 * 8;
/// Bytes at its end that describe its table of times: length, compressed length, number.
const TIMES_TRAILER: u64 = 3 * 8;

/// Checks an FST file, and goes back to its begin.
///
/// # Errors
/// What is wrong with it, or what the system says.
pub fn check(input: &mut (impl Read + Seek)) -> io::Result<()> {
    let length = input.seek(SeekFrom::End(0))?;
    let mut checker = Checker { input, length };
    let mut at = 0;
    while at < length {
        at = checker.block(at)?;
    }
    checker.input.rewind()
}

struct Checker<'a, I> {
    input: &'a mut I,
    length: u64,
}

impl<I: Read + Seek> Checker<'_, I> {
    /// Checks the block at a place, and gives the place behind it.
    fn block(&mut self, at: u64) -> io::Result<u64> {
        self.input.seek(SeekFrom::Start(at))?;
        let [kind] = self.bytes()?;
        let begin = at + 1;
        let length = self.number()?;
        let end = begin.checked_add(length).filter(|&end| length >= 8 && end <= self.length);
        let end = end.ok_or_else(|| wrong("a block goes beyond the file's end, which may be missing"))?;
        match kind {
            kind::COMPRESSED_FILE => return Err(wrong("it is compressed as a whole, which is not supported")),
            kind::BLACKOUT => self.lengths::<1>(Self::variable)?,
            kind::GEOMETRY => self.lengths::<2>(Self::number)?,
            kind if kind::HIERARCHY.contains(&kind) => self.lengths::<1>(Self::number)?,
            kind if kind::VALUES.contains(&kind) => self.values(begin, end)?,
            _ => {}
        }
        Ok(end)
    }

    fn values(&mut self, begin: u64, end: u64) -> io::Result<()> {
        if end - begin < VALUES_HEADER + TIMES_TRAILER {
            return Err(wrong("a block of values is too short"));
        }
        self.input.seek(SeekFrom::Start(end - TIMES_TRAILER))?;
        self.lengths::<3>(Self::number)?;
        self.input.seek(SeekFrom::Start(begin + VALUES_HEADER))?;
        // First values: length, compressed length, number. Behind them the number of signals.
        self.length(Self::variable)?;
        let compressed = self.length(Self::variable)?;
        self.length(Self::variable)?;
        self.input.seek(SeekFrom::Current(compressed.min(self.length) as i64))?;
        self.lengths::<1>(Self::variable)
    }

    /// Checks some lengths that follow each other.
    fn lengths<const N: usize>(&mut self, read: impl Fn(&mut Self) -> io::Result<u64>) -> io::Result<()> {
        (0..N).try_for_each(|_| self.length(&read).map(drop))
    }

    fn length(&mut self, read: impl Fn(&mut Self) -> io::Result<u64>) -> io::Result<u64> {
        let length = read(self)?;
        let possible = length <= self.length.saturating_mul(BEST_COMPRESSION);
        if possible { Ok(length) } else { Err(wrong("it states a length that no file of its size can have")) }
    }

    fn number(&mut self) -> io::Result<u64> {
        self.bytes().map(u64::from_be_bytes)
    }

    /// A number in bytes of seven bits, the lowest first; the eighth says that more follow.
    fn variable(&mut self) -> io::Result<u64> {
        let mut number = 0;
        for shift in (0..64).step_by(7) {
            let [byte] = self.bytes()?;
            number |= u64::from(byte & 0x7f) << shift;
            if byte & 0x80 == 0 {
                return Ok(number);
            }
        }
        Err(wrong("a number in it has no end"))
    }

    fn bytes<const N: usize>(&mut self) -> io::Result<[u8; N]> {
        let mut bytes = [0; N];
        self.input.read_exact(&mut bytes)?;
        Ok(bytes)
    }
}

fn wrong(what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}
