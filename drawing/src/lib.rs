//! Drawings of shapes and words: laid out once as a [`Sheet`], written as SVG, light and dark, or
//! as PNG.
pub mod canvas;
mod palette;
mod png;
mod svg;
mod typeface;

pub use palette::light;
pub use png::png;
pub use svg::{escaped, svg};

/// Width that a character takes, at most.
pub const CHARACTER: f64 = 8.0;
/// Height of capitals.
pub const CAPITAL: f64 = 9.0;

/// A laid-out drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// What it shows, for those who cannot see it.
    pub title: String,
    /// Width and height.
    pub size: (f64, f64),
    /// What is on it, from the lowest to the topmost.
    pub marks: Vec<Mark>,
}

/// A point: from the left, from the top.
pub type Point = (f64, f64);

/// Something on a sheet.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A filled rectangle: corner and size.
    Box(Ink, Point, (f64, f64)),
    /// Straight lines.
    Lines(Ink, Vec<(Point, Point)>),
    /// Lines through points, open; a line each.
    Traces(Ink, Vec<Vec<Point>>),
    /// Filled and outlined areas.
    Areas(Ink, Vec<Vec<Point>>),
    /// Words that begin at a point of their base line.
    Words(Ink, Point, String),
    /// Words that end there.
    WordsBefore(Ink, Point, String),
    /// Words in the middle there.
    WordsAmid(Ink, Point, String),
    /// Words that run upwards, in the middle there.
    WordsUp(Ink, Point, String),
    /// Round dots of one radius.
    Dots(Ink, Vec<Point>, f64),
}

impl Mark {
    /// What it is drawn with.
    pub fn ink(&self) -> Ink {
        match self {
            Mark::Box(ink, ..)
            | Mark::Lines(ink, _)
            | Mark::Traces(ink, _)
            | Mark::Areas(ink, _)
            | Mark::Words(ink, ..)
            | Mark::WordsBefore(ink, ..)
            | Mark::WordsAmid(ink, ..)
            | Mark::WordsUp(ink, ..)
            | Mark::Dots(ink, ..) => *ink,
        }
    }
}

/// What a mark stands for; the back ends know its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ink {
    /// What everything stands on.
    Paper,
    /// The drawing's title.
    Title,
    /// A unit's name, and the line beside it.
    Unit,
    /// A signal's name.
    Name,
    /// A format, a column's number, a note.
    Aside,
    /// Borders of columns.
    Grid,
    /// Lines of bits.
    Level,
    /// What lies below the line of a bit that is 1.
    High,
    /// Cells of values.
    Cell,
    /// Cells and bits that are unknown or float.
    Unknown,
    /// Cells and bits whose value matters most.
    Highlight,
    /// A value in its cell.
    Value,
    /// A value that matters most.
    HighlightValue,
    /// The band of the marker.
    Marker,
    /// The marker's number.
    MarkerNumber,
    /// The frame of a plot.
    Axis,
    /// The line that says where the best of a plot lie.
    Front,
    /// Lines of a plot's series, by number.
    SeriesLine(Series),
    /// Dots and words of a plot's series.
    Series(Series),
}

/// The number of a plot's series; there are [`SERIES`] colours, and then they come again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Series(u8);

/// Colours of series.
pub const SERIES: u8 = 9;

impl Series {
    /// Number `number`.
    pub const fn new(number: usize) -> Series {
        Series((number % SERIES as usize) as u8)
    }

    /// From 0 to [`SERIES`] - 1.
    pub const fn number(self) -> usize {
        self.0 as usize
    }
}
