//! The plot of errors over time.
use specula_drawing::Series;

use super::{ShadedFrame, ShadedSequence};
use crate::plot::{Axis, AxisScale, Label, Plot, PlotSeries, SeriesStyle};

/// Name of the file.
pub const PLOT: &str = "errors.svg";

/// The largest error of each frame, in total, of the method and of quantisation, with what the last
/// is proven to stay within.
pub fn plot(sequence: &ShadedSequence, name: &str, bound_lsb: f64) -> Plot {
    let curves: [(&str, fn(&ShadedFrame) -> f64); 3] = [
        ("total", |frame| frame.error.total.max_lsb),
        ("of the method", |frame| frame.error.method.max_lsb),
        ("of quantisation", |frame| frame.error.quantisation.max_lsb),
    ];
    let frames = || sequence.by_frame.iter();
    let last = f64::from(sequence.frames.saturating_sub(1));
    let measured = curves.iter().map(|(name, error)| {
        (*name, frames().map(|frame| (f64::from(frame.frame), error(frame))).collect())
    });
    let bound = ("proven bound of quantisation", vec![(0.0, bound_lsb), (last, bound_lsb)]);
    let curves: Vec<(&str, Vec<(f64, f64)>)> = measured.chain([bound]).collect();
    let series = |(number, (_, places)): (usize, &(&str, Vec<(f64, f64)>))| PlotSeries {
        colour: Series::new(number),
        places: places.clone(),
        style: SeriesStyle::Line,
    };
    let label = |(number, (name, places)): (usize, &(&str, Vec<(f64, f64)>))| {
        Some(Label {
            at: *places.last()?,
            words: (*name).to_owned(),
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
