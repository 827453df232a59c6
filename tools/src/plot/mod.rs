//! Plots: dots and lines over two axes, with words beside them that do not overlap.
//!
//! `plotters` draws the axes, on a [`Recorder`](recorder::Recorder) that takes down what it draws;
//! the result is a [`Sheet`], as a waveform's drawing is, so that SVG (light and dark) and PNG come
//! from the same code and need no font.
mod axis;
mod draw;
mod labels;
mod recorder;

pub use axis::{Axis, Scale};

use specula_drawing::{Series, Sheet};

/// A place on a plot, in the axes' units.
pub type Place = (f64, f64);

/// A plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// The axis from left to right.
    pub x: Axis,
    /// The axis from bottom to top.
    pub y: Axis,
    /// What is drawn, from the lowest to the topmost.
    pub series: Vec<PlotSeries>,
    /// A line that is drawn below everything: the Pareto front.
    pub front: Vec<Place>,
    /// Words beside places; those that come first are placed best.
    pub labels: Vec<Label>,
    /// Lines of words below the plot.
    pub notes: Vec<String>,
}

/// Places that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct PlotSeries {
    /// Its colour.
    pub colour: Series,
    /// Where its dots are, in the order of its line.
    pub places: Vec<Place>,
    /// How they are shown.
    pub shown: Shown,
}

/// How a series is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// Dots alone.
    Dots,
    /// Dots with a line through them.
    LineWithDots,
    /// A line alone.
    Line,
}

/// Words beside a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The place.
    pub at: Place,
    /// Its words, in ASCII.
    pub words: String,
    /// Their colour.
    pub colour: Series,
}

/// Why a plot cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the plot \"{title}\" cannot be drawn: {reason}")]
pub struct PlotError {
    title: String,
    reason: String,
}

impl Plot {
    /// Lays the plot out. What an axis cannot show (numbers that are not finite; on logarithmic
    /// axes those not above 0) is left out.
    ///
    /// # Errors
    /// [`PlotError`] if the axes do not fit.
    pub fn render(&self) -> Result<Sheet, PlotError> {
        draw::render(self).map_err(|reason| PlotError { title: self.title.clone(), reason })
    }
}

#[cfg(test)]
mod tests;
