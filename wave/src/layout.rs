//! Positions on a sheet, in pixels.
use std::ops::RangeInclusive;

use super::figure::{Figure, SignalRow};
use specula_drawing::{CAPITAL, CHARACTER};

/// Width of the margin around the drawing.
pub const MARGIN: f64 = 16.0;
/// Distance from one row to the next.
pub const ROW: f64 = 22.0;
/// Horizontal extent of an edge, and of a cell's pointed end.
pub const SLANT: f64 = 3.0;
/// Smallest and largest width of a column: room for five to eight characters.
const COLUMN: RangeInclusive<f64> = 48.0..=72.0;
/// Width that all columns together should not exceed, unless each has its smallest width.
const COLUMNS: f64 = 1320.0;
/// Characters of a value for which columns are widened up to their largest width. In a short window
/// they become wider for longer values.
const LONGEST_VALUE: usize = 8;

/// The positions of a figure's parts.
pub struct Layout {
    /// Left end of the columns.
    pub left: f64,
    /// Width of a column.
    pub column: f64,
    /// The number of columns.
    pub columns: usize,
    /// Top of the rows.
    pub top: f64,
    /// Bottom of the rows.
    pub bottom: f64,
    /// Width of the whole sheet.
    pub width: f64,
    /// Height of the whole sheet.
    pub height: f64,
}

impl Layout {
    /// The layout of a figure. If `width` is given, the sheet is that many pixels wide, unless a
    /// column would become too narrow.
    pub fn new(figure: &Figure, width: Option<u32>) -> Layout {
        let columns = figure.axis.numbers.len();
        let label = |row: &SignalRow| row.name.chars().count() + row.format().chars().count() + 2;
        let names =
            figure.rows().map(label).max().unwrap_or(0).max(figure.axis.unit.chars().count() + 1);
        let left = (MARGIN + CHARACTER * names as f64 + 2.0 * SLANT).round();
        let column = match width {
            Some(width) => ((f64::from(width) - left - MARGIN) / columns.max(1) as f64)
                .max(*COLUMN.start())
                .floor(),
            None => column(figure, columns),
        };
        let top = MARGIN + ROW + CAPITAL + ROW / 2.0;
        let bottom = top + ROW * (figure.groups.len() + figure.rows().count()) as f64;
        let words = figure
            .notes
            .iter()
            .chain([&figure.title])
            .map(|text| text.chars().count())
            .max()
            .unwrap_or(0);
        let right = (left + column * columns as f64).max(MARGIN + CHARACTER * words as f64);
        let height = bottom + MARGIN + ROW * figure.notes.len() as f64;
        Layout {
            left,
            column,
            columns,
            top,
            bottom,
            width: (right + MARGIN).ceil(),
            height: height.ceil(),
        }
    }

    /// The horizontal position of a place that is given in columns.
    pub fn x(&self, place: f64) -> f64 {
        self.left + self.column * place
    }

    /// Right end of the columns.
    pub fn right(&self) -> f64 {
        self.x(self.columns as f64)
    }
}

/// A column's width at which its values can be read.
fn column(figure: &Figure, columns: usize) -> f64 {
    let room = COLUMNS / columns.max(1) as f64;
    let beside = ((room - 4.0 * SLANT) / CHARACTER).max(LONGEST_VALUE as f64) as usize;
    let longest = figure.longest_value(beside, beside);
    let wanted = CHARACTER * longest as f64 + 4.0 * SLANT;
    let widest = if longest > LONGEST_VALUE { f64::INFINITY } else { *COLUMN.end() };
    wanted.min(room).min(widest).max(*COLUMN.start()).floor()
}
