//! Draws a figure as text: a row for each signal, values behind bars, bits as lines.
use std::fmt::Write;
use std::iter;
use std::ops::Range;

use super::figure::{Axis, CUT, Figure, Shape, SignalRow};
use super::segments::Segment;
use super::value::Value;

/// Longest value for which columns are widened, if wider ones would need several panels: 64 bits in
/// hexadecimal.
const LONGEST_VALUE: usize = 16;
/// Longest such value among numbers that can be rounded.
const LONGEST_ROUNDED: usize = 9;
/// Least number of characters of a column: a bar and room for a short number.
const NARROWEST: usize = 5;
/// Number of characters of a name that are shown however short the line is.
const SHORTEST_NAME: usize = 6;
/// Blanks before a signal's name, which stands below its unit's.
const INDENT: usize = 2;

/// The bar between two values.
const BAR: char = '\u{2502}';
/// Marks a place where a value changes more often than characters can show.
const CROWDED: char = '\u{2573}';
const LOW: char = '_';
const HIGH: char = '\u{2594}';
const FLOATING: char = '\u{2500}';
/// Marks an event.
const EVENT: char = '\u{2191}';
const MARKER: char = '\u{25bc}';

/// The division of a line.
struct Page {
    /// Number of characters for names and formats.
    names: usize,
    /// Number of characters of a column.
    column: usize,
    /// Number of columns that stand next to each other.
    columns: usize,
}

impl Page {
    fn new(figure: &Figure, width: usize) -> Page {
        let names = names(figure, width);
        let room = width.saturating_sub(names + 1).max(NARROWEST);
        let number = figure.axis.numbers.last().map_or(0, |number| number.to_string().len());
        let all = figure.axis.numbers.len().max(1);
        // A short window has room for values of any length.
        let beside = (room / all).saturating_sub(1);
        let longest = |rounded: usize, most: usize| {
            figure.longest_value(rounded.max(beside), most.max(beside))
        };
        let wanted = (longest(LONGEST_ROUNDED, LONGEST_VALUE).max(number) + 1).max(NARROWEST);
        // Values that are shorter by a few decimals are better than a second panel, if they do not
        // become too short.
        let least =
            (figure.longest_value(NARROWEST + 1, LONGEST_VALUE) + 1).max(NARROWEST + 2).min(wanted);
        let column = (room / all).clamp(least, wanted).min(room);
        Page { names, column, columns: (room / column).clamp(1, all) }
    }
}

/// Number of characters for names and formats: at most half of the line, unless names would be cut
/// too short.
fn names(figure: &Figure, width: usize) -> usize {
    let widest = |longest: usize| {
        let label = |row: &SignalRow| {
            INDENT + row.name.chars().count().min(longest) + 1 + row.format().chars().count() + 1
        };
        figure.rows().map(label).max().unwrap_or(0)
    };
    let names = widest(usize::MAX).min(widest(SHORTEST_NAME).max(width / 2));
    // The unit of time stands above the names.
    names.max(figure.axis.unit.chars().count())
}

/// The figure as lines of `width` characters, in as many panels below each other as are needed.
pub fn text(figure: &Figure, width: usize) -> String {
    let page = Page::new(figure, width);
    let mut text = format!("{}\n", figure.title);
    let all = figure.axis.numbers.len();
    for first in (0..all.max(1)).step_by(page.columns) {
        text.push('\n');
        panel(&mut text, figure, &page, &(first..all.min(first + page.columns)));
    }
    for note in &figure.notes {
        text.push_str(&format!("\n({note})\n"));
    }
    text
}

/// The number of the figure's columns that fit next to each other in `width` characters.
pub fn columns_beside(figure: &Figure, width: usize) -> u64 {
    Page::new(figure, width).columns as u64
}

/// The number of columns that fit next to each other in `width` characters if all are as narrow as
/// possible.
pub fn most_columns(width: usize) -> u64 {
    (width / NARROWEST) as u64
}

fn panel(text: &mut String, figure: &Figure, page: &Page, columns: &Range<usize>) {
    let heading = format!(
        "{:width$}{}",
        figure.axis.unit,
        numbers(&figure.axis, page, columns),
        width = page.names
    );
    push_line(text, &heading);
    for group in &figure.groups {
        // A dump may have no scopes.
        if !group.unit.is_empty() {
            push_line(text, &group.unit);
        }
        for row in &group.rows {
            let space = page.names - INDENT - 1 - row.format().chars().count();
            // A blank precedes the format.
            let name = end_of(&row.name, space - usize::from(!row.format().is_empty()));
            let name = format!("{:INDENT$}{name:space$}{} ", "", row.format());
            push_line(text, &(name + &wave(row, figure, page, columns)));
        }
    }
}

fn push_line(text: &mut String, line: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", line.trim_end());
}

/// Writes as many of the columns' numbers as there is room for; the marker stands before its own
/// number.
fn numbers(axis: &Axis, page: &Page, columns: &Range<usize>) -> String {
    let widest = axis.numbers.last().map_or(1, |number| number.to_string().len() + 2);
    let room = (columns.len() * page.column + 1).max(widest);
    let mut line = Line::new(room);
    let every = widest.div_ceil(page.column).max(1);
    for column in columns.clone().filter(|column| column % every == 0) {
        let (at, number) =
            ((column - columns.start) * page.column + 1, axis.numbers[column].to_string());
        // A part of a number would read as another number.
        if at + number.len() <= room {
            line.write(at, &number);
        }
    }
    if let Some(place) =
        axis.marker.as_ref().map(|marker| character(axis, page, columns, marker.start))
    {
        line.put(place, MARKER);
    }
    line.finish()
}

/// The position of a time in the line of a panel: below 0 or beyond the end where it lies outside.
fn character(axis: &Axis, page: &Page, columns: &Range<usize>, time: u64) -> i64 {
    ((axis.place(time) - columns.start as f64) * page.column as f64).round() as i64
}

/// Writes a row's values in a panel.
fn wave(row: &SignalRow, figure: &Figure, page: &Page, columns: &Range<usize>) -> String {
    let end = (columns.len() * page.column) as i64;
    let place = |time| character(&figure.axis, page, columns, time);
    let mut line = Line::new(columns.len() * page.column + 1);
    let mut last = None;
    for segment in &row.segments {
        let (from, to) = (place(segment.time.start), place(segment.time.end));
        if (to <= 0 && from < 0) || from >= end {
            continue;
        }
        match row.shape {
            Shape::Levels => level(&mut line, from.max(0)..to.min(end), segment),
            Shape::Events => line.put(from, EVENT),
            Shape::Cells { .. } => cell(&mut line, from.max(0)..to.min(end), row, segment),
        }
        if last == Some(from) && row.shape != Shape::Events {
            line.put(from, CROWDED);
        }
        last = Some(from);
    }
    line.finish()
}

fn level(line: &mut Line, place: Range<i64>, segment: &Segment) {
    let character = match &segment.value {
        Value::Bits(bits) => match bits.as_str() {
            "0" => LOW,
            "1" => HIGH,
            "z" => FLOATING,
            other => other.chars().next().unwrap_or('x'),
        },
        Value::Real(_) | Value::Text(_) => 'x',
    };
    place.for_each(|at| line.put(at, character));
}

fn cell(line: &mut Line, place: Range<i64>, row: &SignalRow, segment: &Segment) {
    line.put(place.start, BAR);
    let room = usize::try_from(place.end - place.start - 1).unwrap_or(0);
    match row.written_or_begun(&segment.value, room) {
        Some(text) => line.write(place.start as usize + 1, &text),
        None if room > 0 => line.put(place.start + 1, CUT),
        None => {}
    }
    line.put(place.end, BAR);
}

/// The end of a name that does not fit: the end distinguishes it from other names.
fn end_of(name: &str, room: usize) -> String {
    let length = name.chars().count();
    if length <= room {
        return name.to_owned();
    }
    iter::once(CUT).chain(name.chars().skip(length + 1 - room)).collect()
}

/// A line under construction.
struct Line {
    characters: Vec<char>,
}

impl Line {
    fn new(length: usize) -> Line {
        Line { characters: vec![' '; length] }
    }

    /// Sets the character at a position; positions outside of the line are ignored.
    fn put(&mut self, at: i64, character: char) {
        if let Some(place) = usize::try_from(at).ok().and_then(|at| self.characters.get_mut(at)) {
            *place = character;
        }
    }

    fn write(&mut self, at: usize, text: &str) {
        (at as i64..).zip(text.chars()).for_each(|(at, character)| self.put(at, character));
    }

    fn finish(self) -> String {
        self.characters.into_iter().collect()
    }
}
