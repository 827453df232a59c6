//! What is evaluated lane after lane: feedback, and tables.
use std::sync::Arc;

use specula_datapath::design::{NodeId, Op, Table, wrapped};
use specula_kernels::{Lane, accumulate, accumulate_in_turn, hold, look_up};

use super::memory::{Column, Memory, Place};
use super::read::{Read, narrow, wide};

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

/// value = first ? start : state, then state ← valid ? value + step : state, wrapped.
#[derive(Clone)]
pub struct Accumulator {
    pub valid: Read,
    pub first: Read,
    pub start: Read,
    pub step: Read,
    pub width: u32,
    pub signed: bool,
    /// What the registers hold, the oldest first.
    pub states: Vec<i64>,
}

/// state ← enable ? value : state, wrapped.
#[derive(Clone)]
pub struct Holder {
    pub enable: Read,
    pub value: Read,
    pub width: u32,
    pub signed: bool,
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
    /// Where every lane has a pixel, as in most batches, none has to be asked whether it counts.
    fn run<L: Lane>(&mut self, memory: &Memory, out: &mut [L], from: usize, clocks: usize) {
        let valid = &narrow(memory, self.valid, clocks)[from..clocks];
        // Bit by bit, so that it takes no branch.
        if valid.iter().fold(1, |all, bit| all & bit) == 1 {
            self.run_enabled(memory, out, from, clocks, |_| true);
        } else {
            self.run_enabled(memory, out, from, clocks, |lane| valid[lane] != 0);
        }
    }

    fn run_enabled<L: Lane>(
        &mut self,
        memory: &Memory,
        out: &mut [L],
        from: usize,
        clocks: usize,
        enabled: impl Fn(usize) -> bool,
    ) {
        let first = &narrow(memory, self.first, clocks)[from..];
        let (width, signed) = (self.width, self.signed);
        let wrap = |raw: i64| wrapped(raw, width, signed);
        let states = &mut self.states[..];
        with_lanes!(memory, self.start, clocks, start => with_lanes!(memory, self.step, clocks, step => {
            let operands = (&start[from..], &step[from..]);
            match states {
                [state] => accumulate(out, first, operands, state, enabled, wrap),
                states => accumulate_in_turn(out, first, operands, states, enabled, wrap),
            }
        }))
    }
}

impl Holder {
    fn run<L: Lane>(&mut self, memory: &Memory, out: &mut [L], from: usize, clocks: usize) {
        let enable = &narrow(memory, self.enable, clocks)[from..];
        let (width, signed) = (self.width, self.signed);
        let wrap = |raw: i64| wrapped(raw, width, signed);
        let state = &mut self.state;
        with_lanes!(memory, self.value, clocks, value => {
            hold(out, enable, &value[from..], state, wrap)
        })
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
