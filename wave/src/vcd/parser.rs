//! The grammar of VCD files, in every dialect that simulators write.
//!
//! IEEE 1364, 18.2 and 18.4, defines them. The parser also reads sections in any place, even behind
//! `$enddefinitions` or without it; vectors of any length; text (`sTEXT ID`) of GTKWave and related
//! tools; and the nine states of VHDL. What it does not understand is skipped with a warning.
use std::collections::HashMap;
use std::io::{self, BufRead};

use super::super::raw::Raw;
use super::super::survey::LATEST;
use super::super::variables::MAX_VARIABLES;
use super::super::warnings::{Warnings, quoted};
use super::declaration::{self, Attribute, Declaration, Fault};
use super::number::Time;
use super::words::{Word, Words};

/// A parsed item of a VCD file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Event {
    /// A scope begins.
    Scope(String),
    /// A scope ends.
    Upscope,
    /// A variable, and the number of its signal.
    Variable(Declaration, u32),
    /// The unit of time.
    TimeUnit(String),
    /// An attribute of an enumeration.
    Attribute(Attribute),
    /// The current time; it may be the same as before.
    Time(u64),
    /// The signal of that number takes the value [`Parser::value`].
    Change(u32),
}

/// The identifiers that a file declares.
#[derive(Clone, Debug, Default)]
pub struct Ids {
    /// The signals' numbers, by identifier; `None` for signals that are not drawn.
    pub(super) numbers: HashMap<Vec<u8>, Option<u32>>,
    /// The largest width of each signal's variables; `None` if the file does not state it.
    pub(super) widths: Vec<Option<u32>>,
}

impl Ids {
    fn declare(&mut self, declaration: &Declaration) -> u32 {
        // At most `MAX_VARIABLES` identifiers come here.
        let next = self.widths.len() as u32;
        let number = *self.numbers.entry(declaration.id.clone()).or_default().get_or_insert(next);
        if number == next {
            self.widths.push(declaration.width);
        }
        let width = &mut self.widths[number as usize];
        *width = (*width).max(declaration.width);
        number
    }

    fn leave_out(&mut self, id: Vec<u8>) {
        self.numbers.entry(id).or_default();
    }
}

/// Number of words of a section that are kept, and of bytes of each.
const MAX_WORDS: usize = 1024;
pub(super) const LONGEST_WORD: usize = 4096;

/// The kind of value that the parser holds of the last change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Held {
    Bits,
    Text,
    Real(f64),
}

/// Parses a VCD file event by event.
pub struct Parser<'a, R> {
    pub(super) words: Words<R>,
    pub(super) ids: &'a mut Ids,
    pub(super) warnings: &'a mut Warnings,
    variables: usize,
    now: Option<u64>,
    pub(super) checkpoint: bool,
    pub(super) held: Held,
    /// The bits or the text of the last change.
    pub(super) bytes: Vec<u8>,
    ended: bool,
}

impl<'a, R: BufRead> Parser<'a, R> {
    /// A parser for a file with these identifiers, to which it adds those that it finds.
    ///
    /// # Errors
    /// The operating system's error.
    pub fn new(
        input: R,
        ids: &'a mut Ids,
        warnings: &'a mut Warnings,
    ) -> io::Result<Parser<'a, R>> {
        let words = Words::new(input)?;
        let (held, bytes) = (Held::Text, vec![]);
        Ok(Parser {
            words,
            ids,
            warnings,
            variables: 0,
            now: None,
            checkpoint: false,
            held,
            bytes,
            ended: false,
        })
    }

    /// The value of the last change.
    pub fn value(&self) -> Raw<'_> {
        match self.held {
            Held::Bits => Raw::Bits(&self.bytes),
            Held::Text => Raw::Text(&self.bytes),
            Held::Real(number) => Raw::Real(number),
        }
    }

    /// Whether the last change stands in `$dumpvars` or a similar section.
    pub fn in_checkpoint(&self) -> bool {
        self.checkpoint
    }

    /// Records a warning about the current line.
    pub fn warn(&mut self, kind: &'static str, words: impl FnOnce() -> String) {
        self.warnings.in_line(self.words.current().line, kind, words);
    }

    /// The next event, if there is one.
    ///
    /// # Errors
    /// The operating system's error.
    pub fn next(&mut self) -> io::Result<Option<Event>> {
        while self.words.advance()? {
            let event = match self.words.current().bytes[0] {
                b'$' => self.section()?,
                b'#' => self.time()?,
                b'b' | b'B' => self.vector()?,
                b'r' | b'R' => self.real()?,
                b's' | b'S' => self.text()?,
                b'p' | b'P' => self.port()?,
                _ => self.scalar()?,
            };
            if event.is_some() {
                return Ok(event);
            }
        }
        self.end();
        Ok(None)
    }

    fn end(&mut self) {
        let last = self.words.current();
        if !self.ended && last.ends_file && last.bytes != b"$end" {
            let last = quoted(&last.bytes);
            self.warn("cut off", || format!("the file ends within a line: {last} may be cut off"));
        }
        self.ended = true;
    }

    fn fault(&mut self, (kind, words): Fault) {
        self.warn(kind, || words);
    }

    fn section(&mut self) -> io::Result<Option<Event>> {
        let keyword = self.words.current().bytes.to_ascii_lowercase();
        match keyword.as_slice() {
            b"$end" => self.checkpoint = false,
            b"$enddefinitions" | b"$enddefinitions$end" | b"$vcdclose" | b"$dumpportsflush" => {}
            keyword if CHECKPOINTS.contains(&keyword) => self.checkpoint = true,
            b"$comment" => drop(self.content(|_| false)?),
            keyword if PASSED_OVER.contains(&keyword) => drop(self.content(is_section)?),
            b"$timezero" => {
                self.warn("time zero", || {
                    "`$timezero` is passed over: times are drawn as they stand".to_owned()
                });
                self.content(is_section)?;
            }
            b"$attrbegin" => {
                return Ok(declaration::attribute(&self.content(is_section)?).map(Event::Attribute));
            }
            b"$timescale" => return self.time_unit(),
            b"$scope" => return self.scope(),
            b"$upscope$end" => return Ok(Some(Event::Upscope)),
            b"$upscope" => {
                self.content(is_section)?;
                return Ok(Some(Event::Upscope));
            }
            b"$var" => return self.variable(),
            // This is the beginning of a keyword; another warning says that the file ends in it.
            _ if self.words.current().ends_file => {}
            _ => {
                let word = quoted(&self.words.current().bytes);
                self.warn("section", || {
                    format!("the section {word} is not known, and passed over")
                });
                self.content(|word| is_section(word) || is_time(word))?;
            }
        }
        Ok(None)
    }

    /// The words of a section up to its `$end`, or up to where another section begins.
    fn content(&mut self, begins_another: impl Fn(&Word) -> bool) -> io::Result<Vec<Vec<u8>>> {
        let (begin, name) = (self.words.current().line, self.words.current().bytes.clone());
        let mut content = vec![];
        loop {
            match self.words.peek()? {
                Some(word) if word.bytes == b"$end" => {
                    self.words.advance()?;
                    return Ok(content);
                }
                Some(word) if !begins_another(word) => self.words.advance()?,
                _ => break,
            };
            // Some writers leave out the blank before `$end`.
            let ends = self.words.current().bytes.ends_with(b"$end")
                && self.words.peek()?.is_none_or(|word| word.begins_line);
            let bytes = &self.words.current().bytes;
            let bytes = if ends { &bytes[..bytes.len() - b"$end".len()] } else { bytes };
            if content.len() < MAX_WORDS {
                content.push(bytes[..bytes.len().min(LONGEST_WORD)].to_vec());
            }
            if ends {
                return Ok(content);
            }
        }
        self.warnings.in_line(begin, "open section", || format!("{} has no `$end`", quoted(&name)));
        Ok(content)
    }

    fn time_unit(&mut self) -> io::Result<Option<Event>> {
        let content = self.content(is_section)?;
        let unit = declaration::time_unit(&content);
        if unit.is_none() {
            self.warn("unit", || format!("{} is no unit of time", quoted(&content.join(&b' '))));
        }
        Ok(unit.map(Event::TimeUnit))
    }

    fn scope(&mut self) -> io::Result<Option<Event>> {
        let content = self.content(is_section)?;
        match declaration::scope(&content) {
            Ok((name, odd)) => {
                odd.into_iter().for_each(|odd| self.fault(odd));
                Ok(Some(Event::Scope(name)))
            }
            Err(fault) => {
                self.fault(fault);
                Ok(None)
            }
        }
    }

    fn variable(&mut self) -> io::Result<Option<Event>> {
        let content = self.content(is_section)?;
        self.variables += 1;
        let declared = match declaration::variable(&content) {
            Ok(_) if self.variables > MAX_VARIABLES => {
                let fault = (
                    "many",
                    format!(
                        "there are more than {MAX_VARIABLES} variables: the others are left out"
                    ),
                );
                Err((fault, None))
            }
            declared => declared,
        };
        match declared {
            Ok((declaration, odd)) => {
                odd.into_iter().for_each(|odd| self.fault(odd));
                let number = self.ids.declare(&declaration);
                Ok(Some(Event::Variable(declaration, number)))
            }
            Err((fault, id)) => {
                self.fault(fault);
                // Variables beyond the limit count as undeclared.
                let id = id.filter(|_| self.variables <= MAX_VARIABLES);
                id.into_iter().for_each(|id| self.ids.leave_out(id));
                Ok(None)
            }
        }
    }

    fn time(&mut self) -> io::Result<Option<Event>> {
        if self.words.current().bytes.len() == 1 && !self.words.advance_in_line()? {
            self.warn("time", || "`#` without a time is passed over".to_owned());
            return Ok(None);
        }
        let word = self.words.current().bytes.clone();
        let word = word.strip_prefix(b"#").unwrap_or(&word);
        let Some(parsed) = Time::parse(word) else {
            self.warn("time", || format!("{} is no time, and passed over", quoted(word)));
            return Ok(None);
        };
        let stated = match parsed {
            Time::Whole(time) => time,
            Time::Fraction(time) => {
                self.warn("fraction", || {
                    format!("the time {} is drawn without its fraction", quoted(word))
                });
                time
            }
            Time::Negative => {
                self.warn("negative", || {
                    format!("the time {} lies before 0, and is drawn at 0", quoted(word))
                });
                0
            }
            Time::TooLarge => {
                self.warn("late", || {
                    format!("the time {} is too large, and drawn at {LATEST}", quoted(word))
                });
                LATEST
            }
        };
        let now = self.now.map_or(stated, |now| now.max(stated));
        if now != stated {
            self.warn("back", || {
                format!("time goes back from {now} to {stated}: what follows is drawn at {now}")
            });
        }
        self.now = Some(now);
        Ok(Some(Event::Time(now)))
    }
}

/// Sections that contain values.
const CHECKPOINTS: [&[u8]; 8] = [
    b"$dumpvars",
    b"$dumpall",
    b"$dumpon",
    b"$dumpoff",
    b"$dumpports",
    b"$dumpportsall",
    b"$dumpportson",
    b"$dumpportsoff",
];
/// Sections whose contents are not drawn.
const PASSED_OVER: [&[u8]; 5] =
    [b"$date", b"$version", b"$attrend", b"$dumpportslimit", b"$dumplimit"];
/// Sections whose keyword also ends a section that has no `$end`.
const DECLARATIONS: [&[u8]; 8] = [
    b"$date",
    b"$version",
    b"$timescale",
    b"$scope",
    b"$upscope",
    b"$var",
    b"$comment",
    b"$enddefinitions",
];

fn is_section(word: &Word) -> bool {
    let known = |bytes: &[u8]| DECLARATIONS.contains(&bytes) || CHECKPOINTS.contains(&bytes);
    word.begins_line && known(&word.bytes)
}

fn is_time(word: &Word) -> bool {
    word.begins_line
        && word.bytes.strip_prefix(b"#").is_some_and(|time| Time::parse(time).is_some())
}
