//! Plots of the drift of recurrences with the length of a span.
use specula_experiments::stress::drift::{self, Drift};

use crate::error::ToolError;
use crate::plot::{Axis, AxisScale, Label, Plot, PlotSeries, SeriesStyle};
use specula_drawing::{self as drawing, Series};

/// A plot: its file, its title, and what is measured for it.
struct DriftPlot {
    file: &'static str,
    title: &'static str,
    drifts: fn(u32) -> Vec<Drift>,
}

const PLOTS: [DriftPlot; 3] = [
    DriftPlot {
        file: "drift_f32.svg",
        title: "The papers' loops in f32 against their methods in f64",
        drifts: drift::software,
    },
    DriftPlot {
        file: "drift_fixed.svg",
        title: "Cores with the formats that a span of 64 pixels is given, on longer ones",
        drifts: drift::fixed,
    },
    DriftPlot {
        file: "drift_chosen.svg",
        title: "Cores with the formats that are chosen for the span",
        drifts: drift::chosen,
    },
];

/// Length of the longest span in pixels.
const LONGEST: u32 = 8192;
/// The value that is drawn where the error is 0.
const LEAST: f64 = 1e-5;

/// The names of the plots' files.
pub fn names() -> impl Iterator<Item = String> {
    PLOTS.iter().map(|plot| plot.file.to_owned())
}

/// The plots as pairs of file name and file contents.
pub fn all() -> Result<Vec<(String, String)>, ToolError> {
    let one = |drift: &DriftPlot| {
        let sheet = plot(drift.title, &(drift.drifts)(LONGEST)).render()?;
        Ok((drift.file.to_owned(), drawing::svg(&sheet)))
    };
    PLOTS.iter().map(one).collect()
}

fn plot(title: &str, drifts: &[Drift]) -> Plot {
    let places = |drift: &Drift| {
        drift
            .points
            .iter()
            .map(|&(steps, error)| (f64::from(steps), error.max(LEAST)))
            .collect::<Vec<_>>()
    };
    let series = |(number, drift): (usize, &Drift)| PlotSeries {
        colour: Series::new(number),
        places: places(drift),
        style: SeriesStyle::LineWithDots,
    };
    let label = |(number, drift): (usize, &Drift)| {
        Some(Label {
            at: *places(drift).last()?,
            words: drift.name.clone(),
            colour: Series::new(number),
        })
    };
    let axis = |title: &str| Axis { title: title.to_owned(), scale: AxisScale::Logarithmic };
    Plot {
        title: title.to_owned(),
        x: axis("steps of the span"),
        y: axis("largest error in LSB"),
        series: drifts.iter().enumerate().map(series).collect(),
        front: Vec::new(),
        labels: drifts.iter().enumerate().filter_map(label).collect(),
        notes: vec![
            "30 degrees, n = 256. Up to half an LSB of a core's error is the rounding to 8 bits."
                .to_owned(),
        ],
    }
}
