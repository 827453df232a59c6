//! Figures as plots.
use specula_experiments::reproduce::figure::{Curve, CurveKind, Figure};

use crate::plot::{Axis, Label, Plot, PlotSeries, Scale, Shown};
use specula_drawing::Series;

/// A figure as a plot.
pub fn plot(figure: &Figure) -> Plot {
    let axis = |title: &str| Axis { title: title.to_owned(), scale: Scale::Linear };
    Plot {
        title: figure.title.clone(),
        x: axis(figure.x),
        y: axis(figure.y),
        series: figure.curves.iter().map(series).collect(),
        front: vec![],
        labels: figure.curves.iter().filter_map(label).collect(),
        notes: figure.notes.clone(),
    }
}

fn series(curve: &Curve) -> PlotSeries {
    let shown = match curve.kind {
        CurveKind::Formula => Shown::Line,
        CurveKind::Core => Shown::Dots,
    };
    PlotSeries { colour: Series::new(curve.colour), places: curve.points.clone(), shown }
}

fn label(curve: &Curve) -> Option<Label> {
    Some(Label {
        at: *curve.points.get(curve.label?)?,
        words: curve.name.clone(),
        colour: Series::new(curve.colour),
    })
}
