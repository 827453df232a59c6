//! A dump with what belongs to it, looked at through a window.
use std::ops::{Range, RangeInclusive};
use std::path::Path;

use super::dump::{Dump, MOST_VALUES, file_name};
use super::error::WaveError;
use super::figure::{Axis, Figure, Group, Row, Shape};
use super::save_file::SaveFile;
use super::segments::Segment;
use super::selection::{Choice, Chosen, Selection, named};
use super::survey::around_middle;
use super::time_axis::TimeAxis;
use super::value::Value;
use super::variables::{Kind, Variable};
use super::warnings::Warnings;

/// A dump, its save file and its time_axis.
pub struct View {
    dump: Dump,
    save_file: Option<SaveFile>,
    time_axis: TimeAxis,
    warnings: Vec<String>,
}

/// The window that somebody asks for, in clocks or in the file's units; both ends belong to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asked {
    /// Its begin.
    pub from: Option<u64>,
    /// Its end.
    pub to: Option<u64>,
    /// How many columns are drawn of a longer file where nobody says.
    pub usual: u64,
}

impl Asked {
    /// As it was asked for.
    fn described(&self) -> String {
        let ends = [("--from", self.from), ("--to", self.to)];
        let ends = ends
            .iter()
            .filter_map(|(name, number)| number.map(|number| format!("{name} {number}")));
        ends.collect::<Vec<_>>().join(" ")
    }
}

/// Columns, where time is in the file's units.
const COLUMNS: u64 = 12;

impl View {
    /// Opens a dump, and the save file beside it if there is one.
    ///
    /// # Errors
    /// [`WaveError`] if the dump cannot be used.
    pub fn open(path: &Path) -> Result<View, WaveError> {
        let mut warnings = Warnings::default();
        let save_file = SaveFile::beside(path, &mut warnings);
        let marker = save_file.as_ref().and_then(|save_file| save_file.marker);
        let dump = Dump::open(path, marker, &mut warnings)?;
        let time_axis = TimeAxis::of(&dump);
        Ok(View { dump, save_file, time_axis, warnings: warnings.lines(&file_name(path)) })
    }

    /// What was passed over in the file, a line for each kind of thing.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The signals that are meant.
    ///
    /// # Errors
    /// [`WaveError`] if there are none.
    pub fn choose(&self, selection: &Selection) -> Result<Choice, WaveError> {
        selection.choose(&self.dump, self.save_file.as_ref())
    }

    /// Signals by their full names, each with the clock, or time, whose value matters most; those
    /// that the dump does not hold are left out.
    pub fn named(&self, names: &[(String, u64)]) -> Choice {
        named(&self.dump, self.save_file.as_ref(), names)
    }

    /// What is to be drawn.
    ///
    /// # Errors
    /// [`WaveError`] if the window holds nothing or far too much, or the values are damaged.
    pub fn figure(&mut self, choice: &Choice, asked: &Asked) -> Result<Figure, WaveError> {
        let window = self.window(asked)?;
        self.check_length(&window, choice.signals.len())?;
        let idle = self.ends_idle(&window, asked);
        let axis = self.axis(&window, idle);
        let last = *self.dump.extent().end();
        // The last instant lasts a column.
        let until = if idle { last } else { axis.column_end(last) };
        let variables: Vec<usize> = choice.signals.iter().map(|signal| signal.variable).collect();
        let segments = self.dump.segments(&variables, &axis.window(), until)?;
        let groups = self.groups(&choice.signals, segments);
        Ok(Figure { title: self.title(&window), notes: self.notes(choice, &window), axis, groups })
    }

    /// Refuses more columns than are of use to anybody. How many values there are shows when they
    /// are read.
    fn check_length(&self, window: &RangeInclusive<u64>, signals: usize) -> Result<(), WaveError> {
        let clocks = match self.time_axis {
            TimeAxis::Clocks { .. } => (window.end() - window.start()).saturating_add(1),
            TimeAxis::Time => 0,
        };
        let large = clocks.saturating_mul(signals as u64) > MOST_VALUES as u64;
        if large {
            Err(WaveError::Large { signals, amount: format!("{clocks} clocks") })
        } else {
            Ok(())
        }
    }

    /// Whether the window ends with the file, which ends with a time at which nothing changes any
    /// more, and that nobody asked for.
    fn ends_idle(&self, window: &RangeInclusive<u64>, asked: &Asked) -> bool {
        let idle = !self.dump.survey().changes_at_last();
        match self.time_axis {
            TimeAxis::Clocks { .. } => idle,
            TimeAxis::Time => {
                let whole = asked.to.is_none() && window.end() == self.dump.extent().end();
                idle && whole && window.start() < window.end()
            }
        }
    }

    /// The signals, those of a unit together where they follow each other.
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

    /// What is drawn, in the time axis's numbers.
    fn window(&self, asked: &Asked) -> Result<RangeInclusive<u64>, WaveError> {
        let extent = self.time_axis.extent(&self.dump);
        let (first, last) = (*extent.start(), *extent.end());
        let usual = self.usual_window(asked.usual);
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

    /// The whole of a short file, else what is around the marker or at the begin.
    fn usual_window(&self, columns: u64) -> RangeInclusive<u64> {
        let extent = self.time_axis.extent(&self.dump);
        match self.time_axis {
            TimeAxis::Clocks { .. } => {
                around_middle(&extent, self.marker().map(|time| self.time_axis.at(time)), columns)
            }
            // As many instants at which something happens as there would be clocks.
            TimeAxis::Time => self.dump.survey().usual(columns),
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
                marker: marker.map(|time| self.clock(self.time_axis.at(time))),
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

    fn row(&self, signal: &Chosen, segments: Vec<Segment>) -> Row {
        let variable = &self.dump.variables()[signal.variable];
        let shape = shape(variable, signal, &segments);
        Row {
            name: variable.name.clone(),
            shape,
            segments,
            highlight: signal.highlight.map(|number| self.clock(number)),
        }
    }

    fn title(&self, window: &RangeInclusive<u64>) -> String {
        format!("{}, {}", self.dump.file_name(), self.time_axis.described(window, &self.dump))
    }

    fn notes(&self, choice: &Choice, window: &RangeInclusive<u64>) -> Vec<String> {
        let extent = self.time_axis.extent(&self.dump);
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
        // Some tools write text where they declare a bit.
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

/// The next 1, 2 or 5 times a power of ten that is not below `least`.
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
