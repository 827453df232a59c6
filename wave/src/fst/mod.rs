//! Reading FST files with fst-reader. Lengths are checked before it sees them, and its panics are
//! caught.
mod chain;
mod check;
mod error;
mod hierarchy;
mod integer;
mod times;

use std::cell::RefCell;
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::ops::ControlFlow;
use std::rc::Rc;

use fst_reader::{
    FstFilter, FstReader, FstSignalHandle, FstSignalValue, ReadSignalsError, ReaderError,
};

use super::catch_panic::catch_panic;
use super::clock;
use super::contents::Contents;
use super::input::Bytes;
use super::raw::{Change, ChangeSink, Raw};
use super::survey::{LATEST, Survey};
use super::variables::{Kind, arrange};
use super::warnings::Warnings;
use check::ValueBlock;
use error::wrong;
use hierarchy::Hierarchy;

/// An opened FST file.
pub struct Fst {
    reader: FstReader<BufReader<Shared>>,
    /// The same bytes, for checks that precede the reader.
    bytes: Shared,
    blocks: Vec<ValueBlock>,
    /// Whether a signal's values are text.
    is_text: Vec<bool>,
    first: u64,
}

impl Fst {
    /// Opens a file and reads what it declares and the times at which something happens.
    ///
    /// # Errors
    /// An error that says what is wrong with the file, or the operating system's error.
    pub fn read(
        bytes: Box<dyn Bytes>,
        mut survey: Survey,
        warnings: &mut Warnings,
    ) -> io::Result<(Fst, Contents)> {
        let mut bytes = Shared::new(bytes);
        let blocks = check::check(&mut BufReader::new(&mut bytes))?;
        instants(&mut bytes, &blocks, &mut survey)?;
        let open = || FstReader::open(BufReader::new(bytes.clone()));
        let mut reader = catch_panic(open).map_err(|()| contradictory())?.map_err(illegible)?;
        let mut hierarchy = Hierarchy::new(warnings);
        let read = || reader.read_hierarchy(|entry| hierarchy.take(entry));
        catch_panic(read).map_err(|()| contradictory())?.map_err(illegible)?;
        let Hierarchy { scopes, mut variables, .. } = hierarchy;
        arrange(&mut variables, &scopes);
        let signals =
            variables.iter().map(|variable| variable.signal as usize + 1).max().unwrap_or(0);
        let mut is_text = vec![false; signals];
        for variable in variables.iter().filter(|variable| variable.kind == Kind::Other) {
            is_text[variable.signal as usize] = true;
        }
        let first = *survey.time_range().start();
        let time_unit = hierarchy::time_unit(reader.get_header().timescale_exponent);
        let mut fst = Fst { reader, bytes, blocks, is_text, first };
        fst.survey_values(
            clock::outermost(&variables, &scopes).map(|clock| variables[clock].signal),
            &mut survey,
        )?;
        Ok((fst, Contents { scopes, variables, time_unit, survey }))
    }

    /// Gives every change of some signals before the time `end`.
    ///
    /// # Errors
    /// An error that says what is wrong with the values, or the operating system's error.
    pub fn changes(&mut self, signals: &[u32], end: u64, take: &mut ChangeSink) -> io::Result<()> {
        let Some(last) = end.checked_sub(1) else { return Ok(()) };
        self.read_signals(0, last, signals, take)
    }

    /// Finds the clock's period, and whether something changes at the last instant.
    fn survey_values(&mut self, clock: Option<u32>, survey: &mut Survey) -> io::Result<()> {
        if self.blocks.is_empty() {
            return Ok(());
        }
        if let Some(clock) = clock {
            survey.watch(clock);
            self.changes(&[clock], u64::MAX, &mut |change| {
                survey.level(clock, change.time, matches!(change.value, Raw::Bits([.., b'1'])));
                ControlFlow::Continue(())
            })?;
        }
        let last = *survey.time_range().end();
        let every: Vec<u32> = (0..self.is_text.len() as u32).collect();
        self.read_signals(last, last, &every, &mut |change| {
            if change.time != last {
                return ControlFlow::Continue(());
            }
            survey.change();
            ControlFlow::Break(())
        })
    }

    fn read_signals(
        &mut self,
        from: u64,
        last: u64,
        signals: &[u32],
        take: &mut ChangeSink,
    ) -> io::Result<()> {
        let numbers: Vec<usize> = signals.iter().map(|&signal| signal as usize).collect();
        let mut bytes = BufReader::new(self.bytes.clone());
        for block in self.blocks.iter().filter(|block| block.first <= last && block.last >= from) {
            chain::check(&mut bytes, block, &numbers)?;
        }
        let (is_text, first) = (&self.is_text, self.first);
        let filter = FstFilter::new(
            from,
            last,
            numbers.into_iter().map(FstSignalHandle::from_index).collect(),
        );
        let read = || {
            self.reader.read_signals(&filter, |time, handle, value| {
                let index = handle.get_index();
                let value = match value {
                    FstSignalValue::Real(number) => Raw::Real(number),
                    FstSignalValue::String(text) if is_text.get(index) == Some(&true) => {
                        Raw::Text(text)
                    }
                    FstSignalValue::String(bits) => Raw::Bits(bits),
                };
                // A writer states every value at the beginning of a block.
                let change = Change {
                    time: time.min(LATEST),
                    signal: index as u32,
                    value,
                    checkpoint: time == first,
                };
                if take(change).is_break() { Err(()) } else { Ok(()) }
            })
        };
        match catch_panic(read).map_err(|()| contradictory())? {
            Ok(()) | Err(ReadSignalsError::CallbackError(())) => Ok(()),
            Err(ReadSignalsError::ReadError(error)) => Err(illegible(error)),
        }
    }
}

/// Surveys the times of all blocks.
fn instants(bytes: &mut Shared, blocks: &[ValueBlock], survey: &mut Survey) -> io::Result<()> {
    for block in blocks {
        // Values that hold from the beginning of a block have no time in its table.
        survey.instant(block.first.min(LATEST));
        times::read(bytes, block, |time| survey.instant(time.min(LATEST)))?;
    }
    Ok(())
}

fn contradictory() -> io::Error {
    wrong("what it says of its values and where they are is contradictory")
}

fn illegible(error: ReaderError) -> io::Error {
    match error {
        ReaderError::Io(reason) if reason.kind() != io::ErrorKind::UnexpectedEof => reason,
        _ => wrong("its list of signals or their values cannot be understood"),
    }
}

/// Bytes that several readers share, each with a position of its own.
#[derive(Clone)]
struct Shared {
    bytes: Rc<RefCell<Box<dyn Bytes>>>,
    at: u64,
}

impl Shared {
    fn new(bytes: Box<dyn Bytes>) -> Shared {
        Shared { bytes: Rc::new(RefCell::new(bytes)), at: 0 }
    }
}

impl Read for Shared {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let mut bytes = self.bytes.borrow_mut();
        bytes.seek(SeekFrom::Start(self.at))?;
        let count = bytes.read(into)?;
        self.at += count as u64;
        Ok(count)
    }
}

impl Seek for Shared {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let mut bytes = self.bytes.borrow_mut();
        bytes.seek(SeekFrom::Start(self.at))?;
        self.at = bytes.seek(to)?;
        Ok(self.at)
    }
}
