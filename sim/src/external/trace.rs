//! Values of any signals that come back: a VCD that the simulator wrote.
//!
//! Bits that are X or Z are read as 0: a register whose pipeline is not filled yet holds X in a simulator with four values and 0 in
//! the others. Values that belong to a valid pixel are never X in a correct design.
use std::collections::HashMap;
use std::io::{BufReader, Read};
use std::ops::Range;

use specula_hdl::Design;
use specula_hdl::design::{NodeId, Op, wrapped};
use vcd::{Command, Header, IdCode, Parser, Value};

use super::batches::Batches;
use crate::{Columns, Flow, SimError};

/// When a clock's values stand in a trace: clock number r of the run at time `first` + r · `period`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// Time of the run's first clock.
    pub first: u64,
    /// Time from clock to clock.
    pub period: u64,
}

/// Reads the `watched` signals of `clocks` from the trace in which `root` names the scope of the core, and hands them to `sink` in
/// batches.
///
/// # Errors
/// [`SimError::File`] if the trace cannot be read, [`SimError::Untraced`] if `tool` left a signal out of it.
pub fn read_trace(
    file: impl Read,
    tool: &'static str,
    design: &Design,
    root: &[&str],
    watched: &[NodeId],
    (clocks, sampling): (Range<u64>, Sampling),
    sink: &mut dyn FnMut(&Columns) -> Flow,
) -> Result<(), SimError> {
    let mut parser = Parser::new(BufReader::new(file));
    let header = parser.parse_header().map_err(SimError::file("read a simulator's trace"))?;
    let mut signals = Signals::find(&header, tool, design, root, watched)?;
    let mut batches = Batches::new(watched, clocks.start, sink);
    for command in parser {
        match command.map_err(SimError::file("read a simulator's trace"))? {
            Command::Timestamp(time) => {
                let sampled = |clock: u64| sampling.first + (clock - clocks.start) * sampling.period;
                while batches.clock() < clocks.end && sampled(batches.clock()) < time {
                    if batches.push(signals.row()) == Flow::Stop {
                        return batches.finish(clocks.end, tool);
                    }
                }
            }
            Command::ChangeScalar(code, value) => signals.change(code, &[value]),
            Command::ChangeVector(code, bits) => signals.change(code, &bits),
            _ => {}
        }
    }
    // Behind the last change everything stays as it is.
    while batches.clock() < clocks.end && batches.push(signals.row()) == Flow::Continue {}
    batches.finish(clocks.end, tool)
}

/// The watched signals and what they are just now.
struct Signals {
    columns: HashMap<IdCode, Vec<usize>>,
    shapes: Vec<(u32, bool)>,
    values: Vec<i64>,
}

impl Signals {
    fn find(
        header: &Header,
        tool: &'static str,
        design: &Design,
        root: &[&str],
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
            let path: Vec<&str> = root.iter().copied().chain(path.into_iter().skip(1)).chain([about.name.as_str()]).collect();
            let variable = header.find_var(&path);
            let untraced = || SimError::Untraced { tool, signal: design.full_name(node) };
            signals.columns.entry(variable.ok_or_else(untraced)?.code).or_default().push(column);
        }
        Ok(signals)
    }

    /// Bits to the left of those that are written are 0, or X or Z, which counts as 0.
    fn change(&mut self, code: IdCode, bits: &[Value]) {
        let raw = bits.iter().fold(0, |raw, &bit| raw << 1 | i64::from(bit == Value::V1));
        for &column in self.columns.get(&code).map_or(&[][..], Vec::as_slice) {
            let (width, signed) = self.shapes[column];
            self.values[column] = wrapped(raw, width, signed);
        }
    }

    fn row(&self) -> impl Iterator<Item = i64> {
        self.values.iter().copied()
    }
}
