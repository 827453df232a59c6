//! A dump: the variables of a VCD or FST file, and the values they take.
use std::ops::Range;
use std::path::{Path, PathBuf};

use wellen::{Signal, SignalRef, SignalValueRef, TimescaleUnit};

use super::error::WaveError;
use super::guard::guarded;
use super::reader::{Waves, damaged};
use super::value::Value;
use super::variables::{Variable, clean, variables};

/// An opened dump.
pub struct Dump {
    path: PathBuf,
    waves: Waves,
    /// Every variable, in the order of the file.
    pub variables: Vec<Variable>,
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
        let waves = Waves::read(path)?;
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

fn value_of(value: SignalValueRef) -> Value {
    match value.to_bit_string() {
        Some(bits) => Value::Bits(bits),
        None => Value::Text(clean(&value.to_string())),
    }
}
