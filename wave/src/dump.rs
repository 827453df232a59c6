//! A dump: the variables of a VCD or FST file, and the values they take.
use std::collections::HashMap;
use std::io;
use std::ops::{ControlFlow, Range, RangeInclusive};
use std::path::{Path, PathBuf};

use super::contents::Contents;
use super::error::WaveError;
use super::fst::Fst;
use super::input::{Format, Input, InputError, STANDARD_INPUT};
use super::raw::Change;
use super::segments::{Collector, Segment};
use super::survey::Survey;
use super::variables::{Scopes, Variable};
use super::vcd::Vcd;
use super::warnings::{Warnings, clean};

/// An opened dump.
pub struct Dump {
    path: PathBuf,
    reader: Reader,
    contents: Contents,
}

/// The reader of a dump's values.
enum Reader {
    Vcd(Box<Vcd>),
    Fst(Box<Fst>),
}

/// Limits for one figure: the number of values, and the bytes that they take. A figure with more of
/// them would be of no use.
pub const MAX_VALUES: usize = 200_000;
const MAX_BYTES: usize = 256 << 20;

impl Dump {
    /// Opens the file, or standard input for `-`; `marker` is a marked time, whose surroundings are
    /// surveyed.
    ///
    /// # Errors
    /// [`WaveError`] if it is not there, not a dump, damaged, or without signals or times.
    pub fn open(
        path: &Path,
        marker: Option<u64>,
        warnings: &mut Warnings,
    ) -> Result<Dump, WaveError> {
        let input = Input::open(path, warnings).map_err(|error| refused(path, error))?;
        let survey = Survey::new(marker);
        let (reader, contents) = match input.format {
            Format::Vcd => Vcd::read(input.bytes, survey, warnings)
                .map(|(vcd, contents)| (Reader::Vcd(Box::new(vcd)), contents)),
            Format::Fst => Fst::read(input.bytes, survey, warnings)
                .map(|(fst, contents)| (Reader::Fst(Box::new(fst)), contents)),
        }
        .map_err(|reason| unreadable(path, reason))?;
        let passed_over =
            || warnings.lines(&file_name(path)).iter().map(|line| format!("\n{line}")).collect();
        let empty = |missing| {
            Err(WaveError::Empty { path: path.to_owned(), missing, passed_over: passed_over() })
        };
        match (contents.variables.is_empty(), contents.survey.is_empty()) {
            (true, _) => empty("signals"),
            (_, true) => empty("values"),
            _ => Ok(Dump { path: path.to_owned(), reader, contents }),
        }
    }

    /// The file's name, without its folder.
    pub fn file_name(&self) -> String {
        file_name(&self.path)
    }

    /// Every variable, scope by scope.
    pub fn variables(&self) -> &[Variable] {
        &self.contents.variables
    }

    /// The scopes that the variables are in.
    pub fn scopes(&self) -> &Scopes {
        &self.contents.scopes
    }

    /// A variable's full name: the names of its scopes and its own, joined by dots.
    pub fn full_name(&self, variable: usize) -> String {
        let variable = &self.variables()[variable];
        let path = self.scopes().path(variable.scope);
        if path.is_empty() { variable.name.clone() } else { format!("{path}.{}", variable.name) }
    }

    /// The times at which something happens.
    pub fn survey(&self) -> &Survey {
        &self.contents.survey
    }

    /// The range from the first time to the last, both included.
    pub fn time_range(&self) -> RangeInclusive<u64> {
        self.survey().time_range()
    }

    /// The unit of time, such as `ns` or `10 ps`.
    pub fn time_unit(&self) -> String {
        self.contents.time_unit.clone().unwrap_or_else(|| "unknown units".to_owned())
    }

    /// The values of some variables in `window`, in order. There is none for a time before the
    /// first value; the last one holds until `end`.
    ///
    /// # Errors
    /// [`WaveError`] if they cannot be read, or are far too many.
    pub fn segments(
        &mut self,
        variables: &[usize],
        window: &Range<u64>,
        end: u64,
    ) -> Result<Vec<Vec<Segment>>, WaveError> {
        let all = &self.contents.variables;
        let mut collectors: Vec<Collector> =
            variables.iter().map(|&index| Collector::new(&all[index], window)).collect();
        let mut places: HashMap<u32, Vec<usize>> = HashMap::new();
        for (place, &index) in variables.iter().enumerate() {
            places.entry(all[index].signal).or_default().push(place);
        }
        let (mut values, mut bytes) = (0, 0);
        let mut take = |change: Change| {
            for &place in places.get(&change.signal).into_iter().flatten() {
                let collector = &mut collectors[place];
                let before = collector.count();
                bytes += collector.take(&change);
                values += collector.count() - before;
            }
            let enough = values > MAX_VALUES || bytes > MAX_BYTES;
            if enough { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        match &mut self.reader {
            Reader::Vcd(vcd) => vcd.changes(window.end, &mut take),
            Reader::Fst(fst) => {
                fst.changes(&places.keys().copied().collect::<Vec<_>>(), window.end, &mut take)
            }
        }
        .map_err(|reason| unreadable(&self.path, reason))?;
        if values > MAX_VALUES || bytes > MAX_BYTES {
            return Err(WaveError::Large {
                signals: variables.len(),
                amount: format!("more than {values} values"),
            });
        }
        Ok(collectors.into_iter().map(|collector| collector.finish(end)).collect())
    }
}

/// The name of a file as messages give it.
pub fn file_name(path: &Path) -> String {
    if path == Path::new(STANDARD_INPUT) {
        return "standard input".to_owned();
    }
    path.file_name().map(|name| clean(&name.to_string_lossy())).unwrap_or_default()
}

fn refused(path: &Path, error: InputError) -> WaveError {
    match error {
        InputError::Unreadable(reason) => unreadable(path, reason),
        InputError::Kind => WaveError::Kind { path: path.to_owned() },
        InputError::Damaged(reason) => WaveError::Damaged { path: path.to_owned(), reason },
    }
}

/// Turns what the system or one of our readers says of the file into an error.
fn unreadable(path: &Path, reason: io::Error) -> WaveError {
    let path = path.to_owned();
    match reason.kind() {
        io::ErrorKind::InvalidData => WaveError::Damaged { path, reason: reason.to_string() },
        io::ErrorKind::UnexpectedEof => {
            WaveError::Damaged { path, reason: "it ends too early".to_owned() }
        }
        _ => WaveError::Unreadable { path, reason },
    }
}
