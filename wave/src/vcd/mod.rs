//! Reading VCD files: a first pass for declarations and times, and another for the values of chosen
//! signals, so that a file may be larger than the memory.
mod declaration;
mod number;
mod parser;
mod text;
mod values;
mod words;

use std::io::{self, BufReader};

use super::clock;
use super::contents::Contents;
use super::input::Bytes;
use super::raw::{Change, ChangeSink, Raw};
use super::survey::Survey;
use super::variables::{Enumerations, ScopeId, Scopes, Variable, arrange};
use super::warnings::Warnings;
use declaration::Attribute;
use parser::{Event, Ids, Parser};

/// Number of bytes that are read at a time.
const PIECE: usize = 1 << 16;

/// A VCD file after the first pass.
pub struct Vcd {
    bytes: Box<dyn Bytes>,
    ids: Ids,
    /// The first time. Values that stand before any time hold from there.
    first: u64,
}

impl Vcd {
    /// Reads the declarations of a file and the times at which something happens.
    ///
    /// # Errors
    /// The operating system's error.
    pub fn read(
        mut bytes: Box<dyn Bytes>,
        survey: Survey,
        warnings: &mut Warnings,
    ) -> io::Result<(Vcd, Contents)> {
        bytes.rewind()?;
        let mut ids = Ids::default();
        let mut reader = Reader::new(survey);
        let mut parser =
            Parser::new(BufReader::with_capacity(PIECE, &mut bytes), &mut ids, warnings)?;
        while let Some(event) = parser.next()? {
            reader.take(event, &mut parser);
        }
        let Reader { survey, scopes, mut variables, time_unit, .. } = reader;
        arrange(&mut variables, &scopes);
        let first = *survey.time_range().start();
        Ok((Vcd { bytes, ids, first }, Contents { scopes, variables, time_unit, survey }))
    }

    /// Gives every change before the time `end`.
    ///
    /// # Errors
    /// The operating system's error.
    pub fn changes(&mut self, end: u64, take: &mut ChangeSink) -> io::Result<()> {
        self.bytes.rewind()?;
        // The warnings were given in the first pass.
        let mut told = Warnings::default();
        let mut parser = Parser::new(
            BufReader::with_capacity(PIECE, &mut self.bytes),
            &mut self.ids,
            &mut told,
        )?;
        let mut time = self.first;
        while let Some(event) = parser.next()? {
            match event {
                Event::Time(now) => time = now,
                Event::Change(signal) if time < end => {
                    let change = Change {
                        time,
                        signal,
                        value: parser.value(),
                        checkpoint: parser.in_checkpoint(),
                    };
                    if take(change).is_break() {
                        break;
                    }
                }
                _ => {}
            }
            if time >= end {
                break;
            }
        }
        Ok(())
    }
}

/// The state of the first pass.
struct Reader {
    survey: Survey,
    scopes: Scopes,
    /// The scopes that are open at the current place.
    open: Vec<ScopeId>,
    variables: Vec<Variable>,
    enumerations: Enumerations,
    time_unit: Option<String>,
}

impl Reader {
    fn new(survey: Survey) -> Reader {
        let (scopes, enumerations) = (Scopes::new(), Enumerations::default());
        Reader { survey, scopes, open: vec![], variables: vec![], enumerations, time_unit: None }
    }

    fn take<R: io::BufRead>(&mut self, event: Event, parser: &mut Parser<R>) {
        match event {
            Event::Scope(name) => {
                let around = self.scope();
                let inner = self.scopes.child(around, &name);
                if inner.is_none() {
                    parser.warn("deep", || {
                        "scopes are too many or nest too deep: what is inside is taken for the outer's".to_owned()
                    });
                }
                self.open.push(inner.unwrap_or(around));
            }
            Event::Upscope => {
                if self.open.pop().is_none() {
                    parser.warn("upscope", || {
                        "`$upscope` ends no scope, and is passed over".to_owned()
                    });
                }
            }
            Event::Variable(declared, signal) => {
                let (scope, width) = (self.scope(), declared.width);
                if width == Some(1) && clock::is_clock(&declared.name) {
                    self.survey.watch(signal);
                }
                let names = self.enumerations.take_next();
                let (name, range, kind, port) =
                    (declared.name, declared.range, declared.kind, declared.port);
                self.variables.push(Variable {
                    scope,
                    name,
                    range,
                    kind,
                    width,
                    port,
                    signal,
                    names,
                });
            }
            Event::Attribute(Attribute::Enumeration(number, names)) => {
                self.enumerations.declare(number, names)
            }
            Event::Attribute(Attribute::Next(number)) => self.enumerations.announce(number),
            Event::TimeUnit(unit) => self.time_unit = Some(unit),
            Event::Time(time) => self.survey.instant(time),
            Event::Change(signal) => {
                // A change that stands before any time holds from the beginning.
                if self.survey.is_empty() {
                    self.survey.instant(0);
                }
                self.survey.change();
                if let Raw::Bits(bits) = parser.value() {
                    let now = *self.survey.time_range().end();
                    self.survey.level(signal, now, bits.last() == Some(&b'1'));
                }
            }
        }
    }

    fn scope(&self) -> ScopeId {
        self.open.last().copied().unwrap_or(Scopes::NONE)
    }
}
