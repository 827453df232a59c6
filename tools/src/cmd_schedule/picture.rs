//! A schedule as a picture: a row for each clock, with bars for its longest path and its register
//! bits.
use specula_drawing::{CAPITAL, CHARACTER, Ink, Mark, Series, Sheet};

use super::contents::{CarriedFacts, Contents, StageFacts};
use super::text;

const MARGIN: f64 = 16.0;
/// Height of a row, and of its bars.
const ROW: f64 = 18.0;
const BAR: f64 = 12.0;
/// Width of the longest bar of each chart.
const CHART: f64 = 240.0;
/// Room for the number of a clock, and for the numbers behind bars.
const CLOCKS: f64 = 5.0 * CHARACTER;
const FIGURES: f64 = 9.0 * CHARACTER;

/// Kinds of register bits, in the order of their bars.
const BITS: [(&str, Series); 3] = [
    ("in blocks", Series::new(0)),
    ("flip-flops", Series::new(1)),
    ("in memories", Series::new(2)),
];

/// The picture.
pub fn sheet(contents: &Contents) -> Sheet {
    let picture = Picture::of(contents);
    let mut marks = picture.head(contents);
    for (row, stage) in contents.stages.iter().enumerate() {
        marks.extend(picture.row(picture.top + row as f64 * ROW, stage));
    }
    marks.extend(picture.period(contents));
    let longest = contents.stages.iter().map(text::operators_of).map(|words| words.chars().count());
    let words = longest.max().unwrap_or(0) as f64 * CHARACTER;
    let width = picture.words + words + MARGIN;
    let height = picture.top + contents.stages.len() as f64 * ROW + MARGIN;
    marks.insert(0, Mark::Box(Ink::Paper, (0.0, 0.0), (width, height)));
    Sheet { title: title(contents), size: (width, height), marks }
}

/// Where everything is, and how long bars are.
struct Picture {
    /// The top of the first row.
    top: f64,
    /// The left edges of paths, of register bits and of operators.
    paths: f64,
    bits: f64,
    words: f64,
    /// Pixels for a nanosecond, and for a bit.
    per_ns: f64,
    per_bit: f64,
}

impl Picture {
    fn of(contents: &Contents) -> Picture {
        let stages = &contents.stages;
        let ns = stages.iter().filter_map(|stage| Some(stage.longest_path.as_ref()?.ns));
        let longest = ns.chain(contents.period_ns).fold(0.0, f64::max);
        let most = stages.iter().map(|stage| stage.carried.total).max().unwrap_or(0).max(1);
        let paths = MARGIN + CLOCKS;
        let chart = if longest > 0.0 { CHART + FIGURES } else { 0.0 };
        let bits = paths + chart;
        Picture {
            top: MARGIN + 4.0 * ROW,
            paths,
            bits,
            words: bits + CHART + FIGURES,
            per_ns: if longest > 0.0 { CHART / longest } else { 0.0 },
            per_bit: CHART / most as f64,
        }
    }

    fn head(&self, contents: &Contents) -> Vec<Mark> {
        let line = |number: f64| MARGIN + number * ROW + CAPITAL;
        let mut marks = vec![Mark::Text(Ink::Title, (MARGIN, line(0.0)), title(contents))];
        let made_for = contents.made_for_in_words.clone().unwrap_or_default();
        marks.push(Mark::Text(Ink::Aside, (MARGIN, line(1.0)), made_for));
        let mut left = self.bits;
        for (name, series) in BITS {
            marks.push(Mark::Box(
                Ink::Series(series),
                (left, line(2.0) - CAPITAL),
                (CAPITAL, CAPITAL),
            ));
            let words = (left + 2.0 * CAPITAL, line(2.0));
            marks.push(Mark::Text(Ink::Aside, words, name.to_owned()));
            left += 2.0 * CAPITAL + (name.len() + 2) as f64 * CHARACTER;
        }
        let mut column = |left: f64, words: &str| {
            marks.push(Mark::Text(Ink::Unit, (left, line(3.0)), words.to_owned()));
        };
        column(MARGIN, "clock");
        if self.per_ns > 0.0 {
            column(self.paths, "longest path, ns");
        }
        column(self.bits, "register bits into the next clock");
        column(self.words, "operators");
        marks
    }

    fn row(&self, top: f64, stage: &StageFacts) -> Vec<Mark> {
        let base = top + (BAR + CAPITAL) / 2.0;
        let number = (self.paths - 2.0 * CHARACTER, base);
        let mut marks = vec![Mark::TextEnding(Ink::Name, number, stage.clock.to_string())];
        if let Some(path) = &stage.longest_path {
            let width = path.ns * self.per_ns;
            let ink = if path.slack_ns < 0.0 { Ink::Highlight } else { Ink::Cell };
            marks.push(Mark::Box(ink, (self.paths, top), (width, BAR)));
            let figure = (self.paths + width + CHARACTER / 2.0, base);
            marks.push(Mark::Text(Ink::Value, figure, format!("{:.2}", path.ns)));
        }
        let mut left = self.bits;
        for (bits, (_, series)) in in_order(&stage.carried).into_iter().zip(BITS) {
            let width = bits as f64 * self.per_bit;
            if bits > 0 {
                marks.push(Mark::Box(Ink::Series(series), (left, top), (width, BAR)));
            }
            left += width;
        }
        let figure = (left + CHARACTER / 2.0, base);
        marks.push(Mark::Text(Ink::Value, figure, stage.carried.total.to_string()));
        marks.push(Mark::Text(Ink::Aside, (self.words, base), text::operators_of(stage)));
        marks
    }

    /// The line at the end of the period.
    fn period(&self, contents: &Contents) -> Option<Mark> {
        let x = self.paths + contents.period_ns? * self.per_ns;
        let bottom = self.top + contents.stages.len() as f64 * ROW;
        Some(Mark::Lines(Ink::Axis, vec![((x, self.top - ROW / 4.0), (x, bottom))]))
    }
}

fn title(contents: &Contents) -> String {
    format!("{} by {}: {} clocks", contents.name, contents.method, contents.latency)
}

/// Register bits in the order of [`BITS`].
fn in_order(bits: &CarriedFacts) -> [u64; 3] {
    [bits.in_blocks, bits.flip_flops, bits.in_memories]
}
