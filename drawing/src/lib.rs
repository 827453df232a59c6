//! Drawings of shapes and text: laid out once as a [`Sheet`], written as SVG, with colours for
//! light and dark backgrounds, or as PNG.
pub mod canvas;
mod palette;
mod png;
mod svg;
mod typeface;

pub use palette::light;
pub use png::png;
pub use svg::{escaped, svg};

/// Width of a character in pixels, at most.
pub const CHARACTER: f64 = 8.0;
/// Height of a capital in pixels.
pub const CAPITAL: f64 = 9.0;

/// A laid-out drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheet {
    /// A description for readers who cannot see the drawing.
    pub title: String,
    /// Width and height in pixels.
    pub size: (f64, f64),
    /// The marks, from the lowest to the topmost.
    pub marks: Vec<Mark>,
}

/// A point: distance from the left, distance from the top.
pub type Point = (f64, f64);

/// A mark on a sheet.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A filled rectangle: corner and size.
    Box(Ink, Point, (f64, f64)),
    /// Straight lines, each from a point to a point.
    Lines(Ink, Vec<(Point, Point)>),
    /// Open polylines, each given by its points.
    Traces(Ink, Vec<Vec<Point>>),
    /// Filled and outlined polygons.
    Areas(Ink, Vec<Vec<Point>>),
    /// Text that begins at a point of its base line.
    Text(Ink, Point, String),
    /// Text that ends at a point of its base line.
    TextEnding(Ink, Point, String),
    /// Text centred at a point of its base line.
    TextCentred(Ink, Point, String),
    /// Text that runs upwards, centred at a point of its base line.
    TextUpwards(Ink, Point, String),
    /// Round dots at points, all of one radius.
    Dots(Ink, Vec<Point>, f64),
}

impl Mark {
    /// The ink that the mark is drawn with.
    pub fn ink(&self) -> Ink {
        match self {
            Mark::Box(ink, ..)
            | Mark::Lines(ink, _)
            | Mark::Traces(ink, _)
            | Mark::Areas(ink, _)
            | Mark::Text(ink, ..)
            | Mark::TextEnding(ink, ..)
            | Mark::TextCentred(ink, ..)
            | Mark::TextUpwards(ink, ..)
            | Mark::Dots(ink, ..) => *ink,
        }
    }
}

/// The role of a mark. The back ends map roles to colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Ink {
    /// The background.
    Paper,
    /// The drawing's title.
    Title,
    /// A unit's name, and the line next to it.
    Unit,
    /// A signal's name.
    Name,
    /// A format, a column's number, a note.
    Aside,
    /// Borders of columns.
    Grid,
    /// Levels of one-bit signals.
    Level,
    /// The area below the level of a bit that is 1.
    High,
    /// Cells of values.
    Cell,
    /// Cells and bits that are unknown or high-impedance.
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
    /// The line along the Pareto front of a plot.
    Front,
    /// Lines of a plot's series, by number.
    SeriesLine(Series),
    /// Dots and text of a plot's series.
    Series(Series),
}

/// The number of a plot's series. There are [`SERIES`] colours, which repeat.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Series(u8);

/// Number of different colours for series.
pub const SERIES: u8 = 9;

impl Series {
    /// The series with colour `number` modulo [`SERIES`].
    pub const fn new(number: usize) -> Series {
        Series((number % SERIES as usize) as u8)
    }

    /// The number of its colour, from 0 to [`SERIES`] - 1.
    pub const fn number(self) -> usize {
        self.0 as usize
    }
}
