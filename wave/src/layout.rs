//! Where things stand on a sheet, in pixels.
use std::ops::RangeInclusive;

use super::figure::{Figure, Row};
use specula_drawing::{CAPITAL, CHARACTER};

/// Around everything.
pub const MARGIN: f64 = 16.0;
/// From a row to the next.
pub const ROW: f64 = 22.0;
/// Horizontal run of an edge and of a cell's end.
pub const SLANT: f64 = 3.0;
/// A column's width: room for five to eight characters.
const COLUMN: RangeInclusive<f64> = 48.0..=72.0;
/// Width that all columns together should not exceed, if their least width lets them.
const COLUMNS: f64 = 1320.0;
/// Characters of a value for which columns are made that wide; in a short window, wider for longer
/// ones.
const LONGEST_VALUE: usize = 8;

/// Where things stand.
pub struct Layout {
    /// Where columns begin.
    pub left: f64,
    /// A column's width.
    pub column: f64,
    /// The number of columns.
    pub columns: usize,
    /// Where rows begin.
    pub top: f64,
    /// Where rows end.
    pub bottom: f64,
    /// Of the whole sheet.
    pub width: f64,
    /// Of the whole sheet.
    pub height: f64,
}

impl Layout {
    /// The layout of a figure, in a width in pixels if that is given and no column becomes too
    /// narrow.
    pub fn new(figure: &Figure, width: Option<u32>) -> Layout {
        let columns = figure.axis.numbers.len();
        let label = |row: &Row| row.name.chars().count() + row.format().chars().count() + 2;
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

    /// Where a place in columns is.
    pub fn x(&self, place: f64) -> f64 {
        self.left + self.column * place
    }

    /// Where columns end.
    pub fn right(&self) -> f64 {
        self.x(self.columns as f64)
    }
}

/// A column's width that lets its values be read.
fn column(figure: &Figure, columns: usize) -> f64 {
    let room = COLUMNS / columns.max(1) as f64;
    let beside = ((room - 4.0 * SLANT) / CHARACTER).max(LONGEST_VALUE as f64) as usize;
    let longest = figure.longest_value(beside, beside);
    let wanted = CHARACTER * longest as f64 + 4.0 * SLANT;
    let widest = if longest > LONGEST_VALUE { f64::INFINITY } else { *COLUMN.end() };
    wanted.min(room).min(widest).max(*COLUMN.start()).floor()
}
