//! How recurrences drift with the length of a span.
use specula_experiments::stress::drift::{self, Drift};

use crate::error::ToolError;
use crate::plot::{Axis, Label, Plot, PlotSeries, Scale, Shown};
use specula_drawing::{self as drawing, Series};

/// A plot's file, what it shows, and what is measured for it.
struct Subject {
    file: &'static str,
    title: &'static str,
    drifts: fn(u32) -> Vec<Drift>,
}

const SUBJECTS: [Subject; 3] = [
    Subject {
        file: "drift_f32.svg",
        title: "The papers' loops in f32 against their methods in f64",
        drifts: drift::software,
    },
    Subject {
        file: "drift_fixed.svg",
        title: "Cores with the formats that a span of 64 pixels is given, on longer ones",
        drifts: drift::fixed,
    },
    Subject {
        file: "drift_chosen.svg",
        title: "Cores with the formats that are chosen for the span",
        drifts: drift::chosen,
    },
];

/// Pixels of the longest span.
const LONGEST: u32 = 8192;
/// What is drawn where there is no error at all.
const LEAST: f64 = 1e-5;

/// Names of the plots' files.
pub fn names() -> impl Iterator<Item = String> {
    SUBJECTS.iter().map(|subject| subject.file.to_owned())
}

/// The plots: names and texts of their files.
pub fn all() -> Result<Vec<(String, String)>, ToolError> {
    let one = |subject: &Subject| {
        let sheet = plot(subject.title, &(subject.drifts)(LONGEST)).render()?;
        Ok((subject.file.to_owned(), drawing::svg(&sheet)))
    };
    SUBJECTS.iter().map(one).collect()
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
        shown: Shown::LineWithDots,
    };
    let label = |(number, drift): (usize, &Drift)| {
        Some(Label {
            at: *places(drift).last()?,
            words: drift.name.clone(),
            colour: Series::new(number),
        })
    };
    let axis = |title: &str| Axis { title: title.to_owned(), scale: Scale::Logarithmic };
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
