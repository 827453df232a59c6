//! What is drawn: rows of values over time. Text and pictures are made of this, and of nothing
//! else.
use std::ops::Range;

use super::segments::Segment;
use super::value::{Notation, Value};

/// A piece of a waveform, ready to be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// What it shows: file and window.
    pub title: String,
    /// What a reader should know besides, such as what was left out.
    pub notes: Vec<String>,
    /// Its time.
    pub axis: Axis,
    /// Its signals, those of a unit together.
    pub groups: Vec<Group>,
}

/// Time, in columns of equal length: clocks, or round numbers of the file's units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// What the columns' numbers count.
    pub unit: String,
    /// When the first column begins, in the file's units.
    pub begin: u64,
    /// How long a column takes.
    pub step: u64,
    /// Each column's number.
    pub numbers: Vec<u64>,
    /// The time to look at.
    pub marker: Option<Range<u64>>,
}

/// The signals of a unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The unit's full name.
    pub unit: String,
    /// Its signals.
    pub rows: Vec<Row>,
}

/// A signal.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its name in its unit.
    pub name: String,
    /// Whether it is drawn as levels or as values in cells.
    pub shape: Shape,
    /// Its values in order, no two equal ones side by side.
    pub segments: Vec<Segment>,
    /// The time whose value matters most.
    pub highlight: Option<Range<u64>>,
}

/// How a signal is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Shape {
    /// A bit: low or high.
    Levels,
    /// Marks at the times at which something happens.
    Events,
    /// Values.
    Cells {
        /// How they are written.
        notation: Notation,
        /// The format, to stand beside the name.
        format: String,
    },
}

impl Axis {
    /// From the begin of the first column to the end of the last.
    pub fn window(&self) -> Range<u64> {
        self.begin..self.time(self.numbers.len() as u64)
    }

    /// Where a time stands, in columns.
    pub fn place(&self, time: u64) -> f64 {
        // The difference first: a time in femtoseconds may need more digits than a number has.
        let distance =
            time.saturating_sub(self.begin) as f64 - self.begin.saturating_sub(time) as f64;
        distance / self.step as f64
    }

    /// When the column ends in which a time lies; it has to lie behind the begin.
    pub fn column_end(&self, time: u64) -> u64 {
        self.time(time.saturating_sub(self.begin) / self.step + 1)
    }

    /// When a column begins.
    fn time(&self, column: u64) -> u64 {
        self.begin.saturating_add(column.saturating_mul(self.step))
    }
}

impl Figure {
    /// Every row.
    pub fn rows(&self) -> impl Iterator<Item = &Row> {
        self.groups.iter().flat_map(|group| &group.rows)
    }

    /// The number of characters that a column needs for the longest value if none may have more
    /// than `most`, and none that can be rounded more than `rounded`. A value that lasts several
    /// columns has the room of all.
    pub fn longest_value(&self, rounded: usize, most: usize) -> usize {
        let columns = |segment: &Segment| {
            self.axis.place(segment.time.end) - self.axis.place(segment.time.start)
        };
        let share = |length: usize, columns: f64| {
            ((length as f64 + 1.0) / columns.max(1.0)).ceil() as usize - 1
        };
        let wish = |row: &Row, segment: &Segment| {
            share(row.wish(&segment.value, rounded, most), columns(segment))
        };
        self.rows()
            .flat_map(|row| row.segments.iter().map(move |segment| wish(row, segment)))
            .max()
            .unwrap_or(0)
    }
}

impl Row {
    /// A value in `room` characters; none for bits and events, or if it does not fit.
    pub fn written(&self, value: &Value, room: usize) -> Option<String> {
        match &self.shape {
            Shape::Levels | Shape::Events => None,
            Shape::Cells { notation, .. } => notation.written(value, room),
        }
    }

    fn wish(&self, value: &Value, rounded: usize, most: usize) -> usize {
        match &self.shape {
            Shape::Levels | Shape::Events => 0,
            Shape::Cells { notation, .. } => notation.wish(value, rounded, most),
        }
    }

    /// The format of its values; empty for a bit.
    pub fn format(&self) -> &str {
        match &self.shape {
            Shape::Levels | Shape::Events => "",
            Shape::Cells { format, .. } => format,
        }
    }
}
