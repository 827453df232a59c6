//! The data of a drawing: rows of values over time. Text and pictures are made from it alone.
use std::ops::Range;

use super::segments::Segment;
use super::value::{Notation, Value};

/// A part of a waveform, ready to be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// What it shows: file and window.
    pub title: String,
    /// What a reader should also know, such as what was left out.
    pub notes: Vec<String>,
    /// The time axis.
    pub axis: Axis,
    /// The signals, grouped by unit.
    pub groups: Vec<Group>,
}

/// Marks a value that does not fit, and what is left out of a text.
pub const CUT: char = '\u{2026}';
/// Fewest characters in which the beginning of a text is worth showing.
const SHORTEST_CUT: usize = 4;

/// The time axis, divided into columns of equal length: clocks, or round numbers of the file's
/// units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// What the columns' numbers count.
    pub unit: String,
    /// Time at which the first column begins, in the file's units.
    pub begin: u64,
    /// Duration of a column, in the file's units.
    pub step: u64,
    /// Each column's number.
    pub numbers: Vec<u64>,
    /// The marked time.
    pub marker: Option<Range<u64>>,
}

/// The signals of a unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The unit's full name.
    pub unit: String,
    /// Its signals.
    pub rows: Vec<SignalRow>,
}

/// A signal's row.
#[derive(Clone, Debug, PartialEq)]
pub struct SignalRow {
    /// Its name in its unit.
    pub name: String,
    /// Whether it is drawn as levels or as values in cells.
    pub shape: Shape,
    /// The values in order; no two neighbours are equal.
    pub segments: Vec<Segment>,
    /// The time whose value matters most.
    pub highlight: Option<Range<u64>>,
}

/// The way in which a signal is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A bit: low or high.
    Levels,
    /// Marks at the times of events.
    Events,
    /// Cells with values in them.
    Cells {
        /// The notation of the values.
        notation: Notation,
        /// The format, as it is written next to the name.
        format: String,
    },
}

impl Axis {
    /// The time from the beginning of the first column to the end of the last.
    pub fn window(&self) -> Range<u64> {
        self.begin..self.time(self.numbers.len() as u64)
    }

    /// The position of a time on the axis, in columns.
    pub fn place(&self, time: u64) -> f64 {
        // The difference is taken in integers: a time in femtoseconds may need more digits than an
        // f64 has.
        let distance =
            time.saturating_sub(self.begin) as f64 - self.begin.saturating_sub(time) as f64;
        distance / self.step as f64
    }

    /// The end of the column in which a time lies; the time must not lie before the first column.
    pub fn column_end(&self, time: u64) -> u64 {
        self.time(time.saturating_sub(self.begin) / self.step + 1)
    }

    /// The time at which a column begins.
    fn time(&self, column: u64) -> u64 {
        self.begin.saturating_add(column.saturating_mul(self.step))
    }
}

impl Figure {
    /// Every row.
    pub fn rows(&self) -> impl Iterator<Item = &SignalRow> {
        self.groups.iter().flat_map(|group| &group.rows)
    }

    /// The number of characters that a column needs for the longest value, at most `most`; values
    /// that can be rounded get at most `rounded`. A value that lasts several columns may use the
    /// room of all of them.
    pub fn longest_value(&self, rounded: usize, most: usize) -> usize {
        let columns = |segment: &Segment| {
            self.axis.place(segment.time.end) - self.axis.place(segment.time.start)
        };
        let share =
            |length: usize, columns: f64| ((length as f64 + 1.0) / columns).ceil() as usize - 1;
        let wish = |row: &SignalRow, segment: &Segment| {
            let columns = columns(segment).max(1.0);
            let room = ((most as f64 + 1.0) * columns) as usize - 1;
            share(row.preferred_width(&segment.value, rounded, room), columns)
        };
        self.rows()
            .flat_map(|row| row.segments.iter().map(move |segment| wish(row, segment)))
            .max()
            .unwrap_or(0)
    }
}

impl SignalRow {
    /// The value in `room` characters; `None` for bits and events, and if it does not fit.
    pub fn written(&self, value: &Value, room: usize) -> Option<String> {
        match &self.shape {
            Shape::Levels | Shape::Events => None,
            Shape::Cells { notation, .. } => notation.written(value, room),
        }
    }

    /// The value as [`SignalRow::written`] gives it, or the beginning of a text that does not fit.
    pub fn written_or_begun(&self, value: &Value, room: usize) -> Option<String> {
        self.written(value, room).or_else(|| match (&self.shape, value) {
            (Shape::Cells { .. }, Value::Text(text)) if room >= SHORTEST_CUT => {
                Some(text.chars().take(room - 1).chain([CUT]).collect())
            }
            _ => None,
        })
    }

    fn preferred_width(&self, value: &Value, rounded: usize, most: usize) -> usize {
        match &self.shape {
            Shape::Levels | Shape::Events => 0,
            Shape::Cells { notation, .. } => notation.preferred_width(value, rounded, most),
        }
    }

    /// The format of the values; empty for a bit.
    pub fn format(&self) -> &str {
        match &self.shape {
            Shape::Levels | Shape::Events => "",
            Shape::Cells { format, .. } => format,
        }
    }
}
