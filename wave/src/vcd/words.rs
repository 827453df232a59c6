//! The words of a VCD file, which are separated by blanks, and the lines they stand in.
use std::io::{self, BufRead};

/// Number of bytes of a word that are kept: room for the bits of the widest signal.
const LONGEST: usize = (1 << 20) + 8;

/// A word and its place.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Word {
    /// Its bytes, or the first of them if it is very long.
    pub bytes: Vec<u8>,
    /// The line it stands in, counted from 1.
    pub line: u64,
    /// Whether it is the first of its line.
    pub begins_line: bool,
    /// Whether the file ends with it, without an end of the line.
    pub ends_file: bool,
    /// Whether it is longer than [`LONGEST`] bytes and was cut.
    pub cut: bool,
}

/// Reads words one by one, with one word of look-ahead.
pub struct Words<R> {
    input: R,
    line: u64,
    begins_line: bool,
    /// Whether the last byte was a carriage return, which a line feed may follow.
    returned: bool,
    current: Word,
    ahead: Option<Word>,
    /// A word that is no longer needed; its memory is used again.
    spare: Word,
}

impl<R: BufRead> Words<R> {
    /// The words of a file, without its byte order mark.
    ///
    /// # Errors
    /// The operating system's error.
    pub fn new(mut input: R) -> io::Result<Words<R>> {
        const MARK: &[u8] = b"\xef\xbb\xbf";
        if input.fill_buf()?.starts_with(MARK) {
            input.consume(MARK.len());
        }
        let (current, spare) = (Word::default(), Word::default());
        Ok(Words {
            input,
            line: 1,
            begins_line: true,
            returned: false,
            current,
            ahead: None,
            spare,
        })
    }

    /// The word to which [`Words::advance`] came last.
    pub fn current(&self) -> &Word {
        &self.current
    }

    /// Advances to the next word, if there is one.
    ///
    /// # Errors
    /// The operating system's error.
    pub fn advance(&mut self) -> io::Result<bool> {
        let next = match self.ahead.take() {
            Some(word) => Some(word),
            None => self.read()?,
        };
        let there = next.is_some();
        if let Some(word) = next {
            self.spare = std::mem::replace(&mut self.current, word);
        }
        Ok(there)
    }

    /// The word behind the current one.
    ///
    /// # Errors
    /// The operating system's error.
    pub fn peek(&mut self) -> io::Result<Option<&Word>> {
        if self.ahead.is_none() {
            self.ahead = self.read()?;
        }
        Ok(self.ahead.as_ref())
    }

    /// Advances to the next word if it stands in the line of the current one.
    ///
    /// # Errors
    /// The operating system's error.
    pub fn advance_in_line(&mut self) -> io::Result<bool> {
        let in_line = self.peek()?.is_some_and(|word| !word.begins_line);
        if in_line { self.advance() } else { Ok(false) }
    }

    fn read(&mut self) -> io::Result<Option<Word>> {
        let mut word = std::mem::take(&mut self.spare);
        (word.ends_file, word.cut) = (false, false);
        word.bytes.clear();
        if !self.skip_blanks()? {
            return Ok(None);
        }
        (word.line, word.begins_line, self.begins_line) = (self.line, self.begins_line, false);
        self.returned = false;
        loop {
            let piece = self.input.fill_buf()?;
            let end = piece.iter().position(|&byte| is_blank(byte));
            let length = end.unwrap_or(piece.len());
            let room = LONGEST - word.bytes.len();
            word.bytes.extend_from_slice(&piece[..length.min(room)]);
            word.cut |= length > room;
            word.ends_file = piece.is_empty();
            self.input.consume(length);
            if end.is_some() || word.ends_file {
                return Ok(Some(word));
            }
        }
    }

    /// Skips blanks; the result is whether anything follows them.
    fn skip_blanks(&mut self) -> io::Result<bool> {
        loop {
            let piece = self.input.fill_buf()?;
            if piece.is_empty() {
                return Ok(false);
            }
            let mut blanks = 0;
            for &byte in piece.iter().take_while(|&&byte| is_blank(byte)) {
                let ends_line = byte == b'\r' || (byte == b'\n' && !self.returned);
                self.line += u64::from(ends_line);
                self.begins_line |= matches!(byte, b'\r' | b'\n');
                self.returned = byte == b'\r';
                blanks += 1;
            }
            let found = blanks < piece.len();
            self.input.consume(blanks);
            if found {
                return Ok(true);
            }
        }
    }
}

/// Whether a byte is a blank, an end of a line, or another character that names do not have.
fn is_blank(byte: u8) -> bool {
    byte <= b' '
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &[u8]) -> Vec<(String, u64, bool)> {
        // Each piece has one byte, so that every word crosses the ends of pieces.
        let mut words =
            Words::new(io::BufReader::with_capacity(3, text)).expect("memory can be read");
        let mut found = vec![];
        while words.advance().expect("memory can be read") {
            let word = words.current();
            found.push((
                String::from_utf8_lossy(&word.bytes).into_owned(),
                word.line,
                word.begins_line,
            ));
        }
        found
    }

    #[test]
    fn lines_end_as_any_system_ends_them() {
        let expected = [("a", 1, true), ("b", 1, false), ("c", 2, true), ("d", 4, true)];
        let expected = expected.map(|(word, line, begins)| (word.to_owned(), line, begins));
        for text in
            ["a b\nc\n\nd\n", "a b\r\nc\r\n\r\nd\r\n", "a b\rc\r\rd", "\u{feff}a\tb\n  c\n\nd"]
        {
            assert_eq!(words(text.as_bytes()), expected, "{text:?}");
        }
    }

    #[test]
    fn the_last_word_knows_that_nothing_follows() {
        for (text, ends) in [("a b", true), ("a b\n", false)] {
            let mut words = Words::new(text.as_bytes()).expect("memory can be read");
            assert!(words.advance().expect("memory can be read") && !words.current().ends_file);
            assert!(words.advance_in_line().expect("memory can be read"));
            assert_eq!(words.current().ends_file, ends);
            assert!(words.peek().expect("memory can be read").is_none());
        }
    }

    #[test]
    fn long_words_are_cut() {
        let text = [vec![b'x'; 2 * LONGEST], b" y".to_vec()].concat();
        let mut words = Words::new(text.as_slice()).expect("memory can be read");
        assert!(words.advance().expect("memory can be read"));
        assert!(words.current().cut && words.current().bytes.len() == LONGEST);
        assert!(words.advance().expect("memory can be read"));
        assert_eq!(words.current().bytes, b"y");
    }
}
