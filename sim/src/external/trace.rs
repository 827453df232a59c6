//! Values of any signals that come back: a VCD that the simulator wrote.
//!
//! Bits that are X or Z are read as 0: a register whose pipeline is not filled yet holds X in a
//! simulator with four values and 0 in the others. Values that belong to a valid pixel are never X
//! in a correct design.
use std::collections::HashMap;
use std::io::{BufReader, Read};
use std::ops::Range;

use specula_datapath::Design;
use specula_datapath::design::{NodeId, Op, wrapped};
use specula_datapath::verilog;
use vcd::{Command, Header, IdCode, Parser, Value};

use super::batches::Batches;
use crate::{Batch, Flow, SimError};

/// When a clock's values stand in a trace: clock number r of the run at time `first` + r ·
/// `period`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Time of the run's first clock.
    pub first: u64,
    /// Time from clock to clock.
    pub period: u64,
}

/// A trace that a simulator writes.
#[derive(Clone, Copy, Debug)]
pub struct Trace<'a> {
    /// The simulator.
    pub tool: &'static str,
    /// The scope of the core.
    pub root: &'a [&'a str],
    /// When values are read.
    pub sampling: Sampling,
}

impl Trace<'_> {
    /// Reads the `watched` signals of `clocks` and hands them to `sink` in batches.
    ///
    /// # Errors
    /// [`SimError::File`] if the trace cannot be read, [`SimError::Untraced`] if a signal is not in
    /// it.
    pub fn read(
        &self,
        file: impl Read,
        design: &Design,
        watched: &[NodeId],
        clocks: Range<u64>,
        sink: &mut dyn FnMut(&Batch) -> Flow,
    ) -> Result<(), SimError> {
        let unreadable = || SimError::file("read a simulator's trace");
        let mut parser = Parser::new(BufReader::new(file));
        let header = parser.parse_header().map_err(unreadable())?;
        let mut signals = self.signals(&header, design, watched)?;
        let mut batches = Batches::new(watched, clocks.start, sink);
        let mut last = 0;
        for command in parser {
            match command.map_err(unreadable())? {
                Command::Timestamp(time) => {
                    last = time;
                    let passed = clocks.start + self.clocks_before(time);
                    if signals.push(&mut batches, passed.min(clocks.end)) == Flow::Stop {
                        break;
                    }
                }
                Command::ChangeScalar(code, value) => signals.change(code, &[value]),
                Command::ChangeVector(code, bits) => signals.change(code, &bits),
                _ => {}
            }
        }
        let passed = clocks.start + self.clocks_before(last + 1);
        signals.push(&mut batches, passed.min(clocks.end));
        batches.finish(clocks.end, self.tool)
    }

    /// Number of clocks of the run whose values are read before `time`.
    fn clocks_before(&self, time: u64) -> u64 {
        time.saturating_sub(self.sampling.first).div_ceil(self.sampling.period)
    }

    fn signals(
        &self,
        header: &Header,
        design: &Design,
        watched: &[NodeId],
    ) -> Result<Signals, SimError> {
        let mut signals = Signals { columns: HashMap::new(), shapes: vec![], values: vec![] };
        let places = verilog::places(&design.to_block());
        for (column, &node) in watched.iter().enumerate() {
            let about = design.node(node);
            signals.shapes.push((about.width(), about.range.signed()));
            if let Op::Constant(value) = about.op {
                // A constant has no net.
                signals.values.push(value);
                continue;
            }
            signals.values.push(0);
            let untraced =
                || SimError::Untraced { tool: self.tool, signal: design.full_name(node) };
            let place = places.get(&node).ok_or_else(untraced)?;
            let inside = place.path.iter().chain([&place.net]).map(String::as_str);
            let path: Vec<&str> = self.root.iter().copied().chain(inside).collect();
            let variable = header.find_var(&path).ok_or_else(untraced)?;
            let bits = Bits { column, lowest: place.low_bit as usize };
            signals.columns.entry(variable.code).or_default().push(bits);
        }
        Ok(signals)
    }
}

/// The bits of a variable that are a watched signal.
struct Bits {
    /// The signal's column.
    column: usize,
    /// The lowest of the bits.
    lowest: usize,
}

/// The watched signals and what they are just now.
struct Signals {
    columns: HashMap<IdCode, Vec<Bits>>,
    shapes: Vec<(u32, bool)>,
    values: Vec<i64>,
}

impl Signals {
    /// Bits to the left of those that are written are 0, or X or Z, which counts as 0.
    fn change(&mut self, code: IdCode, bits: &[Value]) {
        for &Bits { column, lowest } in self.columns.get(&code).map_or(&[][..], Vec::as_slice) {
            let (width, signed) = self.shapes[column];
            let own = bits.iter().rev().skip(lowest).take(width as usize).rev();
            let raw = own.fold(0, |raw, &bit| raw << 1 | i64::from(bit == Value::V1));
            self.values[column] = wrapped(raw, width, signed);
        }
    }

    /// Adds rows up to the clock `end`.
    fn push(&self, batches: &mut Batches, end: u64) -> Flow {
        while batches.clock() < end {
            if batches.push(self.values.iter().copied()) == Flow::Stop {
                return Flow::Stop;
            }
        }
        Flow::Continue
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRACE: Trace = Trace {
        tool: "a simulator",
        root: &["TOP", "core"],
        sampling: Sampling { first: 6, period: 4 },
    };

    #[test]
    fn clocks_are_counted_by_the_time_at_which_they_are_read() {
        assert_eq!([0, 6, 7, 10, 11].map(|time| TRACE.clocks_before(time)), [0, 0, 1, 1, 2]);
    }

    #[test]
    fn unknown_bits_are_read_as_0() {
        let code = IdCode::FIRST;
        let whole = |column| Bits { column, lowest: 0 };
        let mut signals = Signals {
            columns: [(code, vec![whole(0), whole(1)])].into(),
            shapes: vec![(4, true), (4, false)],
            values: vec![0; 2],
        };
        signals.change(code, &[Value::V1, Value::X, Value::Z, Value::V1]);
        assert_eq!(signals.values, [-7, 9]);
        signals.change(code, &[Value::X]);
        assert_eq!(signals.values, [0, 0]);
    }

    #[test]
    fn stages_of_a_delay_line_are_bits_of_a_variable() {
        let code = IdCode::FIRST;
        let bits = (0..3).map(|column| Bits { column, lowest: 2 * column }).collect();
        let mut signals = Signals {
            columns: [(code, bits)].into(),
            shapes: vec![(2, false); 3],
            values: vec![0; 3],
        };
        let [zero, one] = [Value::V0, Value::V1];
        signals.change(code, &[one, zero, one, one, zero, one]);
        assert_eq!(signals.values, [1, 3, 2]);
        // Zeros on the left are not written.
        signals.change(code, &[one, one, zero]);
        assert_eq!(signals.values, [2, 1, 0]);
    }
}
