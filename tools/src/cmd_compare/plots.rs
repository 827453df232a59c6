//! Plots of error against size and against run time.
use specula_experiments::pareto_front;
use specula_experiments::tradeoff::Formats;
use specula_spec::Method;

use super::result::{Compared, Core, size};
use crate::plot::{Axis, AxisScale, Label, Plot, PlotPoint, PlotSeries, SeriesStyle};
use specula_drawing::{SERIES, Series};

/// A plot: the stem of its file name, its title, and its axes and series.
pub struct TradeoffPlot {
    /// Stem of the file name.
    pub file: &'static str,
    /// Title of the plot.
    pub title: &'static str,
    x: (&'static str, AxisScale),
    series: fn(&Compared) -> Vec<LabelledSeries>,
    notes: &'static [&'static str],
}

/// The points of one colour, each with its label.
struct LabelledSeries {
    colour: Series,
    places: Vec<(PlotPoint, String)>,
    style: SeriesStyle,
    /// The point whose label describes the whole series best.
    main: usize,
}

/// All plots of a comparison.
pub const PLOTS: [TradeoffPlot; 3] = [
    TradeoffPlot {
        file: "error-size",
        title: "Error against size of the core",
        x: ("full adders of its multipliers and adders", AxisScale::Logarithmic),
        series: |compared| core_series(compared, size),
        notes: &FORMATS,
    },
    TradeoffPlot {
        file: "error-time",
        title: "Error against run time in hardware",
        x: ("ns a pixel, set-up counted", AxisScale::Linear),
        series: |compared| core_series(compared, Core::pixel_ns),
        notes: &FORMATS,
    },
    TradeoffPlot {
        file: "error-software",
        title: "Error against run time in software",
        x: ("ns a pixel, set-up counted", AxisScale::Logarithmic),
        series: software_series,
        notes: &[
            "A dot is one of the papers' loops in f32, on one thread, not rounded to 8 bits. Errors below 0.001 stand at 0.001.",
        ],
    },
];

const FORMATS: [&str; 2] = [
    "A colour is a method. Its dots are formats: so many fraction bits fewer or more than default.",
    "Rounding to 8 bits alone is an error of 0.29 LSB rms.",
];

const BAND: &str = "Band: the Pareto front. Nothing that costs as little has less error.";

/// Smallest error that a plot shows, in LSBs: f32's rounding errors are below it and do not matter
/// to an 8-bit picture.
const LEAST: f64 = 1e-3;

impl TradeoffPlot {
    /// The names of its SVG and PNG files.
    pub fn names(&self) -> [String; 2] {
        ["svg", "png"].map(|ending| format!("{}.{ending}", self.file))
    }

    /// Whether there are points to draw.
    pub fn has_places(&self, compared: &Compared) -> bool {
        (self.series)(compared).iter().any(|named| !named.places.is_empty())
    }

    /// Makes the plot from the results.
    pub fn plot(&self, compared: &Compared) -> Plot {
        let all = (self.series)(compared);
        let axis = |(title, scale): (&str, AxisScale)| Axis { title: title.to_owned(), scale };
        let front = front(&all);
        Plot {
            title: format!(
                "{}: {}, {} x {}",
                self.title, compared.scene, compared.size.0, compared.size.1
            ),
            x: axis(self.x),
            y: axis(("rms error against exact shading in LSB", AxisScale::Logarithmic)),
            series: all.iter().map(series).collect(),
            labels: labels(&all, &front),
            front: front.into_iter().map(|(series, place)| all[series].places[place].0).collect(),
            notes: self.notes.iter().copied().chain([BAND]).map(str::to_owned).collect(),
        }
    }
}

fn series(named: &LabelledSeries) -> PlotSeries {
    PlotSeries {
        colour: named.colour,
        places: named.places.iter().map(|(place, _)| *place).collect(),
        style: named.style,
    }
}

/// The front, from left to right: the number of a series, and of a point in it.
fn front(all: &[LabelledSeries]) -> Vec<(usize, usize)> {
    let numbers: Vec<(usize, usize)> = all
        .iter()
        .enumerate()
        .flat_map(|(series, named)| (0..named.places.len()).map(move |place| (series, place)))
        .collect();
    let places: Vec<PlotPoint> =
        numbers.iter().map(|&(series, place)| all[series].places[place].0).collect();
    pareto_front(&places).into_iter().map(|number| numbers[number]).collect()
}

/// Labels where each series enters the front, and at the main point of every series that is not on
/// it.
fn labels(all: &[LabelledSeries], front: &[(usize, usize)]) -> Vec<Label> {
    let entries = front.iter().enumerate().filter(|(number, (series, _))| {
        !front[..*number].iter().any(|(before, _)| before == series)
    });
    let others =
        (0..all.len()).filter(|series| !front.iter().any(|(of_front, _)| of_front == series));
    let shown =
        entries.map(|(_, entry)| *entry).chain(others.map(|series| (series, all[series].main)));
    let label = |(series, place): (usize, usize)| {
        let named = &all[series];
        named.places.get(place).map(|(at, words)| Label {
            at: *at,
            words: words.clone(),
            colour: named.colour,
        })
    };
    shown.filter_map(label).collect()
}

/// A series for each method, from its narrowest formats to its widest.
fn core_series(compared: &Compared, cost: fn(&Core) -> f64) -> Vec<LabelledSeries> {
    let of_method = |(number, method): (usize, Method)| {
        let cores: Vec<&Core> =
            compared.cores.iter().filter(|core| core.configuration.method == method).collect();
        let words = |core: &&Core| match core.configuration.formats {
            Formats::DEFAULT => method.name().to_owned(),
            _ => core.configuration.to_string(),
        };
        LabelledSeries {
            colour: Series::new(number),
            main: cores
                .iter()
                .position(|core| core.configuration.formats == Formats::DEFAULT)
                .unwrap_or(0),
            places: cores.iter().map(|core| ((cost(core), core.error()), words(core))).collect(),
            style: SeriesStyle::LineWithDots,
        }
    };
    Method::ALL
        .into_iter()
        .enumerate()
        .map(of_method)
        .filter(|named| !named.places.is_empty())
        .collect()
}

/// A series for each loop, in the colour of the method with whose name the loop's name begins.
fn software_series(compared: &Compared) -> Vec<LabelledSeries> {
    let colour = |name: &str| {
        Method::ALL
            .iter()
            .position(|method| name.starts_with(method.name()))
            .unwrap_or(usize::from(SERIES) - 1)
    };
    let named = |software: &specula_experiments::tradeoff::software::Software| LabelledSeries {
        colour: Series::new(colour(software.name)),
        places: vec![(
            (software.total_ns, software.error.rms_lsb.max(LEAST)),
            software.name.to_owned(),
        )],
        style: SeriesStyle::Dots,
        main: 0,
    };
    compared.software.iter().map(named).collect()
}
