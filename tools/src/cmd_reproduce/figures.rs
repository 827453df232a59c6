//! The papers' figures as plots.
use specula_experiments::reproduce::figure::{CurveKind, Figure, FigureCurve};

use crate::plot::{Axis, AxisScale, Label, Plot, PlotSeries, SeriesStyle};
use specula_drawing::Series;

/// Makes a plot of a figure.
pub fn plot(figure: &Figure) -> Plot {
    let axis = |title: &str| Axis { title: title.to_owned(), scale: AxisScale::Linear };
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

fn series(curve: &FigureCurve) -> PlotSeries {
    let style = match curve.kind {
        CurveKind::Formula => SeriesStyle::Line,
        CurveKind::Core => SeriesStyle::Dots,
    };
    PlotSeries { colour: Series::new(curve.colour), places: curve.points.clone(), style }
}

fn label(curve: &FigureCurve) -> Option<Label> {
    Some(Label {
        at: *curve.points.get(curve.label?)?,
        words: curve.name.clone(),
        colour: Series::new(curve.colour),
    })
}
