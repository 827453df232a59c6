//! Plots: dots and lines over two axes, with labels that do not overlap.
//!
//! `plotters` draws the axes on a [`Recorder`](recorder::Recorder), which records what is drawn.
//! The result is a [`Sheet`], as a waveform's drawing is, so that SVG (light and dark) and PNG come
//! from the same code and need no installed font.
mod axis;
mod contents;
mod draw;
mod labels;
mod recorder;

pub use axis::{Axis, AxisScale};
pub use contents::{Label, Plot, PlotPoint, PlotSeries, SeriesStyle};

use specula_drawing::Sheet;

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
