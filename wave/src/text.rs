//! A figure as text: a row for each signal, values behind bars, bits as lines.
use std::fmt::Write;
use std::ops::Range;

use super::figure::{Axis, Figure, Row, Shape};
use super::segments::Segment;
use super::value::Value;

/// Characters of a value that columns are made wide for where more of them would have to stand
/// below each other: 64 bits in hexadecimal.
const LONGEST_VALUE: usize = 16;
/// The same for numbers that can be rounded.
const LONGEST_ROUNDED: usize = 9;
/// Characters of a column, at least: a bar and room for a short number.
const NARROWEST: usize = 5;
/// Blanks before a signal's name: it stands below its unit's.
const INDENT: usize = 2;

/// The bar between two values.
const BAR: char = '\u{2502}';
/// Where a value changes more often than characters can show.
const CROWDED: char = '\u{2573}';
const LOW: char = '_';
const HIGH: char = '\u{2594}';
const FLOATING: char = '\u{2500}';
/// Stands for a value that does not fit.
const CUT: char = '\u{2026}';
/// Characters in which it is worth while to show the begin of a text.
const SHORTEST_CUT: usize = 4;
/// Stands for an event.
const EVENT: char = '\u{2191}';
const MARKER: char = '\u{25bc}';

/// Where things stand in a line.
struct Page {
    /// Characters of names and formats.
    names: usize,
    /// Characters of a column.
    column: usize,
    /// Columns that stand side by side.
    columns: usize,
}

impl Page {
    fn new(figure: &Figure, width: usize) -> Page {
        let label =
            |row: &Row| INDENT + row.name.chars().count() + 1 + row.format().chars().count();
        let names = figure.rows().map(label).max().unwrap_or(0) + 1;
        let room = width.saturating_sub(names + 1).max(NARROWEST);
        let number = figure.axis.numbers.last().map_or(0, |number| number.to_string().len());
        let all = figure.axis.numbers.len().max(1);
        // A short window has room for values of any length.
        let beside = (room / all).saturating_sub(1);
        let longest = |rounded: usize, most: usize| {
            figure.longest_value(rounded.max(beside), most.max(beside))
        };
        let wanted = (longest(LONGEST_ROUNDED, LONGEST_VALUE).max(number) + 1).max(NARROWEST);
        // Values shorter by a few decimals are better than a second panel, but not too short.
        let least =
            (figure.longest_value(NARROWEST + 1, LONGEST_VALUE) + 1).max(NARROWEST + 2).min(wanted);
        let column = (room / all).clamp(least, wanted).min(room);
        Page { names, column, columns: (room / column).clamp(1, all) }
    }
}

/// The figure as lines of `width` characters, in as many panels below each other as it takes.
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

/// How many columns of the figure stand side by side in `width` characters.
pub fn columns_beside(figure: &Figure, width: usize) -> u64 {
    Page::new(figure, width).columns as u64
}

/// How many columns could stand side by side in `width` characters, whatever their values.
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
        // Not every dump has scopes.
        if !group.unit.is_empty() {
            push_line(text, &group.unit);
        }
        for row in &group.rows {
            let space = page.names - INDENT - 1 - row.format().chars().count();
            let name = format!("{:INDENT$}{:space$}{} ", "", row.name, row.format());
            push_line(text, &(name + &wave(row, figure, page, columns)));
        }
    }
}

fn push_line(text: &mut String, line: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", line.trim_end());
}

/// The columns' numbers, as many as there is room for; the marker stands before its own.
fn numbers(axis: &Axis, page: &Page, columns: &Range<usize>) -> String {
    let widest = axis.numbers.last().map_or(1, |number| number.to_string().len() + 2);
    let room = (columns.len() * page.column + 1).max(widest);
    let mut line = Line::new(room);
    let every = widest.div_ceil(page.column).max(1);
    for column in columns.clone().filter(|column| column % every == 0) {
        let (at, number) =
            ((column - columns.start) * page.column + 1, axis.numbers[column].to_string());
        // A piece of a number would be another number.
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

/// Where a time stands in the line of a panel; outside of it before 0 or behind the end.
fn character(axis: &Axis, page: &Page, columns: &Range<usize>, time: u64) -> i64 {
    ((axis.place(time) - columns.start as f64) * page.column as f64).round() as i64
}

/// A row's values in a panel.
fn wave(row: &Row, figure: &Figure, page: &Page, columns: &Range<usize>) -> String {
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

fn cell(line: &mut Line, place: Range<i64>, row: &Row, segment: &Segment) {
    line.put(place.start, BAR);
    let room = usize::try_from(place.end - place.start - 1).unwrap_or(0);
    match row.written(&segment.value, room) {
        Some(text) => line.write(place.start as usize + 1, &text),
        None if room >= SHORTEST_CUT => match &segment.value {
            Value::Text(text) => line.write(place.start as usize + 1, &cut(text, room)),
            _ => line.put(place.start + 1, CUT),
        },
        None if room > 0 => line.put(place.start + 1, CUT),
        None => {}
    }
    line.put(place.end, BAR);
}

/// The begin of a text that does not fit.
fn cut(text: &str, room: usize) -> String {
    text.chars().take(room - 1).chain([CUT]).collect()
}

/// A line while it is written.
struct Line {
    characters: Vec<char>,
}

impl Line {
    fn new(length: usize) -> Line {
        Line { characters: vec![' '; length] }
    }

    /// Puts a character in its place; outside of the line it is left out.
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
