//! One step of a batch: a kernel with the columns it reads and writes.
use std::sync::Arc;

use specula_hdl::design::{Op, Table, wrapped};
use specula_kernels::{Binary, Lane, Ternary, accumulate, hold, look_up};

use super::memory::{Column, Memory, Place};

/// A column as one reader sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Read {
    /// The column.
    pub place: Place,
    /// Clocks that the reader looks back.
    pub back: usize,
}

/// What a step does.
#[derive(Clone)]
pub enum Work {
    /// 32-bit operands and result.
    Narrow(Binary<i32, i32>, Read, Read),
    /// 32-bit operands, 64-bit result.
    Widening(Binary<i32, i64>, Read, Read),
    /// 64-bit operands and result.
    Wide(Binary<i64, i64>, Read, Read),
    /// 64-bit operands, 32-bit result.
    Narrowing(Binary<i64, i32>, Read, Read),
    /// A multiplexer of 32 bits.
    ChooseNarrow(Ternary<i32>, Read, Read, Read),
    /// A multiplexer of 64 bits.
    ChooseWide(Ternary<i64>, Read, Read, Read),
    /// An accumulator.
    Accumulate(Accumulator),
    /// A register with an enable.
    Hold(Holder),
    /// Signals that feed back on each other.
    Component(Vec<Member>),
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

/// A step of a batch.
#[derive(Clone)]
pub struct Step {
    /// The column it writes; the first of several.
    pub out: Place,
    /// How far ahead of the clock the column runs, so that lanes of clocks before 0 stay 0; `None` for a copy of a column in which they
    /// do.
    pub skew: Option<u64>,
    pub work: Work,
}

impl Step {
    /// Evaluates lanes `from..clocks` of this batch; those below `from` belong to clocks before the first and become 0.
    pub fn run(&mut self, memory: &mut Memory, from: usize, clocks: usize) {
        match &mut self.work {
            Work::Narrow(kernel, a, b) => {
                let mut out = std::mem::take(&mut memory.narrow[self.out.index]);
                kernel.run(out.write(0, clocks), narrow(memory, *a, clocks), narrow(memory, *b, clocks));
                memory.narrow[self.out.index] = out;
            }
            Work::Widening(kernel, a, b) => {
                let mut out = std::mem::take(&mut memory.wide[self.out.index]);
                kernel.run(out.write(0, clocks), narrow(memory, *a, clocks), narrow(memory, *b, clocks));
                memory.wide[self.out.index] = out;
            }
            Work::Wide(kernel, a, b) => {
                let mut out = std::mem::take(&mut memory.wide[self.out.index]);
                kernel.run(out.write(0, clocks), wide(memory, *a, clocks), wide(memory, *b, clocks));
                memory.wide[self.out.index] = out;
            }
            Work::Narrowing(kernel, a, b) => {
                let mut out = std::mem::take(&mut memory.narrow[self.out.index]);
                kernel.run(out.write(0, clocks), wide(memory, *a, clocks), wide(memory, *b, clocks));
                memory.narrow[self.out.index] = out;
            }
            Work::ChooseNarrow(kernel, c, a, b) => {
                let mut out = std::mem::take(&mut memory.narrow[self.out.index]);
                let (a, b) = (narrow(memory, *a, clocks), narrow(memory, *b, clocks));
                kernel.run(out.write(0, clocks), narrow(memory, *c, clocks), a, b);
                memory.narrow[self.out.index] = out;
            }
            Work::ChooseWide(kernel, c, a, b) => {
                let mut out = std::mem::take(&mut memory.wide[self.out.index]);
                let (a, b) = (wide(memory, *a, clocks), wide(memory, *b, clocks));
                kernel.run(out.write(0, clocks), narrow(memory, *c, clocks), a, b);
                memory.wide[self.out.index] = out;
            }
            Work::Accumulate(accumulator) => accumulator.run(memory, self.out, from, clocks),
            Work::Hold(holder) => holder.run(memory, self.out, from, clocks),
            Work::Component(members) => {
                for at in from..clocks {
                    members.iter().for_each(|member| member.evaluate(memory, at));
                }
            }
            Work::LookUp(table, address) => look_up_lanes(memory, self.out, table, *address, clocks),
        }
        if from > 0 {
            self.clear(memory, from);
        }
    }

    fn clear(&self, memory: &mut Memory, to: usize) {
        match &self.work {
            Work::Component(members) => members.iter().for_each(|member| memory.fill(member.out, 0, to, 0)),
            _ => memory.fill(self.out, 0, to, 0),
        }
    }
}

fn look_up_lanes(memory: &mut Memory, out: Place, table: &[i64], address: Read, clocks: usize) {
    match out.wide {
        true => {
            let mut column = std::mem::take(&mut memory.wide[out.index]);
            look_up(column.write(0, clocks), narrow(memory, address, clocks), table);
            memory.wide[out.index] = column;
        }
        false => {
            let mut column = std::mem::take(&mut memory.narrow[out.index]);
            look_up(column.write(0, clocks), narrow(memory, address, clocks), table);
            memory.narrow[out.index] = column;
        }
    }
}

fn narrow(memory: &Memory, read: Read, clocks: usize) -> &[i32] {
    memory.narrow[read.place.index].read(read.back, clocks)
}

fn wide(memory: &Memory, read: Read, clocks: usize) -> &[i64] {
    memory.wide[read.place.index].read(read.back, clocks)
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

impl Accumulator {
    fn run(&mut self, memory: &mut Memory, out: Place, from: usize, clocks: usize) {
        match out.wide {
            true => {
                let mut column = std::mem::take(&mut memory.wide[out.index]);
                self.fill(memory, &mut column, from, clocks);
                memory.wide[out.index] = column;
            }
            false => {
                let mut column = std::mem::take(&mut memory.narrow[out.index]);
                self.fill(memory, &mut column, from, clocks);
                memory.narrow[out.index] = column;
            }
        }
    }

    fn fill<L: Lane>(&mut self, memory: &Memory, out: &mut Column<L>, from: usize, clocks: usize) {
        let out = out.write(from, clocks);
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
    fn run(&mut self, memory: &mut Memory, out: Place, from: usize, clocks: usize) {
        match out.wide {
            true => {
                let mut column = std::mem::take(&mut memory.wide[out.index]);
                self.fill(memory, &mut column, from, clocks);
                memory.wide[out.index] = column;
            }
            false => {
                let mut column = std::mem::take(&mut memory.narrow[out.index]);
                self.fill(memory, &mut column, from, clocks);
                memory.narrow[out.index] = column;
            }
        }
    }

    fn fill<L: Lane>(&mut self, memory: &Memory, out: &mut Column<L>, from: usize, clocks: usize) {
        let out = out.write(from, clocks);
        let enable = &narrow(memory, self.enable, clocks)[from..];
        let state = &mut self.state;
        with_lanes!(memory, self.value, clocks, value => hold(out, enable, &value[from..], state))
    }
}

impl Member {
    fn evaluate(&self, memory: &mut Memory, at: usize) {
        let value = |operand: specula_hdl::design::NodeId| {
            let read = self.reads[operand.0 as usize];
            memory.lane(read.place, at as isize - read.back as isize)
        };
        let raw = self.op.evaluate(&self.tables, value);
        memory.set_lane(self.out, at, wrapped(raw, self.width, self.signed));
    }
}
