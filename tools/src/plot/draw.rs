//! Lays out a plot.
use std::convert::Infallible;

use plotters::chart::ChartBuilder;
use plotters::drawing::{DrawingAreaErrorKind, IntoDrawingArea};
use plotters::style::{Color, IntoFont, TRANSPARENT};

use super::axis::{self, AxisScale};
use super::contents::{Plot, PlotPoint, SeriesStyle};
use super::labels::{Area, placed};
use super::recorder::{Recorder, colour_of};
use specula_drawing::{CAPITAL, Ink, Mark, Point, Sheet};

/// Width and height of the axes with their text.
const SIZE: (u32, u32) = (920, 520);
/// Width of the margin around the drawing.
const MARGIN: f64 = 16.0;
/// Height of the title's line, and of a note's.
const LINE: f64 = 22.0;
/// Room for an axis's text: below the plot, and on its left.
const WORDS: (u32, u32) = (46, 68);
/// Radius of a dot.
const DOT: f64 = 4.0;
/// Side of the squares by which a line is represented when labels are placed.
const SAMPLE: f64 = 6.0;

type Failure = DrawingAreaErrorKind<Infallible>;

/// Lays out the plot as a sheet.
pub fn render(plot: &Plot) -> Result<Sheet, String> {
    let size = (
        f64::from(SIZE.0) + 2.0 * MARGIN,
        f64::from(SIZE.1) + LINE * (1 + plot.notes.len()) as f64 + 2.0 * MARGIN,
    );
    let mut marks = vec![Mark::Box(Ink::Paper, (0.0, 0.0), size)];
    marks.push(Mark::Text(Ink::Title, (MARGIN, MARGIN + CAPITAL), plot.title.clone()));
    let (axes, area) = axes(plot, &mut marks).map_err(|error| error.to_string())?;
    draw(plot, &axes, &area, &mut marks);
    for (number, note) in plot.notes.iter().enumerate() {
        let base = f64::from(SIZE.1) + MARGIN + LINE * (number + 2) as f64 - CAPITAL / 2.0;
        marks.push(Mark::Text(Ink::Aside, (MARGIN, base), note.clone()));
    }
    let below = |mark: &Mark| {
        !matches!(
            mark,
            Mark::Text(..) | Mark::TextCentred(..) | Mark::TextEnding(..) | Mark::TextUpwards(..)
        )
    };
    // Text lies above shapes.
    let (shapes, words): (Vec<Mark>, Vec<Mark>) = marks.into_iter().partition(below);
    Ok(Sheet { title: plot.title.clone(), size, marks: shapes.into_iter().chain(words).collect() })
}

/// The map from the axes' units to points of the sheet.
struct Axes {
    scales: [AxisScale; 2],
    /// For each axis the position of its origin, and the pixels for each of its units.
    lines: [(f64, f64); 2],
}

impl Axes {
    fn point(&self, (x, y): PlotPoint) -> Option<Point> {
        let at = |axis: usize, number: f64| {
            let (begin, unit) = self.lines[axis];
            Some(begin + unit * self.scales[axis].place(number)?)
        };
        Some((at(0, x)?, at(1, y)?))
    }
}

/// Draws the axes; the result is their map and the area between them.
fn axes(plot: &Plot, marks: &mut Vec<Mark>) -> Result<(Axes, Area), Failure> {
    let scales = [plot.x.scale, plot.y.scale];
    let of_series = plot.series.iter().flat_map(|series| series.places.iter().copied());
    let places: Vec<PlotPoint> = of_series
        .chain(plot.front.iter().copied())
        .filter_map(|(x, y)| Some((scales[0].place(x)?, scales[1].place(y)?)))
        .collect();
    let [x, y] = [
        AxisScale::range(places.iter().map(|place| place.0)),
        AxisScale::range(places.iter().map(|place| place.1)),
    ];
    let shown = |scale: AxisScale, range: &std::ops::Range<f64>| axis::ShownRange {
        scale,
        range: range.clone(),
    };
    let mut drawn = vec![];
    let corners = {
        let area = Recorder::new(SIZE, &mut drawn).into_drawing_area();
        let mut chart = ChartBuilder::on(&area)
            .margin(8)
            .x_label_area_size(WORDS.0)
            .y_label_area_size(WORDS.1)
            .build_cartesian_2d(shown(scales[0], &x), shown(scales[1], &y))?;
        let font = || ("monospace", CAPITAL).into_font();
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(colour_of(Ink::Grid))
            .axis_style(colour_of(Ink::Axis).stroke_width(1))
            .label_style(font())
            .axis_desc_style(font())
            .x_desc(&plot.x.title)
            .y_desc(&plot.y.title)
            .draw()?;
        [chart.backend_coord(&(x.start, y.start)), chart.backend_coord(&(x.end, y.end))]
    };
    let shift = (MARGIN, MARGIN + LINE);
    marks.extend(drawn.into_iter().map(|mark| moved(mark, shift)));
    let [low, high] =
        corners.map(|(x, y)| (f64::from(x) + 0.5 + shift.0, f64::from(y) + 0.5 + shift.1));
    let line = |low: f64, high: f64, range: &std::ops::Range<f64>| {
        let unit = (high - low) / (range.end - range.start);
        (low - unit * range.start, unit)
    };
    let lines = [line(low.0, high.0, &x), line(low.1, high.1, &y)];
    Ok((Axes { scales, lines }, Area { left: low.0, top: high.1, right: high.0, bottom: low.1 }))
}

/// A mark of the axes, moved by (dx, dy).
fn moved(mark: Mark, (dx, dy): (f64, f64)) -> Mark {
    let to = |(x, y): Point| (x + dx, y + dy);
    match mark {
        Mark::Lines(ink, lines) => {
            Mark::Lines(ink, lines.into_iter().map(|(from, end)| (to(from), to(end))).collect())
        }
        Mark::Text(ink, place, words) => Mark::Text(ink, to(place), words),
        Mark::TextEnding(ink, place, words) => Mark::TextEnding(ink, to(place), words),
        Mark::TextCentred(ink, place, words) => Mark::TextCentred(ink, to(place), words),
        Mark::TextUpwards(ink, place, words) => Mark::TextUpwards(ink, to(place), words),
        // The recorder makes no others.
        other @ (Mark::Box(..) | Mark::Traces(..) | Mark::Areas(..) | Mark::Dots(..)) => other,
    }
}

/// Draws the front, the series and the labels.
fn draw(plot: &Plot, axes: &Axes, area: &Area, marks: &mut Vec<Mark>) {
    let points = |places: &[PlotPoint]| {
        places.iter().filter_map(|&place| axes.point(place)).collect::<Vec<Point>>()
    };
    let front = points(&plot.front);
    let mut drawn: Vec<Area> = samples(&front);
    marks.push(Mark::Traces(
        Ink::Front,
        vec![front].into_iter().filter(|line| line.len() > 1).collect(),
    ));
    let all: Vec<(&super::PlotSeries, Vec<Point>)> =
        plot.series.iter().map(|series| (series, points(&series.places))).collect();
    for (series, points) in
        all.iter().filter(|(series, points)| series.style != SeriesStyle::Dots && points.len() > 1)
    {
        marks.push(Mark::Traces(Ink::SeriesLine(series.colour), vec![points.clone()]));
        drawn.extend(samples(points));
    }
    for (series, points) in all.iter().filter(|(series, _)| series.style != SeriesStyle::Line) {
        marks.push(Mark::Dots(Ink::Series(series.colour), points.clone(), DOT));
        // A dot weighs more than a line.
        drawn.extend(points.iter().flat_map(|&point| [Area::about(point, DOT + 1.0); 3]));
    }
    write_labels(plot, axes, (area, &drawn), marks);
}

fn write_labels(plot: &Plot, axes: &Axes, (area, drawn): (&Area, &[Area]), marks: &mut Vec<Mark>) {
    let labels: Vec<(Point, &super::Label)> =
        plot.labels.iter().filter_map(|label| Some((axes.point(label.at)?, label))).collect();
    let asked: Vec<(Point, &str)> =
        labels.iter().map(|(point, label)| (*point, label.words.as_str())).collect();
    for ((_, label), place) in labels.iter().zip(placed(&asked, drawn, area)) {
        let Some(place) = place else { continue };
        marks.extend(place.leader.map(|leader| Mark::Lines(Ink::Axis, vec![leader])));
        marks.push(Mark::Text(Ink::Series(label.colour), place.begin, label.words.clone()));
    }
}

/// Squares along a line.
fn samples(points: &[Point]) -> Vec<Area> {
    let along = |ends: &[Point]| {
        let ((x0, y0), (x1, y1)) = (ends[0], ends[1]);
        let pieces = (libm::hypot(x1 - x0, y1 - y0) / SAMPLE).ceil().max(1.0) as u32;
        (0..=pieces).map(move |k| {
            let t = f64::from(k) / f64::from(pieces);
            Area::about((x0 + t * (x1 - x0), y0 + t * (y1 - y0)), 1.0)
        })
    };
    points.windows(2).flat_map(along).collect()
}
