//! What a plot shows.
use specula_drawing::Series;

use super::axis::Axis;

/// A point of a plot, in the axes' units.
pub type PlotPoint = (f64, f64);

/// A plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Title of the plot.
    pub title: String,
    /// The axis from left to right.
    pub x: Axis,
    /// The axis from bottom to top.
    pub y: Axis,
    /// The series, from the lowest to the topmost.
    pub series: Vec<PlotSeries>,
    /// A line below everything else: the Pareto front.
    pub front: Vec<PlotPoint>,
    /// The labels; the first ones are placed best.
    pub labels: Vec<Label>,
    /// Lines of text below the plot.
    pub notes: Vec<String>,
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotSeries {
    /// Its colour.
    pub colour: Series,
    /// Its points, in the order of its line.
    pub places: Vec<PlotPoint>,
    /// How it is drawn.
    pub style: SeriesStyle,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SeriesStyle {
    /// Only dots.
    Dots,
    /// Dots with a line through them.
    LineWithDots,
    /// Only a line.
    Line,
}

/// A label next to a point.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The place.
    pub at: PlotPoint,
    /// The text, in ASCII.
    pub words: String,
    /// The colour of the text.
    pub colour: Series,
}
