//! Lines of a text in any encoding, whichever way they end.

/// Cuts bytes into lines that end in LF, CR LF or CR.
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    bytes: &'a [u8],
    /// Offset of the next line.
    at: usize,
    /// Number of the last line returned, counted from 1.
    number: usize,
    /// The end of that line.
    end: LineEnd,
}

/// The end of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LineEnd {
    /// A line feed.
    Lf,
    /// A carriage return and a line feed.
    CrLf,
    /// A carriage return.
    Cr,
    /// The end of the file.
    Nothing,
}

impl<'a> Lines<'a> {
    /// All lines of `bytes`.
    pub fn new(bytes: &'a [u8]) -> Lines<'a> {
        Lines { bytes, at: 0, number: 0, end: LineEnd::Nothing }
    }

    /// Number of the last line returned, counted from 1.
    pub fn number(&self) -> usize {
        self.number
    }

    /// The end of the last line returned.
    pub fn end(&self) -> LineEnd {
        self.end
    }

    /// The bytes after the last line returned, as if that line had ended in `end`.
    ///
    /// Where data follow lines that end in CR, a first byte that is an LF belongs to the data.
    pub fn rest_after(&self, end: LineEnd) -> &'a [u8] {
        let at = match (end, self.end) {
            (LineEnd::Cr, LineEnd::CrLf) => self.at - 1,
            _ => self.at,
        };
        &self.bytes[at..]
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = &self.bytes[self.at..];
        if rest.is_empty() {
            return None;
        }
        let length =
            rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
        let (end, taken) = match (rest.get(length), rest.get(length + 1)) {
            (Some(b'\n'), _) => (LineEnd::Lf, 1),
            (Some(_), Some(b'\n')) => (LineEnd::CrLf, 2),
            (Some(_), _) => (LineEnd::Cr, 1),
            (None, _) => (LineEnd::Nothing, 0),
        };
        self.at += length + taken;
        self.number += 1;
        self.end = end;
        Some(&rest[..length])
    }
}

/// The words of a line, which are separated by blanks.
#[derive(Clone, Debug, Default)]
pub struct Words<'a> {
    rest: &'a [u8],
}

impl<'a> Words<'a> {
    /// What follows the words that were returned.
    pub fn rest(&self) -> &'a [u8] {
        self.rest
    }
}

/// The words of a line.
pub fn words(line: &[u8]) -> Words<'_> {
    Words { rest: line }
}

/// Whether a byte separates words: a blank, or a control character such as the one that ends DOS
/// texts.
pub fn is_blank(byte: &u8) -> bool {
    *byte <= b' '
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let start = self.rest.iter().position(|byte| !is_blank(byte))?;
        let from_start = &self.rest[start..];
        let length = from_start.iter().position(is_blank).unwrap_or(from_start.len());
        let (word, rest) = from_start.split_at(length);
        self.rest = rest;
        Some(word)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_may_end_in_three_ways() {
        let mut lines = Lines::new(b"a\nb\r\nc\r\rd");
        let all: Vec<&[u8]> = lines.by_ref().collect();
        assert_eq!(all, [&b"a"[..], b"b", b"c", b"", b"d"]);
        assert_eq!((lines.number(), lines.end()), (5, LineEnd::Nothing));
    }

    #[test]
    fn data_after_a_carriage_return_may_start_with_a_line_feed() {
        let mut lines = Lines::new(b"a\r\nb");
        lines.next();
        assert_eq!(lines.rest_after(LineEnd::Cr), b"\nb");
        assert_eq!(lines.rest_after(LineEnd::CrLf), b"b");
    }

    #[test]
    fn words_stand_between_blanks() {
        let all: Vec<&[u8]> = words(b" 1\t2  \x0b3 ").collect();
        assert_eq!(all, [b"1", b"2", b"3"]);
    }
}
