//! A dump with what belongs to it, looked at through a window.
use std::ops::{Range, RangeInclusive};
use std::path::Path;

use super::dump::Dump;
use super::error::WaveError;
use super::figure::{Axis, Figure, Group, Row, Shape};
use super::ruler::Ruler;
use super::save_file::SaveFile;
use super::selection::{Choice, Chosen, Selection, named};
use super::variables::Variable;

/// A dump, its save file and its ruler.
pub struct View {
    dump: Dump,
    save_file: Option<SaveFile>,
    ruler: Ruler,
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
        let ends = ends.iter().filter_map(|(name, number)| number.map(|number| format!("{name} {number}")));
        ends.collect::<Vec<_>>().join(" ")
    }
}

/// Values in a figure, at most: more of them are of no use to anybody.
const MOST_VALUES: u64 = 200_000;
/// Columns, where time is in the file's units.
const COLUMNS: u64 = 12;

impl View {
    /// Opens a dump, and the save file beside it if there is one.
    ///
    /// # Errors
    /// [`WaveError`] if one of them cannot be used.
    pub fn open(path: &Path) -> Result<View, WaveError> {
        let mut dump = Dump::open(path)?;
        let ruler = Ruler::of(&mut dump)?;
        Ok(View { dump, save_file: SaveFile::beside(path)?, ruler })
    }

    /// The signals that are meant.
    ///
    /// # Errors
    /// [`WaveError`] if there are none.
    pub fn choose(&self, selection: &Selection) -> Result<Choice, WaveError> {
        selection.choose(&self.dump, self.save_file.as_ref())
    }

    /// Signals by their full names, each with the clock, or time, whose value matters most; those that the dump does not hold are left out.
    pub fn named(&self, names: &[(String, u64)]) -> Choice {
        named(&self.dump, self.save_file.as_ref(), names)
    }

    /// What is to be drawn.
    ///
    /// # Errors
    /// [`WaveError`] if the window holds nothing or far too much, or the values are damaged.
    pub fn figure(&mut self, choice: &Choice, asked: &Asked) -> Result<Figure, WaveError> {
        let window = self.window(asked)?;
        let length = self.length(&window);
        if length.saturating_mul(choice.signals.len() as u64) > MOST_VALUES {
            return Err(WaveError::Large { signals: choice.signals.len(), length });
        }
        let axis = self.axis(&window);
        self.dump.load(&choice.signals.iter().map(|signal| signal.variable).collect::<Vec<_>>())?;
        let groups = self.groups(&choice.signals, &axis)?;
        Ok(Figure { title: self.title(&window), notes: self.notes(choice, &window), axis, groups })
    }

    /// The columns of the window, or the instants at which something happens in it, whichever are more: no row has more values.
    fn length(&self, window: &RangeInclusive<u64>) -> u64 {
        let times = self.dump.times();
        let before = |end: u64| times.partition_point(|&time| time < end) as u64;
        let instants = before(self.ruler.time(window.end().saturating_add(1))) - before(self.ruler.time(*window.start()));
        match self.ruler {
            Ruler::Clocks { .. } => instants.max((window.end() - window.start()).saturating_add(1)),
            Ruler::Time => instants,
        }
    }

    /// The signals, those of a unit together where they follow each other.
    fn groups(&self, signals: &[Chosen], axis: &Axis) -> Result<Vec<Group>, WaveError> {
        let unit = |signal: &Chosen| self.dump.variables[signal.variable].unit();
        let groups = signals.chunk_by(|one, next| unit(one) == unit(next));
        let rows = |signals: &[Chosen]| signals.iter().map(|signal| self.row(signal, axis)).collect::<Result<_, _>>();
        groups.map(|signals| Ok(Group { unit: unit(&signals[0]), rows: rows(signals)? })).collect()
    }

    /// What is drawn, in the ruler's numbers.
    fn window(&self, asked: &Asked) -> Result<RangeInclusive<u64>, WaveError> {
        let extent = self.ruler.extent(&self.dump);
        let (first, last) = (*extent.start(), *extent.end());
        let usual = self.usual_window(asked.usual);
        let length = usual.end() - usual.start();
        let from = asked.from.unwrap_or(match asked.to {
            Some(to) => (*usual.start()).min(to.saturating_sub(length)).max(first),
            None => *usual.start(),
        });
        let to = asked.to.unwrap_or(if asked.from.is_some() { from.saturating_add(length).min(last) } else { *usual.end() });
        if from > to || from > last || to < first {
            return Err(WaveError::Window { asked: asked.described(), there: self.ruler.described(&extent, &self.dump) });
        }
        Ok(from.max(first)..=to.min(last))
    }

    /// The whole of a short file, else what is around the marker or at the begin.
    fn usual_window(&self, columns: u64) -> RangeInclusive<u64> {
        let extent = self.ruler.extent(&self.dump);
        match self.ruler {
            Ruler::Clocks { .. } => around(&extent, self.marker().map(|time| self.ruler.at(time)), columns),
            Ruler::Time => {
                // As many instants at which something happens as there would be clocks.
                let times = self.dump.times();
                let last = times.len() as u64 - 1;
                let middle = self.marker().map(|marker| times.partition_point(|&time| time < marker) as u64);
                let shown = around(&(0..=last), middle, columns);
                times[*shown.start() as usize]..=times[*shown.end() as usize]
            }
        }
    }

    fn marker(&self) -> Option<u64> {
        let extent = self.dump.extent();
        self.save_file.as_ref()?.marker.filter(|time| (extent.start..=extent.end).contains(time))
    }

    fn axis(&self, window: &RangeInclusive<u64>) -> Axis {
        let (first, last) = (*window.start(), *window.end());
        let marker = self.marker();
        let unit = self.ruler.unit(&self.dump);
        match self.ruler {
            Ruler::Clocks { period, .. } => Axis {
                unit,
                begin: self.ruler.time(first),
                step: period,
                numbers: (first..=last).collect(),
                marker: marker.map(|time| self.clock(self.ruler.at(time))),
            },
            Ruler::Time => {
                let step = round_step((last - first) / COLUMNS);
                let begin = first - first % step;
                let numbers = (begin..=last.max(begin + 1) - 1).step_by(usize::try_from(step).unwrap_or(usize::MAX)).collect();
                Axis { unit, begin, step, numbers, marker: marker.map(|time| time..time) }
            }
        }
    }

    /// The time that a number of the ruler takes.
    fn clock(&self, number: u64) -> Range<u64> {
        self.ruler.time(number)..self.ruler.time(number.saturating_add(1))
    }

    fn row(&self, signal: &Chosen, axis: &Axis) -> Result<Row, WaveError> {
        let variable = &self.dump.variables[signal.variable];
        Ok(Row {
            name: variable.name.clone(),
            shape: shape(variable, signal),
            segments: self.dump.segments(signal.variable, &axis.window())?,
            highlight: signal.highlight.map(|number| self.clock(number)),
        })
    }

    fn title(&self, window: &RangeInclusive<u64>) -> String {
        format!("{}, {}", self.dump.file_name(), self.ruler.described(window, &self.dump))
    }

    fn notes(&self, choice: &Choice, window: &RangeInclusive<u64>) -> Vec<String> {
        let extent = self.ruler.extent(&self.dump);
        let more = |number| format!("{number} more signals are left out: choose with --signals or --unit");
        let longer = || format!("the file has {}: choose with --from and --to", self.ruler.described(&extent, &self.dump));
        let more = (choice.left_out > 0).then(|| more(choice.left_out));
        more.into_iter().chain((extent != *window).then(longer)).collect()
    }
}

fn shape(variable: &Variable, signal: &Chosen) -> Shape {
    match variable.width {
        Some(1) => Shape::Levels,
        width => {
            Shape::Cells { notation: signal.notation, format: width.map(|width| signal.notation.label(width)).unwrap_or_default() }
        }
    }
}

/// `length` numbers around `middle`, or from the begin, that are within `extent`.
fn around(extent: &RangeInclusive<u64>, middle: Option<u64>, length: u64) -> RangeInclusive<u64> {
    let (first, last) = (*extent.start(), *extent.end());
    let latest = last.saturating_sub(length.max(1) - 1).max(first);
    let begin = middle.map_or(first, |middle| middle.saturating_sub(length / 2)).clamp(first, latest);
    begin..=begin.saturating_add(length.max(1) - 1).min(last)
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
    fn a_window_lies_around_its_middle_and_within_the_file() {
        assert_eq!(around(&(0..=99), Some(50), 10), 45..=54);
        assert_eq!(around(&(0..=99), Some(98), 10), 90..=99);
        assert_eq!(around(&(0..=99), None, 10), 0..=9);
        assert_eq!(around(&(40..=45), Some(43), 10), 40..=45);
        assert_eq!(around(&(40..=45), Some(43), 0), 43..=43);
    }

    #[test]
    fn steps_are_round() {
        assert_eq!([0, 1, 2, 3, 6, 11, 4000].map(round_step), [1, 1, 2, 5, 10, 20, 5000]);
        assert_eq!(round_step(u64::MAX), u64::MAX);
    }
}
