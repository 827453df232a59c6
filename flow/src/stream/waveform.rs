//! Values of signals clock by clock, and their drawing.
use specula_wave::{Axis, Figure, Group, Notation, Segment, Shape, SignalRow, Value};

/// Some signals during some clocks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Window {
    /// What it shows.
    pub title: String,
    /// The first clock, counted from that of the packet's first word.
    pub first: u32,
    /// The signals.
    pub rows: Vec<Row>,
}

/// A signal's values, one for each clock, sampled by the edge that ends it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Its name.
    pub signal: &'static str,
    /// Its width.
    pub bits: u32,
    /// Its values; `None` where it means nothing.
    pub values: Vec<Option<u64>>,
}

impl Window {
    /// Its drawing as SVG, a column for each clock.
    pub(super) fn svg(&self) -> String {
        specula_wave::svg(&self.figure(), None)
    }

    fn figure(&self) -> Figure {
        let clocks = self.rows.first().map_or(0, |row| row.values.len()) as u64;
        let first = u64::from(self.first);
        Figure {
            title: self.title.clone(),
            notes: vec!["Clocks are counted from the first word on.".to_owned()],
            axis: Axis {
                unit: "clock".to_owned(),
                begin: 0,
                step: 1,
                numbers: (first..first + clocks).collect(),
                marker: None,
            },
            groups: vec![Group {
                unit: "aclk".to_owned(),
                rows: self.rows.iter().map(Row::drawn).collect(),
            }],
        }
    }
}

impl Row {
    /// Its row of a drawing. A word lasts as long as it does not change; where the signal means
    /// nothing, nothing is drawn.
    fn drawn(&self) -> SignalRow {
        let mut segments: Vec<Segment> = vec![];
        for (clock, value) in (0..).zip(&self.values) {
            let Some(value) = value else { continue };
            let value = Value::Bits(format!("{value:0width$b}", width = self.bits as usize));
            match segments.last_mut() {
                Some(last) if last.value == value && last.time.end == clock => last.time.end += 1,
                _ => segments.push(Segment { time: clock..clock + 1, value }),
            }
        }
        let cells = || Shape::Cells {
            notation: Notation::Hexadecimal,
            format: Notation::Hexadecimal.label(self.bits),
        };
        SignalRow {
            name: self.signal.to_owned(),
            shape: if self.bits == 1 { Shape::Levels } else { cells() },
            segments,
            highlight: None,
        }
    }
}
