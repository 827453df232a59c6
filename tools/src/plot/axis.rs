//! An axis: its scale, its range and its ticks.
use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// An axis of a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What the axis measures, with the unit.
    pub title: String,
    /// How positions follow from numbers.
    pub scale: AxisScale,
}

/// The scale of an axis: how positions follow from numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisScale {
    /// Positions are proportional to numbers.
    Linear,
    /// Positions are proportional to the numbers' logarithms.
    Logarithmic,
}

/// A scale and the part of it that is shown, in units of positions.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownRange {
    /// How positions follow from numbers.
    pub scale: AxisScale,
    /// The positions shown.
    pub range: Range<f64>,
}

impl Ranged for ShownRange {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, place: &f64, (begin, end): (i32, i32)) -> i32 {
        let share = (place - self.range.start) / (self.range.end - self.range.start);
        begin + (share * f64::from(end - begin)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        if hint.weight().allow_light_points() { vec![] } else { self.scale.ticks(&self.range) }
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for ShownRange {
    fn format(place: &f64) -> String {
        place.to_string()
    }

    fn format_ext(&self, place: &f64) -> String {
        written(self.scale.number(*place))
    }
}

/// Largest number of ticks of an axis.
const MOST_TICKS: usize = 9;
/// Share of an axis that stays free at either end.
const FREE: f64 = 0.06;
/// Possible steps between ticks, up to a power of ten.
const STEPS: [f64; 4] = [1.0, 2.0, 5.0, 10.0];
/// Possible ticks within a decade, from many to few.
const DECADES: [&[f64]; 3] =
    [&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0], &[1.0, 2.0, 5.0], &[1.0]];

impl AxisScale {
    /// The position of a number, in units of the axis; `None` if it cannot be shown.
    pub fn place(self, number: f64) -> Option<f64> {
        let place = match self {
            AxisScale::Linear => number,
            AxisScale::Logarithmic if number > 0.0 => libm::log10(number),
            AxisScale::Logarithmic => return None,
        };
        place.is_finite().then_some(place)
    }

    /// The number at a position.
    pub fn number(self, place: f64) -> f64 {
        match self {
            AxisScale::Linear => place,
            AxisScale::Logarithmic => libm::pow(10.0, place),
        }
    }

    /// A range that holds all of `places`, with some room.
    pub fn range(places: impl Iterator<Item = f64> + Clone) -> Range<f64> {
        let (low, high) = (
            places.clone().fold(f64::INFINITY, f64::min),
            places.fold(f64::NEG_INFINITY, f64::max),
        );
        if low > high {
            return 0.0..1.0;
        }
        // A single position stands in the middle.
        let room = if high > low { FREE * (high - low) } else { 0.5 };
        low - room..high + room
    }

    /// The positions of ticks within a range.
    pub fn ticks(self, range: &Range<f64>) -> Vec<f64> {
        match self {
            AxisScale::Linear => linear(range),
            AxisScale::Logarithmic => {
                let [all, some, few] = DECADES.map(|digits| logarithmic(range, digits));
                let ticks =
                    [all, some].into_iter().find(|ticks| ticks.len() <= MOST_TICKS).unwrap_or(few);
                if ticks.len() > MOST_TICKS { thinned(&ticks) } else { ticks }
            }
        }
    }
}

fn linear(range: &Range<f64>) -> Vec<f64> {
    let least = (range.end - range.start) / MOST_TICKS as f64;
    let power = libm::pow(10.0, libm::floor(libm::log10(least)));
    let step =
        STEPS.iter().map(|step| step * power).find(|step| *step >= least).unwrap_or(10.0 * power);
    let first = (range.start / step).ceil() as i64;
    let last = (range.end / step).floor() as i64;
    (first..=last).map(|k| k as f64 * step).collect()
}

fn logarithmic(range: &Range<f64>, digits: &[f64]) -> Vec<f64> {
    let powers = range.start.floor() as i32..=range.end.floor() as i32;
    let places = powers
        .flat_map(|power| digits.iter().map(move |&digit| libm::log10(digit) + f64::from(power)));
    places.filter(|place| range.contains(place)).collect()
}

/// Every n-th tick, with n such that there are few enough.
fn thinned(ticks: &[f64]) -> Vec<f64> {
    ticks.iter().copied().step_by(ticks.len().div_ceil(MOST_TICKS)).collect()
}

/// A tick's number with up to four digits, without zeros at the end.
pub fn written(number: f64) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    let digits_left = libm::floor(libm::log10(number.abs()) + 1e-9) as i32;
    let decimals = (3 - digits_left).clamp(0, 9) as usize;
    let text = format!("{number:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}
