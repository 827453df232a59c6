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
        for (column, &node) in watched.iter().enumerate() {
            let about = design.node(node);
            signals.shapes.push((about.width(), about.range.signed()));
            if let Op::Constant(value) = about.op {
                // A constant has no net.
                signals.values.push(value);
                continue;
            }
            signals.values.push(0);
            let path = design.path(about.scope);
            let path: Vec<&str> = self
                .root
                .iter()
                .copied()
                .chain(path.into_iter().skip(1))
                .chain([about.name.as_str()])
                .collect();
            let variable = header.find_var(&path);
            let untraced =
                || SimError::Untraced { tool: self.tool, signal: design.full_name(node) };
            signals.columns.entry(variable.ok_or_else(untraced)?.code).or_default().push(column);
        }
        Ok(signals)
    }
}

/// The watched signals and what they are just now.
struct Signals {
    columns: HashMap<IdCode, Vec<usize>>,
    shapes: Vec<(u32, bool)>,
    values: Vec<i64>,
}

impl Signals {
    /// Bits to the left of those that are written are 0, or X or Z, which counts as 0.
    fn change(&mut self, code: IdCode, bits: &[Value]) {
        let raw = bits.iter().fold(0, |raw, &bit| raw << 1 | i64::from(bit == Value::V1));
        for &column in self.columns.get(&code).map_or(&[][..], Vec::as_slice) {
            let (width, signed) = self.shapes[column];
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
        let mut signals = Signals {
            columns: [(code, vec![0, 1])].into(),
            shapes: vec![(4, true), (4, false)],
            values: vec![0; 2],
        };
        signals.change(code, &[Value::V1, Value::X, Value::Z, Value::V1]);
        assert_eq!(signals.values, [-7, 9]);
        signals.change(code, &[Value::X]);
        assert_eq!(signals.values, [0, 0]);
    }
}
