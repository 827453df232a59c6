//! Renders a figure as a sheet: shapes and text with their positions in pixels.
use super::figure::{Axis, Figure, Shape, SignalRow};
use super::layout::{Layout, MARGIN, ROW, SLANT};
use super::segments::Segment;
use super::value::Value;
use specula_drawing::{CAPITAL, CHARACTER, Ink, Mark, Point, Sheet};

/// Distance between the low and the high level of a row.
const WAVE: f64 = 15.0;

/// Renders a figure, `width` pixels wide if that is given.
pub fn render(figure: &Figure, width: Option<u32>) -> Sheet {
    let layout = Layout::new(figure, width);
    let mut pen = Pen { layout: &layout, marks: vec![] };
    pen.columns(&figure.axis);
    pen.words(Ink::Title, (MARGIN, MARGIN + CAPITAL), &figure.title);
    let mut top = layout.top;
    for group in &figure.groups {
        pen.unit(top, &group.unit);
        top += ROW;
        for row in &group.rows {
            pen.row(top, row, figure);
            top += ROW;
        }
    }
    top += MARGIN / 2.0;
    for note in &figure.notes {
        pen.words(Ink::Aside, (MARGIN, top + CAPITAL), note);
        top += ROW;
    }
    Sheet { title: figure.title.clone(), size: (layout.width, layout.height), marks: pen.marks }
}

/// The rectangle that a value takes in its row.
struct ValueBox {
    from: f64,
    to: f64,
    /// Top and bottom of the rectangle.
    high: f64,
    low: f64,
}

/// A value and its rectangle.
type Piece<'a> = (ValueBox, &'a Segment);

struct Pen<'a> {
    layout: &'a Layout,
    marks: Vec<Mark>,
}

impl Pen<'_> {
    fn words(&mut self, ink: Ink, place: Point, text: &str) {
        self.marks.push(Mark::Text(ink, place, text.to_owned()));
    }

    /// Draws the borders of columns, their numbers, and the marker.
    fn columns(&mut self, axis: &Axis) {
        let layout = self.layout;
        let base = layout.top - ROW / 2.0;
        let border = |column: usize| {
            (
                (layout.x(column as f64), base + CAPITAL / 2.0),
                (layout.x(column as f64), layout.bottom),
            )
        };
        if let Some(marker) = &axis.marker {
            self.marker(axis.place(marker.start), axis.place(marker.end));
        }
        self.marks.push(Mark::Lines(Ink::Grid, (0..=layout.columns).map(border).collect()));
        self.words(Ink::Aside, (MARGIN, base), &axis.unit);
        let widest = axis.numbers.last().map_or(1, |number| number.to_string().len() + 1);
        let every = (CHARACTER * widest as f64 / layout.column).ceil().max(1.0) as usize;
        let is_marked = |column: usize| {
            axis.marker.as_ref().is_some_and(|marker| axis.place(marker.start) == column as f64)
        };
        for (column, number) in axis
            .numbers
            .iter()
            .enumerate()
            .filter(|(column, _)| column % every == 0 || is_marked(*column))
        {
            let ink = if is_marked(column) { Ink::MarkerNumber } else { Ink::Aside };
            self.words(ink, (layout.x(column as f64) + SLANT, base), &number.to_string());
        }
    }

    fn marker(&mut self, from: f64, to: f64) {
        let layout = self.layout;
        let (from, to) = (layout.x(from), layout.x(to).max(layout.x(from) + SLANT / 2.0));
        if from < layout.right() && to > layout.left {
            let (from, to, top) = (
                from.max(layout.left),
                to.min(layout.right()),
                layout.top - ROW / 2.0 - CAPITAL - SLANT,
            );
            self.marks.push(Mark::Box(Ink::Marker, (from, top), (to - from, layout.bottom - top)));
        }
    }

    fn unit(&mut self, top: f64, name: &str) {
        let base = top + (ROW + CAPITAL) / 2.0;
        self.words(Ink::Unit, (MARGIN, base), name);
    }

    fn row(&mut self, top: f64, row: &SignalRow, figure: &Figure) {
        let layout = self.layout;
        let base = top + (ROW + CAPITAL) / 2.0;
        self.words(Ink::Name, (MARGIN + CHARACTER, base), &row.name);
        if !row.format().is_empty() {
            self.marks.push(Mark::TextEnding(
                Ink::Aside,
                (layout.left - 2.0 * SLANT, base),
                row.format().to_owned(),
            ));
        }
        let (high, low) = (top + (ROW - WAVE) / 2.0, top + (ROW + WAVE) / 2.0);
        let clamp = |time| layout.x(figure.axis.place(time)).clamp(layout.left, layout.right());
        let extent = |segment: &Segment| ValueBox {
            from: clamp(segment.time.start),
            to: clamp(segment.time.end),
            high,
            low,
        };
        let pieces: Vec<Piece> =
            row.segments.iter().map(|segment| (extent(segment), segment)).collect();
        let highlight = row.highlight.as_ref().map(|time| ValueBox {
            from: clamp(time.start),
            to: clamp(time.end),
            high,
            low,
        });
        let highlight = highlight.filter(|place| place.to > place.from);
        match row.shape {
            Shape::Levels => self.levels(&pieces, highlight.as_ref()),
            Shape::Events => self.events(&pieces),
            Shape::Cells { .. } => self.cells(row, &pieces, highlight.as_ref()),
        }
    }

    /// Draws a bit: a line with steps, broken where the bit is unknown.
    fn levels(&mut self, pieces: &[Piece], highlight: Option<&ValueBox>) {
        let mut traces: Vec<Vec<Point>> = vec![];
        let mut unknown = vec![];
        let mut connected = false;
        for (place, segment) in pieces {
            let Some(y) = level_height(place, &segment.value) else {
                unknown.push(hexagon(place));
                connected = false;
                continue;
            };
            match traces.last_mut() {
                Some(trace) if connected => {
                    trace.push((place.from + SLANT.min(place.to - place.from), y))
                }
                _ => traces.push(vec![(place.from, y)]),
            }
            traces.last_mut().into_iter().for_each(|trace| trace.push((place.to, y)));
            connected = true;
        }
        let high = pieces
            .iter()
            .filter(|(place, segment)| level_height(place, &segment.value) == Some(place.high));
        self.marks.push(Mark::Areas(Ink::High, high.map(|(place, _)| area_below(place)).collect()));
        self.marks.push(Mark::Areas(Ink::Highlight, highlight.into_iter().map(hexagon).collect()));
        self.marks.push(Mark::Areas(Ink::Unknown, unknown));
        self.marks.push(Mark::Traces(Ink::Level, traces));
        // The colour shows an x; VHDL has more states, which are shown as letters.
        for (place, segment) in
            pieces.iter().filter(|(place, _)| place.to - place.from >= CHARACTER + 2.0 * SLANT)
        {
            if let Some(letter) = letter(&segment.value) {
                self.marks.push(Mark::TextCentred(
                    Ink::Value,
                    text_position(place),
                    letter.to_owned(),
                ));
            }
        }
    }

    /// Draws an arrow for each event.
    fn events(&mut self, pieces: &[Piece]) {
        let arrow = |(place, _): &Piece| {
            let (x, neck) = (place.from, place.high + 2.0 * SLANT);
            [
                vec![(x, place.low), (x, place.high)],
                vec![(x - SLANT, neck), (x, place.high), (x + SLANT, neck)],
            ]
        };
        self.marks.push(Mark::Traces(Ink::Level, pieces.iter().flat_map(arrow).collect()));
    }

    /// Draws values in cells with pointed ends; a value is written if it fits.
    fn cells(&mut self, row: &SignalRow, pieces: &[Piece], highlight: Option<&ValueBox>) {
        for ink in [Ink::Cell, Ink::Unknown] {
            let these = pieces.iter().filter(|(_, segment)| cell_ink(&segment.value) == ink);
            self.marks.push(Mark::Areas(ink, these.map(|(place, _)| hexagon(place)).collect()));
        }
        self.marks.push(Mark::Areas(Ink::Highlight, highlight.into_iter().map(hexagon).collect()));
        for (place, segment) in pieces {
            match highlight
                .filter(|highlight| highlight.from < place.to && place.from < highlight.to)
            {
                Some(highlight) => self.value(Ink::HighlightValue, highlight, row, segment),
                None => self.value(Ink::Value, place, row, segment),
            }
        }
    }

    /// Writes a value in the middle of its cell if it fits, and at least the beginning of a text.
    fn value(&mut self, ink: Ink, place: &ValueBox, row: &SignalRow, segment: &Segment) {
        let room = ((place.to - place.from - 2.0 * SLANT) / CHARACTER).max(0.0) as usize;
        if let Some(text) = row.written_or_begun(&segment.value, room) {
            self.marks.push(Mark::TextCentred(ink, text_position(place), text));
        }
    }
}

/// The point of the base line at which text in the middle of a cell is centred.
fn text_position(place: &ValueBox) -> Point {
    ((place.from + place.to) / 2.0, (place.high + place.low + CAPITAL) / 2.0)
}

/// The letter of a state that Verilog does not have.
fn letter(value: &Value) -> Option<&str> {
    match value {
        Value::Bits(bits) if matches!(bits.as_str(), "u" | "w" | "l" | "h" | "-") => Some(bits),
        _ => None,
    }
}

/// The height of a bit's line; `None` if the bit is unknown.
fn level_height(place: &ValueBox, value: &Value) -> Option<f64> {
    match value {
        // Weak states of VHDL are drawn as low and as high as strong ones.
        Value::Bits(bits) if bits == "0" || bits == "l" => Some(place.low),
        Value::Bits(bits) if bits == "1" || bits == "h" => Some(place.high),
        Value::Bits(bits) if bits == "z" => Some((place.high + place.low) / 2.0),
        _ => None,
    }
}

fn cell_ink(value: &Value) -> Ink {
    match value {
        Value::Bits(bits) if !bits.bytes().all(|bit| matches!(bit, b'0' | b'1')) => Ink::Unknown,
        _ => Ink::Cell,
    }
}

/// The outline of the area below a bit's line.
fn area_below(place: &ValueBox) -> Vec<Point> {
    let ValueBox { from, to, high, low } = *place;
    vec![(from, low), (from + SLANT.min(to - from), high), (to, high), (to, low)]
}

/// The outline of a cell with pointed ends.
fn hexagon(place: &ValueBox) -> Vec<Point> {
    let ValueBox { from, to, high, low } = *place;
    let (slant, middle) = (SLANT.min((to - from) / 2.0), (high + low) / 2.0);
    vec![
        (from, middle),
        (from + slant, high),
        (to - slant, high),
        (to, middle),
        (to - slant, low),
        (from + slant, low),
    ]
}
