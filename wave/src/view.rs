//! A dump with its save file and time axis, and windows of it as figures.
use std::ops::{Range, RangeInclusive};
use std::path::Path;

use super::dump::{Dump, MAX_VALUES, file_name};
use super::error::WaveError;
use super::figure::{Axis, Figure, Group, Shape, SignalRow};
use super::save_file::SaveFile;
use super::segments::Segment;
use super::selection::{Chosen, ChosenSignals, Selection, by_name};
use super::survey::around_middle;
use super::time_axis::TimeAxis;
use super::value::Value;
use super::variables::{Kind, Variable};
use super::warnings::Warnings;

/// A dump, its save file and its time axis.
pub struct DumpView {
    dump: Dump,
    save_file: Option<SaveFile>,
    time_axis: TimeAxis,
    warnings: Vec<String>,
}

/// The window that a user asks for, in clocks or in the file's units; both ends are included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WindowRequest {
    /// Its begin.
    pub from: Option<u64>,
    /// Its end.
    pub to: Option<u64>,
    /// Number of columns that are drawn of a longer file if the user gives no window.
    pub default_columns: u64,
}

impl WindowRequest {
    /// The window as the user asked for it.
    fn described(&self) -> String {
        let ends = [("--from", self.from), ("--to", self.to)];
        let ends = ends
            .iter()
            .filter_map(|(name, number)| number.map(|number| format!("{name} {number}")));
        ends.collect::<Vec<_>>().join(" ")
    }
}

/// Number of columns where time is in the file's units.
const COLUMNS: u64 = 12;

impl DumpView {
    /// Opens a dump and the save file that belongs to it, if there is one.
    ///
    /// # Errors
    /// [`WaveError`] if the dump cannot be used.
    pub fn open(path: &Path) -> Result<DumpView, WaveError> {
        let mut warnings = Warnings::default();
        let save_file = SaveFile::of_dump(path, &mut warnings);
        let marker = save_file.as_ref().and_then(|save_file| save_file.marker);
        let dump = Dump::open(path, marker, &mut warnings)?;
        let time_axis = TimeAxis::of_dump(&dump);
        Ok(DumpView { dump, save_file, time_axis, warnings: warnings.lines(&file_name(path)) })
    }

    /// What was skipped in the file, a line for each kind of thing.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Selects signals.
    ///
    /// # Errors
    /// [`WaveError`] if nothing is selected.
    pub fn choose(&self, selection: &Selection) -> Result<ChosenSignals, WaveError> {
        selection.choose(&self.dump, self.save_file.as_ref())
    }

    /// Finds signals by their full names, each with the clock, or time, whose value matters most.
    /// Names that the dump does not have are left out.
    pub fn signals_by_name(&self, names: &[(String, u64)]) -> ChosenSignals {
        by_name(&self.dump, self.save_file.as_ref(), names)
    }

    /// Makes the figure of some signals in a window.
    ///
    /// # Errors
    /// [`WaveError`] if the window holds nothing or far too much, or the values are damaged.
    pub fn figure(
        &mut self,
        choice: &ChosenSignals,
        asked: &WindowRequest,
    ) -> Result<Figure, WaveError> {
        let window = self.window(asked)?;
        self.check_length(&window, choice.signals.len())?;
        let idle = self.ends_idle(&window, asked);
        let axis = self.axis(&window, idle);
        let last = *self.dump.time_range().end();
        // The last instant takes a column.
        let until = if idle { last } else { axis.column_end(last) };
        let variables: Vec<usize> = choice.signals.iter().map(|signal| signal.variable).collect();
        let segments = self.dump.segments(&variables, &axis.window(), until)?;
        let groups = self.groups(&choice.signals, segments);
        Ok(Figure { title: self.title(&window), notes: self.notes(choice, &window), axis, groups })
    }

    /// Refuses more columns than would be of use. The number of values is checked when they are
    /// read.
    fn check_length(&self, window: &RangeInclusive<u64>, signals: usize) -> Result<(), WaveError> {
        let clocks = match self.time_axis {
            TimeAxis::Clocks { .. } => (window.end() - window.start()).saturating_add(1),
            TimeAxis::Time => 0,
        };
        let large = clocks.saturating_mul(signals as u64) > MAX_VALUES as u64;
        if large {
            Err(WaveError::Large { signals, amount: format!("{clocks} clocks") })
        } else {
            Ok(())
        }
    }

    /// Whether the window ends with the last time of the file, at which nothing changes any more,
    /// although the user did not ask for that time.
    fn ends_idle(&self, window: &RangeInclusive<u64>, asked: &WindowRequest) -> bool {
        let idle = !self.dump.survey().changes_at_last();
        match self.time_axis {
            TimeAxis::Clocks { .. } => idle,
            TimeAxis::Time => {
                let whole = asked.to.is_none() && window.end() == self.dump.time_range().end();
                idle && whole && window.start() < window.end()
            }
        }
    }

    /// The signals, grouped where signals of one unit follow each other.
    fn groups(&self, signals: &[Chosen], segments: Vec<Vec<Segment>>) -> Vec<Group> {
        let scope = |signal: &Chosen| self.dump.variables()[signal.variable].scope;
        let mut segments = segments.into_iter();
        let mut row = |signal: &Chosen| self.row(signal, segments.next().unwrap_or_default());
        let groups = signals.chunk_by(|one, next| scope(one) == scope(next));
        let unit = |signals: &[Chosen]| self.dump.scopes().path(scope(&signals[0]));
        groups
            .map(|signals| Group {
                unit: unit(signals),
                rows: signals.iter().map(&mut row).collect(),
            })
            .collect()
    }

    /// The window to draw, in the time axis's numbers.
    fn window(&self, asked: &WindowRequest) -> Result<RangeInclusive<u64>, WaveError> {
        let extent = self.time_axis.numbers(&self.dump);
        let (first, last) = (*extent.start(), *extent.end());
        let usual = self.default_window(asked.default_columns);
        let length = usual.end() - usual.start();
        let from = asked.from.unwrap_or(match asked.to {
            Some(to) => (*usual.start()).min(to.saturating_sub(length)).max(first),
            None => *usual.start(),
        });
        let to = asked.to.unwrap_or(if asked.from.is_some() {
            from.saturating_add(length).min(last)
        } else {
            *usual.end()
        });
        if from > to || from > last || to < first {
            return Err(WaveError::Window {
                asked: asked.described(),
                there: self.time_axis.described(&extent, &self.dump),
            });
        }
        Ok(from.max(first)..=to.min(last))
    }

    /// The whole of a short file; else a window around the marker or at the beginning.
    fn default_window(&self, columns: u64) -> RangeInclusive<u64> {
        let extent = self.time_axis.numbers(&self.dump);
        match self.time_axis {
            TimeAxis::Clocks { .. } => around_middle(
                &extent,
                self.marker().map(|time| self.time_axis.number(time)),
                columns,
            ),
            // It covers as many instants as there would be clocks.
            TimeAxis::Time => self.dump.survey().default_range(columns),
        }
    }

    fn marker(&self) -> Option<u64> {
        self.dump.survey().marker()
    }

    fn axis(&self, window: &RangeInclusive<u64>, idle: bool) -> Axis {
        let (first, last) = (*window.start(), *window.end());
        let marker = self.marker();
        let unit = self.time_axis.unit(&self.dump);
        match self.time_axis {
            TimeAxis::Clocks { period, .. } => Axis {
                unit,
                begin: self.time_axis.time(first),
                step: period,
                numbers: (first..=last).collect(),
                marker: marker.map(|time| self.clock(self.time_axis.number(time))),
            },
            TimeAxis::Time => {
                let step = round_step((last - first) / COLUMNS);
                let begin = first - first % step;
                let end = if idle { last - 1 } else { last };
                let numbers =
                    (begin..=end).step_by(usize::try_from(step).unwrap_or(usize::MAX)).collect();
                Axis { unit, begin, step, numbers, marker: marker.map(|time| time..time) }
            }
        }
    }

    /// The time that a number of the time axis takes.
    fn clock(&self, number: u64) -> Range<u64> {
        self.time_axis.time(number)..self.time_axis.time(number.saturating_add(1))
    }

    fn row(&self, signal: &Chosen, segments: Vec<Segment>) -> SignalRow {
        let variable = &self.dump.variables()[signal.variable];
        let shape = shape(variable, signal, &segments);
        SignalRow {
            name: variable.name.clone(),
            shape,
            segments,
            highlight: signal.highlight.map(|number| self.clock(number)),
        }
    }

    fn title(&self, window: &RangeInclusive<u64>) -> String {
        format!("{}, {}", self.dump.file_name(), self.time_axis.described(window, &self.dump))
    }

    fn notes(&self, choice: &ChosenSignals, window: &RangeInclusive<u64>) -> Vec<String> {
        let extent = self.time_axis.numbers(&self.dump);
        let more =
            |number| format!("{number} more signals are left out: choose with --signals or --unit");
        let longer = || {
            format!(
                "the file has {}: choose with --from and --to",
                self.time_axis.described(&extent, &self.dump)
            )
        };
        let more = (choice.left_out > 0).then(|| more(choice.left_out));
        more.into_iter().chain((extent != *window).then(longer)).collect()
    }
}

fn shape(variable: &Variable, signal: &Chosen, segments: &[Segment]) -> Shape {
    match (variable.kind, variable.width) {
        (Kind::Event, _) => Shape::Events,
        // Some tools write text for a variable that they declare as a bit.
        (_, Some(1)) if segments.iter().all(|segment| segment.value.is_bit()) => Shape::Levels,
        (_, width) => {
            // Real numbers and text have no format.
            let bits = segments.is_empty()
                || segments.iter().any(|segment| matches!(segment.value, Value::Bits(_)));
            let format = width
                .filter(|_| bits)
                .map(|width| signal.notation.label(width))
                .unwrap_or_default();
            Shape::Cells { notation: signal.notation, format }
        }
    }
}

/// The smallest number of the form 1, 2 or 5 times a power of ten that is at least `least`.
fn round_step(least: u64) -> u64 {
    let powers = (0..19).map(|power| 10u64.pow(power));
    let steps = powers.flat_map(|power| [1, 2, 5].map(|digit| digit * power));
    steps.into_iter().find(|&step| step >= least).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_round() {
        assert_eq!([0, 1, 2, 3, 6, 11, 4000].map(round_step), [1, 1, 2, 5, 10, 20, 5000]);
        assert_eq!(round_step(u64::MAX), u64::MAX);
    }
}
