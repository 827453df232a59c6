//! The values of a variable within a window, made from its signal's changes.
use std::ops::Range;
use std::rc::Rc;

use super::raw::{Change, Raw, STATES};
use super::value::Value;
use super::variables::{Kind, ValueNames, Variable};
use super::warnings::{clean, decoded};

/// A value and the time during which it holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// The time, in the file's units. An event has no length.
    pub time: Range<u64>,
    /// The value.
    pub value: Value,
}

/// Collects the changes of a variable's signal, in the order of the file.
pub struct Collector {
    kind: Kind,
    width: Option<u32>,
    names: Option<Rc<ValueNames>>,
    window: Range<u64>,
    segments: Vec<Segment>,
}

impl Collector {
    /// A collector of a variable's values in a window.
    pub fn new(variable: &Variable, window: &Range<u64>) -> Collector {
        let (kind, width, names) = (variable.kind, variable.width, variable.names.clone());
        Collector { kind, width, names, window: window.clone(), segments: vec![] }
    }

    /// Takes a change and returns by how many bytes the kept values have grown.
    pub fn take(&mut self, change: &Change) -> usize {
        if change.time >= self.window.end {
            return 0;
        }
        if self.kind == Kind::Event { self.event(change) } else { self.value(change) }
    }

    fn event(&mut self, change: &Change) -> usize {
        let happens = matches!(change.value, Raw::Bits([.., b'1']) | Raw::Text(_) | Raw::Real(_));
        let again = self.segments.last().is_some_and(|last| last.time.start >= change.time);
        if change.time < self.window.start || change.checkpoint || again || !happens {
            return 0;
        }
        self.segments
            .push(Segment { time: change.time..change.time, value: Value::Text(String::new()) });
        1
    }

    fn value(&mut self, change: &Change) -> usize {
        let value = self.understood(change.value);
        let begin = change.time.max(self.window.start);
        let length = value.length();
        match self.segments.last_mut() {
            // Later changes within one instant replace earlier ones. Times of a damaged file may go
            // back.
            Some(last) if last.time.start >= begin => {
                let before = std::mem::replace(&mut last.value, value);
                return length.saturating_sub(before.length());
            }
            // Some dumps repeat a value that has not changed.
            Some(last) if last.value == value => return 0,
            Some(last) => {
                last.time.end = begin;
                self.segments.push(Segment { time: begin..begin, value });
            }
            None => self.segments.push(Segment { time: begin..begin, value }),
        }
        length
    }

    /// The collected values; the last one holds until `end`, if that is within the window.
    pub fn finish(mut self, end: u64) -> Vec<Segment> {
        if let Some(last) = self.segments.last_mut().filter(|_| self.kind != Kind::Event) {
            last.time.end = end.min(self.window.end).max(last.time.start);
        }
        // Within one instant a value may have changed and changed back.
        self.segments.dedup_by(|next, before| {
            let same = self.kind != Kind::Event && next.value == before.value;
            if same {
                before.time.end = next.time.end;
            }
            same
        });
        self.segments
    }

    /// The number of values that are kept.
    pub fn count(&self) -> usize {
        self.segments.len()
    }

    fn understood(&self, raw: Raw) -> Value {
        match raw {
            Raw::Text(text) => Value::Text(clean(&decoded(text))),
            Raw::Real(number) => Value::real(number),
            Raw::Bits(bits) => {
                let bits = self.fitted(bits);
                match self.names.as_ref().and_then(|names| names.name(&bits)) {
                    Some(name) => Value::Text(name.to_owned()),
                    None => Value::Bits(bits),
                }
            }
        }
    }

    /// The bits, fitted to the variable's width: the lowest ones if there are more, and if there
    /// are fewer, extended as IEEE 1364 (18.2.2) says, by zeros or by the unknown state of the
    /// highest bit.
    fn fitted(&self, bits: &[u8]) -> String {
        let width = self.width.map_or(bits.len(), |width| width as usize);
        let bits = &bits[bits.len().saturating_sub(width)..];
        let state = |bit: &u8| {
            Some(bit.to_ascii_lowercase()).filter(|bit| STATES.contains(bit)).unwrap_or(b'x')
        };
        let above = match bits.first().map_or(b'x', state) {
            b'1' => b'0',
            other => other,
        };
        let missing = std::iter::repeat_n(above, width - bits.len());
        missing.chain(bits.iter().map(state)).map(char::from).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::variables::Scopes;
    use super::*;

    fn variable(kind: Kind, width: Option<u32>) -> Variable {
        let (name, range, names) = ("v".to_owned(), None, None);
        Variable { scope: Scopes::NONE, name, range, kind, width, port: false, signal: 0, names }
    }

    fn fitted(width: u32, bits: &str) -> String {
        Collector::new(&variable(Kind::Bits, Some(width)), &(0..1)).fitted(bits.as_bytes())
    }

    #[test]
    fn vectors_get_their_width() {
        let cases = [
            ("1", "00000001"),
            ("0", "00000000"),
            ("x", "xxxxxxxx"),
            ("z1", "zzzzzzz1"),
            ("u01", "uuuuuu01"),
            ("h1", "hhhhhhh1"),
            ("-", "--------"),
            ("UWLH", "uuuuuwlh"),
            ("", "xxxxxxxx"),
            ("010101010101", "01010101"),
            ("1q", "0000001x"),
        ];
        for (bits, expected) in cases {
            assert_eq!(fitted(8, bits), expected, "{bits}");
        }
    }

    #[test]
    fn windows_begin_with_the_value_that_holds_there() {
        let mut collector = Collector::new(&variable(Kind::Bits, Some(1)), &(10..20));
        for (time, bits) in [(0, b"0"), (5, b"1"), (12, b"0"), (12, b"1"), (15, b"0"), (30, b"1")] {
            collector.take(&Change { time, signal: 0, value: Raw::Bits(bits), checkpoint: false });
        }
        let segments: Vec<_> = collector
            .finish(100)
            .into_iter()
            .map(|segment| (segment.time, segment.value))
            .collect();
        let bits = |bits: &str| Value::Bits(bits.to_owned());
        assert_eq!(segments, [(10..15, bits("1")), (15..20, bits("0"))]);
    }

    #[test]
    fn events_happen_where_no_checkpoint_repeats_them() {
        let mut collector = Collector::new(&variable(Kind::Event, None), &(0..20));
        for (time, checkpoint) in [(0, true), (5, false), (5, false), (9, false), (12, true)] {
            collector.take(&Change { time, signal: 0, value: Raw::Bits(b"1"), checkpoint });
        }
        let times: Vec<_> = collector.finish(20).into_iter().map(|segment| segment.time).collect();
        assert_eq!(times, [5..5, 9..9]);
    }
}
