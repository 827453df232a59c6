//! Plots: dots and lines over two axes, with labels that do not overlap.
//!
//! `plotters` draws the axes on a [`Recorder`](recorder::Recorder), which records what is drawn.
//! The result is a [`Sheet`], as a waveform's drawing is, so that SVG (light and dark) and PNG come
//! from the same code and need no installed font.
mod axis;
mod draw;
mod labels;
mod recorder;

pub use axis::{Axis, AxisScale};

use specula_drawing::{Series, Sheet};

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

/// The reason why a plot cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the plot \"{title}\" cannot be drawn: {reason}")]
pub struct PlotError {
    title: String,
    reason: String,
}

impl Plot {
    /// Lays the plot out. Points that an axis cannot show (numbers that are not finite and, on
    /// logarithmic axes, those not above 0) are left out.
    ///
    /// # Errors
    /// [`PlotError`] if there is no room for the axes.
    pub fn render(&self) -> Result<Sheet, PlotError> {
        draw::render(self).map_err(|reason| PlotError { title: self.title.clone(), reason })
    }
}

#[cfg(test)]
mod tests;
