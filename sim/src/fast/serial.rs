//! What is evaluated lane after lane: feedback, and tables.
use std::sync::Arc;

use specula_datapath::design::{NodeId, Op, Table, wrapped};
use specula_kernels::{Lane, accumulate, hold, look_up};

use super::memory::{Column, Memory, Place};
use super::step::{Read, narrow, wide};

/// A column with a serial kernel.
#[derive(Clone)]
pub enum Serial {
    /// An accumulator.
    Accumulate(Accumulator),
    /// A register with an enable.
    Hold(Holder),
    /// A table.
    LookUp(Arc<[i64]>, Read),
}

/// value = first ? start : state, then state ← value + step, wrapped.
#[derive(Clone)]
pub struct Accumulator {
    pub first: Read,
    pub start: Read,
    pub step: Read,
    pub width: u32,
    pub signed: bool,
    pub state: i64,
}

/// state ← enable ? value : state.
#[derive(Clone)]
pub struct Holder {
    pub enable: Read,
    pub value: Read,
    pub state: i64,
}

/// A signal of a component.
#[derive(Clone)]
pub struct Member {
    /// Its column.
    pub out: Place,
    /// Its operator; operands are numbers of `reads`.
    pub op: Op,
    pub reads: Vec<Read>,
    pub width: u32,
    pub signed: bool,
    pub tables: Arc<[Table]>,
}

/// Runs `$body` with `$lanes` bound to the lanes of a column of either width.
macro_rules! with_lanes {
    ($memory:expr, $read:expr, $clocks:expr, $lanes:ident => $body:expr) => {
        if $read.place.wide {
            let $lanes = wide($memory, $read, $clocks);
            $body
        } else {
            let $lanes = narrow($memory, $read, $clocks);
            $body
        }
    };
}

impl Serial {
    /// Evaluates lanes `from..clocks` of this batch.
    pub fn run<L: Lane>(
        &mut self,
        memory: &Memory,
        out: &mut Column<L>,
        from: usize,
        clocks: usize,
    ) {
        let out = out.write(from, clocks);
        match self {
            Serial::Accumulate(accumulator) => accumulator.run(memory, out, from, clocks),
            Serial::Hold(holder) => holder.run(memory, out, from, clocks),
            Serial::LookUp(table, address) => {
                look_up(out, &narrow(memory, *address, clocks)[from..], table)
            }
        }
    }
}

impl Accumulator {
    fn run<L: Lane>(&mut self, memory: &Memory, out: &mut [L], from: usize, clocks: usize) {
        let first = &narrow(memory, self.first, clocks)[from..];
        let (width, signed) = (self.width, self.signed);
        let wrap = |raw: i64| wrapped(raw, width, signed);
        let state = &mut self.state;
        with_lanes!(memory, self.start, clocks, start => with_lanes!(memory, self.step, clocks, step => {
            accumulate(out, first, &start[from..], &step[from..], state, wrap)
        }))
    }
}

impl Holder {
    fn run<L: Lane>(&mut self, memory: &Memory, out: &mut [L], from: usize, clocks: usize) {
        let enable = &narrow(memory, self.enable, clocks)[from..];
        let state = &mut self.state;
        with_lanes!(memory, self.value, clocks, value => hold(out, enable, &value[from..], state))
    }
}

impl Member {
    /// Evaluates one lane.
    pub fn evaluate(&self, memory: &mut Memory, at: usize) {
        let value = |operand: NodeId| {
            let read = self.reads[operand.0 as usize];
            memory.lane(read.place, at as isize - read.back as isize)
        };
        let raw = self.op.evaluate(&self.tables, value);
        memory.set_lane(self.out, at, wrapped(raw, self.width, self.signed));
    }
}
