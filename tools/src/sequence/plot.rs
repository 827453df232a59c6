//! The plot of errors over time.
use specula_drawing::Series;

use super::{ShadedFrame, ShadedSequence};
use crate::plot::{Axis, AxisScale, Label, Plot, PlotPoint, PlotSeries, SeriesStyle};

/// Name of the file.
pub const PLOT: &str = "errors.svg";

/// A line of the plot.
struct Curve {
    words: &'static str,
    places: Vec<PlotPoint>,
}

/// The largest error of each frame, in total, of the method and of quantisation, with what the last
/// is proven to stay within.
pub fn plot(sequence: &ShadedSequence, name: &str, bound_lsb: f64) -> Plot {
    let measured = |words, error: fn(&ShadedFrame) -> f64| {
        let place = |frame: &ShadedFrame| (f64::from(frame.frame), error(frame));
        Curve { words, places: sequence.by_frame.iter().map(place).collect() }
    };
    let last = f64::from(sequence.frames.saturating_sub(1));
    let curves = [
        measured("total", |frame| frame.error.total.max_lsb),
        measured("of the method", |frame| frame.error.method.max_lsb),
        measured("of quantisation", |frame| frame.error.quantisation.max_lsb),
        Curve {
            words: "proven bound of quantisation",
            places: vec![(0.0, bound_lsb), (last, bound_lsb)],
        },
    ];
    let series = |(number, curve): (usize, &Curve)| PlotSeries {
        colour: Series::new(number),
        places: curve.places.clone(),
        style: SeriesStyle::Line,
    };
    let label = |(number, curve): (usize, &Curve)| {
        Some(Label {
            at: *curve.places.last()?,
            words: curve.words.to_owned(),
            colour: Series::new(number),
        })
    };
    Plot {
        title: format!("{name}: the largest error of each frame"),
        x: Axis { title: "frame".to_owned(), scale: AxisScale::Linear },
        y: Axis { title: "largest error in LSB".to_owned(), scale: AxisScale::Linear },
        series: curves.iter().enumerate().map(series).collect(),
        front: vec![],
        labels: curves.iter().enumerate().filter_map(label).collect(),
        notes: vec![],
    }
}
