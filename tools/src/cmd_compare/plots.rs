//! Error against size and against run time.
use specula_experiments::pareto_front;
use specula_experiments::tradeoff::Formats;
use specula_spec::Method;

use super::result::{Compared, Core, size};
use crate::plot::{Axis, Label, Place, Plot, PlotSeries, Scale, Shown};
use specula_drawing::{SERIES, Series};

/// A plot: its file without an ending, what it shows, and what is drawn.
pub struct Subject {
    /// The file's stem.
    pub file: &'static str,
    /// What it shows.
    pub title: &'static str,
    x: (&'static str, Scale),
    series: fn(&Compared) -> Vec<Named>,
    notes: &'static [&'static str],
}

/// Places of one colour, each with the words for it.
struct Named {
    colour: Series,
    places: Vec<(Place, String)>,
    shown: Shown,
    /// Which of them says best what all are.
    main: usize,
}

/// The plots there are.
pub const SUBJECTS: [Subject; 3] = [
    Subject {
        file: "error-size",
        title: "Error against size of the core",
        x: ("full adders of its multipliers and adders", Scale::Logarithmic),
        series: |compared| of_cores(compared, size),
        notes: &FORMATS,
    },
    Subject {
        file: "error-time",
        title: "Error against run time in hardware",
        x: ("ns a pixel, set-up counted", Scale::Linear),
        series: |compared| of_cores(compared, Core::pixel_ns),
        notes: &FORMATS,
    },
    Subject {
        file: "error-software",
        title: "Error against run time in software",
        x: ("ns a pixel, set-up counted", Scale::Logarithmic),
        series: of_software,
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

/// Differences below this do not show, in LSBs: what f32 is off by is of no use to an 8-bit
/// picture.
const LEAST: f64 = 1e-3;

impl Subject {
    /// Its SVG and its PNG.
    pub fn names(&self) -> [String; 2] {
        ["svg", "png"].map(|ending| format!("{}.{ending}", self.file))
    }

    /// Whether there is anything to draw.
    pub fn has_places(&self, compared: &Compared) -> bool {
        (self.series)(compared).iter().any(|named| !named.places.is_empty())
    }

    /// The plot.
    pub fn plot(&self, compared: &Compared) -> Plot {
        let all = (self.series)(compared);
        let axis = |(title, scale): (&str, Scale)| Axis { title: title.to_owned(), scale };
        let front = front(&all);
        Plot {
            title: format!(
                "{}: {}, {} x {}",
                self.title, compared.scene, compared.size.0, compared.size.1
            ),
            x: axis(self.x),
            y: axis(("rms error against exact shading in LSB", Scale::Logarithmic)),
            series: all.iter().map(series).collect(),
            labels: labels(&all, &front),
            front: front.into_iter().map(|(series, place)| all[series].places[place].0).collect(),
            notes: self.notes.iter().copied().chain([BAND]).map(str::to_owned).collect(),
        }
    }
}

fn series(named: &Named) -> PlotSeries {
    PlotSeries {
        colour: named.colour,
        places: named.places.iter().map(|(place, _)| *place).collect(),
        shown: named.shown,
    }
}

/// The front: numbers of series and of places in them, from left to right.
fn front(all: &[Named]) -> Vec<(usize, usize)> {
    let numbers: Vec<(usize, usize)> = all
        .iter()
        .enumerate()
        .flat_map(|(series, named)| (0..named.places.len()).map(move |place| (series, place)))
        .collect();
    let places: Vec<Place> =
        numbers.iter().map(|&(series, place)| all[series].places[place].0).collect();
    pareto_front(&places).into_iter().map(|number| numbers[number]).collect()
}

/// Words for where each series enters the front, and for the main place of every series that is not
/// on it.
fn labels(all: &[Named], front: &[(usize, usize)]) -> Vec<Label> {
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
fn of_cores(compared: &Compared, cost: fn(&Core) -> f64) -> Vec<Named> {
    let of_method = |(number, method): (usize, Method)| {
        let cores: Vec<&Core> =
            compared.cores.iter().filter(|core| core.configuration.method == method).collect();
        let words = |core: &&Core| match core.configuration.formats {
            Formats::DEFAULT => method.name().to_owned(),
            _ => core.configuration.to_string(),
        };
        Named {
            colour: Series::new(number),
            main: cores
                .iter()
                .position(|core| core.configuration.formats == Formats::DEFAULT)
                .unwrap_or(0),
            places: cores.iter().map(|core| ((cost(core), core.error()), words(core))).collect(),
            shown: Shown::LineWithDots,
        }
    };
    Method::ALL
        .into_iter()
        .enumerate()
        .map(of_method)
        .filter(|named| !named.places.is_empty())
        .collect()
}

/// A series for each loop, in the colour of the method whose name its own begins with.
fn of_software(compared: &Compared) -> Vec<Named> {
    let colour = |name: &str| {
        Method::ALL
            .iter()
            .position(|method| name.starts_with(method.name()))
            .unwrap_or(usize::from(SERIES) - 1)
    };
    let named = |software: &specula_experiments::tradeoff::software::Software| Named {
        colour: Series::new(colour(software.name)),
        places: vec![(
            (software.total_ns, software.error.rms_lsb.max(LEAST)),
            software.name.to_owned(),
        )],
        shown: Shown::Dots,
        main: 0,
    };
    compared.software.iter().map(named).collect()
}
