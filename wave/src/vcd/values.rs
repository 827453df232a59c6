//! Values in VCD files: scalars, vectors, real numbers, text and ports, each with an identifier.
use std::io::{self, BufRead};
use std::ops::Range;

use super::super::raw::STATES;
use super::super::warnings::quoted;
use super::number::real;
use super::parser::{Event, Held, LONGEST_WORD, Parser};
use super::text::unescaped;
use super::words::Word;

impl<R: BufRead> Parser<'_, R> {
    pub(super) fn scalar(&mut self) -> io::Result<Option<Event>> {
        let word = &self.words.current().bytes;
        let state = word[0].to_ascii_lowercase();
        let known = STATES.contains(&state);
        if !known && !self.ids.numbers.contains_key(&word[1..]) {
            let word = quoted(word);
            self.warn("word", || format!("{word} is not understood, and passed over"));
            return Ok(None);
        }
        self.hold_bits(0..1);
        let id = if self.words.current().bytes.len() > 1 {
            Some(1)
        } else {
            self.words.advance_in_line()?.then_some(0)
        };
        Ok(self.change(id))
    }

    pub(super) fn vector(&mut self) -> io::Result<Option<Event>> {
        let length = self.words.current().bytes.len();
        self.hold_bits(1..length);
        if length == 1 && self.words.peek()?.is_some_and(|word| !word.begins_line && is_bits(word))
        {
            // Either the bits follow a blank, or there are no bits and the identifier looks like
            // bits.
            self.words.advance()?;
            if self.words.peek()?.is_none_or(|word| word.begins_line) {
                return Ok(self.vector_of(Some(0)));
            }
            let length = self.words.current().bytes.len();
            self.hold_bits(0..length);
        }
        if self.words.current().cut {
            self.warn("too long", || {
                "a value of more than a million bits is passed over".to_owned()
            });
            self.advance_to_id()?;
            return Ok(None);
        }
        let id = self.advance_to_id()?;
        Ok(self.vector_of(id))
    }

    fn vector_of(&mut self, id: Option<usize>) -> Option<Event> {
        let event = self.change(id);
        if let Some(Event::Change(number)) = event {
            self.check_width(number);
        }
        event
    }

    /// Keeps the bits of the current word; a character that is no state of a bit becomes an x.
    fn hold_bits(&mut self, range: Range<usize>) {
        self.held = Held::Bits;
        self.bytes.clear();
        let word = &self.words.current().bytes;
        self.bytes.extend(word[range].iter().map(u8::to_ascii_lowercase));
        let wrong = self.bytes.iter().position(|bit| !STATES.contains(bit));
        if let Some(wrong) = wrong {
            let (bit, word) = (quoted(&self.bytes[wrong..=wrong]), quoted(word));
            self.warn("state", || format!("{bit} in {word} is no state of a bit, and drawn as x"));
            self.bytes.iter_mut().filter(|bit| !STATES.contains(bit)).for_each(|bit| *bit = b'x');
        }
    }

    fn check_width(&mut self, number: u32) {
        let Some(width) = self.ids.widths[number as usize] else { return };
        let length = self.bytes.len();
        if length > width as usize {
            let said = || {
                format!("a value of {length} bits for a signal of {width}: its lowest are drawn")
            };
            self.warn("longer", said);
        }
        if length == 0 {
            self.warn("empty", || "a value without bits is drawn as x".to_owned());
            self.bytes.push(b'x');
        }
    }

    pub(super) fn real(&mut self) -> io::Result<Option<Event>> {
        let alone = self.words.current().bytes.len() == 1;
        let is_number = |word: &Word| !word.begins_line && real(&word.bytes).is_some();
        // The number may follow a blank.
        let behind_blank = alone && self.words.peek()?.is_some_and(is_number);
        let from = if behind_blank && self.words.advance()? { 0 } else { 1 };
        match real(&self.words.current().bytes[from..]) {
            Some(number) => self.held = Held::Real(number),
            None => {
                self.hold_text(from);
                let word = quoted(&self.bytes);
                self.warn("number", || format!("{word} is no number, and drawn as text"));
            }
        }
        let id = self.advance_to_id()?;
        Ok(self.change(id))
    }

    /// Keeps the current word as text, from a position on.
    fn hold_text(&mut self, from: usize) {
        self.held = Held::Text;
        self.bytes.clear();
        self.bytes.extend_from_slice(&self.words.current().bytes[from..]);
    }

    /// Reads a text, which may contain blanks: the identifier is the first declared one of its
    /// line.
    pub(super) fn text(&mut self) -> io::Result<Option<Event>> {
        self.hold_text(1);
        let mut id = None;
        while self.words.advance_in_line()? {
            id = Some(0);
            let word = &self.words.current().bytes;
            let declared = self.ids.numbers.contains_key(word.as_slice());
            if declared || self.words.peek()?.is_none_or(|word| word.begins_line) {
                break;
            }
            if self.bytes.len() < LONGEST_WORD {
                self.bytes.push(b' ');
                self.bytes.extend_from_slice(&self.words.current().bytes);
            }
        }
        self.bytes.truncate(LONGEST_WORD);
        self.bytes = unescaped(&self.bytes);
        Ok(self.change(id))
    }

    /// Reads a port of an extended dump (IEEE 1364, 18.4.3): states, two strengths, identifier.
    pub(super) fn port(&mut self) -> io::Result<Option<Event>> {
        let states: Option<Vec<u8>> =
            self.words.current().bytes[1..].iter().map(|&state| port_state(state)).collect();
        let Some(states) = states else {
            let word = quoted(&self.words.current().bytes);
            self.warn("word", || format!("{word} is not understood, and passed over"));
            return Ok(None);
        };
        self.warn("port", || {
            "of the values of ports neither strengths nor drivers are drawn".to_owned()
        });
        (self.held, self.bytes) = (Held::Bits, states);
        let mut id = None;
        for _ in 0..3 {
            if self.words.advance_in_line()? {
                id = Some(0);
            }
        }
        Ok(self.change(id))
    }

    /// Advances to the identifier of a value, in the same line or, if it is a declared one, in the
    /// next. The result is the position of the identifier in its word.
    fn advance_to_id(&mut self) -> io::Result<Option<usize>> {
        if self.words.advance_in_line()? {
            return Ok(Some(0));
        }
        let ids = &self.ids.numbers;
        let declared =
            self.words.peek()?.is_some_and(|word| ids.contains_key(word.bytes.as_slice()));
        Ok((declared && self.words.advance()?).then_some(0))
    }

    /// The change of the signal whose identifier begins at a position in the current word.
    fn change(&mut self, id: Option<usize>) -> Option<Event> {
        let Some(from) = id else {
            let word = quoted(&self.words.current().bytes);
            self.warn("no identifier", || {
                format!("the value {word} has no identifier, and is passed over")
            });
            return None;
        };
        let id = &self.words.current().bytes[from..];
        match self.ids.numbers.get(id) {
            Some(&number) => number.map(Event::Change),
            None => {
                let id = quoted(id);
                self.warn("undeclared", || {
                    format!("no variable has the identifier {id}: its values are passed over")
                });
                None
            }
        }
    }
}

fn is_bits(word: &Word) -> bool {
    word.bytes.iter().all(|bit| STATES.contains(&bit.to_ascii_lowercase()))
}

/// The state of a bit for a port's state, whichever side drives it (IEEE 1364, table 18-11).
fn port_state(state: u8) -> Option<u8> {
    match state {
        b'D' | b'd' | b'L' | b'l' | b'0' => Some(b'0'),
        b'U' | b'u' | b'H' | b'h' | b'1' => Some(b'1'),
        b'Z' | b'T' | b'F' => Some(b'z'),
        b'N' | b'X' | b'?' | b'A' | b'a' | b'B' | b'b' | b'C' | b'c' | b'f' => Some(b'x'),
        _ => None,
    }
}
