//! A dump: the variables of a VCD or FST file, and the values they take.
use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufReader};
use std::ops::Range;
use std::path::{Path, PathBuf};

use wellen::viewers::{self, BodyResult, HeaderResult};
use wellen::{
    FileFormat, Hierarchy, ItemRef, LoadOptions, ScopeRef, Signal, SignalRef, SignalSource, SignalValueRef, TimeTable,
    TimescaleUnit, VarDirection, VarRef, WellenError,
};

use super::error::WaveError;
use super::fst_check;
use super::guard::guarded;
use super::value::Value;

/// Width of a signal in bits, at most: its reader makes room for all of them, whether or not the file has them.
const WIDEST: u32 = 1 << 20;

/// An opened dump.
pub struct Dump {
    path: PathBuf,
    waves: Waves,
    /// Every variable, in the order of the file.
    pub variables: Vec<Variable>,
}

/// What the reader keeps of a file.
struct Waves {
    hierarchy: Hierarchy,
    source: SignalSource,
    times: TimeTable,
    /// Those that have been loaded.
    signals: HashMap<SignalRef, Signal>,
}

/// A variable of a dump.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Names of the scopes it is in, from the outside in.
    pub scopes: Vec<String>,
    /// Its name in its scope.
    pub name: String,
    /// Width in bits; none for text, real numbers and events.
    pub width: Option<u32>,
    /// Whether the file says that it is a port.
    pub port: bool,
    signal: SignalRef,
}

impl Variable {
    /// The scopes' names, joined by dots.
    pub fn unit(&self) -> String {
        self.scopes.join(".")
    }

    /// Full name: scopes and all, joined by dots.
    pub fn full_name(&self) -> String {
        self.scopes.iter().chain([&self.name]).map(String::as_str).collect::<Vec<_>>().join(".")
    }
}

/// A value, from when to when.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// In the file's units of time.
    pub time: Range<u64>,
    /// The value.
    pub value: Value,
}

impl Dump {
    /// Opens the file.
    ///
    /// # Errors
    /// [`WaveError`] if it is not there, not a dump, damaged, or without signals or times.
    pub fn open(path: &Path) -> Result<Dump, WaveError> {
        let mut input = reader(path).map_err(|reason| WaveError::Unreadable { path: path.to_owned(), reason })?;
        match viewers::detect_file_format(&mut input) {
            FileFormat::Vcd => {}
            FileFormat::Fst => fst_check::check(&mut input).map_err(|wrong| damaged(path, &wrong.to_string()))?,
            FileFormat::Ghw | FileFormat::Unknown => return Err(WaveError::Kind { path: path.to_owned() }),
        }
        let waves = read(path, input)?;
        let variables = variables(&waves.hierarchy);
        let empty = |missing| Err(WaveError::Empty { path: path.to_owned(), missing });
        match (variables.is_empty(), waves.times.is_empty()) {
            (true, _) => empty("signals"),
            (_, true) => empty("values"),
            _ => Ok(Dump { path: path.to_owned(), waves, variables }),
        }
    }

    /// The file's name.
    pub fn file_name(&self) -> String {
        self.path.file_name().map(|name| clean(&name.to_string_lossy())).unwrap_or_default()
    }

    /// The times at which something happens, increasing; there is at least one.
    pub fn times(&self) -> &[u64] {
        &self.waves.times
    }

    /// From the first time to the last.
    pub fn extent(&self) -> Range<u64> {
        let times = self.times();
        times.first().copied().unwrap_or(0)..times.last().copied().unwrap_or(0)
    }

    /// The unit of time, such as `ns` or `10 ps`.
    pub fn time_unit(&self) -> String {
        let timescale = self.waves.hierarchy.timescale();
        let named = timescale.and_then(|scale| Some((scale.factor, unit_name(scale.unit)?)));
        named.map_or("unknown units".to_owned(), |(factor, unit)| match factor {
            1 => unit.to_owned(),
            factor => format!("{factor} {unit}"),
        })
    }

    /// Reads the values of some variables, so that [`Dump::segments`] has them.
    ///
    /// # Errors
    /// [`WaveError::Damaged`] if they cannot be read.
    pub fn load(&mut self, variables: &[usize]) -> Result<(), WaveError> {
        let signals: Vec<SignalRef> = variables.iter().map(|&index| self.variables[index].signal).collect();
        let Waves { hierarchy, source, .. } = &mut self.waves;
        let loaded = guarded(|| source.load_signals(&signals, hierarchy, false)).map_err(|said| damaged(&self.path, &said))?;
        self.waves.signals.extend(loaded.into_iter().map(|signal| (signal.signal_ref(), signal)));
        Ok(())
    }

    /// The values of a loaded variable in `window`, in order; a time before the first value has none.
    ///
    /// # Errors
    /// [`WaveError::Damaged`] if they are not what the file's header says.
    pub fn segments(&self, variable: usize, window: &Range<u64>) -> Result<Vec<Segment>, WaveError> {
        let Some(signal) = self.waves.signals.get(&self.variables[variable].signal) else { return Ok(vec![]) };
        guarded(|| self.segments_of(signal, window)).map_err(|said| damaged(&self.path, &said))
    }

    fn segments_of(&self, signal: &Signal, window: &Range<u64>) -> Vec<Segment> {
        let times = self.times();
        let time = |index: u32| times[index as usize];
        let changes = signal.time_indices();
        let first = changes.partition_point(|&index| time(index) <= window.start).saturating_sub(1);
        let shown = signal.iter_changes().skip(first).take_while(|&(index, _)| time(index) < window.end);
        let mut segments: Vec<Segment> = vec![];
        for (index, value) in shown {
            let (begin, value) = (time(index).max(window.start), value_of(value));
            match segments.last_mut() {
                // Changes within one instant, and dumps that repeat a value.
                Some(last) if last.time.start == begin => last.value = value,
                Some(last) if last.value == value => {}
                Some(last) => {
                    last.time.end = begin;
                    segments.push(Segment { time: begin..begin, value });
                }
                None => segments.push(Segment { time: begin..begin, value }),
            }
        }
        if let Some(last) = segments.last_mut() {
            last.time.end = self.extent().end.clamp(last.time.start, window.end);
        }
        segments
    }
}

fn unit_name(unit: TimescaleUnit) -> Option<&'static str> {
    match unit {
        TimescaleUnit::ZeptoSeconds => Some("zs"),
        TimescaleUnit::AttoSeconds => Some("as"),
        TimescaleUnit::FemtoSeconds => Some("fs"),
        TimescaleUnit::PicoSeconds => Some("ps"),
        TimescaleUnit::NanoSeconds => Some("ns"),
        TimescaleUnit::MicroSeconds => Some("us"),
        TimescaleUnit::MilliSeconds => Some("ms"),
        TimescaleUnit::Seconds => Some("s"),
        TimescaleUnit::Unknown => None,
    }
}

fn reader(path: &Path) -> io::Result<BufReader<File>> {
    let file = File::open(path)?;
    // A folder can be opened, and a pipe cannot be read twice.
    if file.metadata()?.is_file() { Ok(BufReader::new(file)) } else { Err(io::Error::other("it is not a regular file")) }
}

/// Reads from an open file and not from a path: that way wellen maps no memory that somebody else may cut off, and stays on this thread, where
/// it may print a warning though standard output is locked.
fn read(path: &Path, input: BufReader<File>) -> Result<Waves, WaveError> {
    let refused = |error| match error {
        WellenError::FailedToLoad(_, reason) => damaged(path, &reason),
        WellenError::UnknownFileFormat => WaveError::Kind { path: path.to_owned() },
        WellenError::Io(reason) => WaveError::Unreadable { path: path.to_owned(), reason },
    };
    let panicked = |said: String| damaged(path, &said);
    let header = guarded(|| viewers::read_header(input, &LoadOptions::default())).map_err(panicked)?.map_err(refused)?;
    let HeaderResult { hierarchy, body, .. } = header;
    if let Some(width) =
        hierarchy.all_vars().filter_map(|variable| hierarchy[variable].length(&hierarchy)).find(|&width| width > WIDEST)
    {
        return Err(damaged(path, &format!("a signal has {width} bits")));
    }
    let BodyResult { source, time_table } =
        guarded(|| viewers::read_body(body, &hierarchy, None)).map_err(panicked)?.map_err(refused)?;
    Ok(Waves { hierarchy, source, times: time_table, signals: HashMap::new() })
}

/// The error for what the reader says, which may be long and hold pieces of the file.
fn damaged(path: &Path, said: &str) -> WaveError {
    const LONGEST: usize = 120;
    // wellen's words for a header without an end.
    let said = if said.starts_with("I/O operation failed") { "it ends too early" } else { said };
    let line = clean(said.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or("it cannot be understood"));
    let reason = if line.chars().count() > LONGEST { line.chars().take(LONGEST).chain("...".chars()).collect() } else { line };
    WaveError::Damaged { path: path.to_owned(), reason }
}

fn variables(hierarchy: &Hierarchy) -> Vec<Variable> {
    let mut found = vec![];
    let items: Vec<ItemRef> = hierarchy.items().collect();
    // Not recursive: files say how deep scopes nest.
    let mut open: Vec<(ItemRef, Vec<String>)> = items.into_iter().rev().map(|item| (item, vec![])).collect();
    while let Some((item, scopes)) = open.pop() {
        match item {
            ItemRef::Var(variable) => found.push(variable_of(hierarchy, variable, scopes)),
            ItemRef::Scope(scope) => open.extend(inside(hierarchy, scope, &scopes)),
        }
    }
    found
}

/// What is in a scope, last first: variables, then inner scopes.
fn inside(hierarchy: &Hierarchy, scope: ScopeRef, outer: &[String]) -> Vec<(ItemRef, Vec<String>)> {
    let scope = &hierarchy[scope];
    let path: Vec<String> = outer.iter().cloned().chain([clean(scope.name(hierarchy))]).collect();
    let (variables, scopes): (Vec<_>, Vec<_>) = scope.items(hierarchy).partition(|item| matches!(item, ItemRef::Var(_)));
    variables.into_iter().chain(scopes).rev().map(|item| (item, path.clone())).collect()
}

fn variable_of(hierarchy: &Hierarchy, variable: VarRef, scopes: Vec<String>) -> Variable {
    let variable = &hierarchy[variable];
    let vector = variable.is_bit_vector(hierarchy) || variable.is_1bit(hierarchy);
    Variable {
        scopes,
        name: clean(variable.name(hierarchy)),
        width: variable.length(hierarchy).filter(|&width| vector && width > 0),
        port: matches!(variable.direction(), VarDirection::Input | VarDirection::Output | VarDirection::InOut),
        signal: variable.signal_ref(),
    }
}

fn value_of(value: SignalValueRef) -> Value {
    match value.to_bit_string() {
        Some(bits) => Value::Bits(bits),
        None => Value::Text(clean(&value.to_string())),
    }
}

/// Without control characters, which a terminal would obey and XML does not allow.
fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect()
}
