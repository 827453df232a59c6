//! One step of a batch: a kernel with the columns it reads and writes.
use specula_kernels::{Binary, Products, Ternary};

use super::memory::{Memory, Place};
use super::read::{Read, narrow, wide};
use super::serial::{Member, Serial};

/// A sum of `N` products.
#[derive(Clone, Copy)]
pub enum Sum<const N: usize> {
    /// 32-bit result.
    Narrow(Products<i32, N>, [[Read; 2]; N]),
    /// 64-bit result.
    Wide(Products<i64, N>, [[Read; 2]; N]),
}

impl<const N: usize> Sum<N> {
    fn run(&self, memory: &mut Memory, out: usize, clocks: usize) {
        match self {
            Sum::Narrow(kernel, factors) => memory.write_narrow(out, |memory, out| {
                kernel.run(
                    out.write(0, clocks),
                    factors.map(|pair| pair.map(|read| narrow(memory, read, clocks))),
                );
            }),
            Sum::Wide(kernel, factors) => memory.write_wide(out, |memory, out| {
                kernel.run(
                    out.write(0, clocks),
                    factors.map(|pair| pair.map(|read| narrow(memory, read, clocks))),
                );
            }),
        }
    }
}

impl From<Sum<1>> for Work {
    fn from(sum: Sum<1>) -> Work {
        Work::Product(sum)
    }
}

impl From<Sum<2>> for Work {
    fn from(sum: Sum<2>) -> Work {
        Work::Products2(sum)
    }
}

impl From<Sum<3>> for Work {
    fn from(sum: Sum<3>) -> Work {
        Work::Products3(sum)
    }
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
    /// A product of 32-bit operands.
    Product(Sum<1>),
    /// Two of them.
    Products2(Sum<2>),
    /// Three of them.
    Products3(Sum<3>),
    /// A multiplexer of 32 bits.
    ChooseNarrow(Ternary<i32>, Read, Read, Read),
    /// A multiplexer of 64 bits.
    ChooseWide(Ternary<i64>, Read, Read, Read),
    /// Lanes that depend on the lanes before, or on a table.
    Serial(Serial),
    /// Signals that feed back on each other.
    Component(Vec<Member>),
}

/// A step of a batch.
#[derive(Clone)]
pub struct Step {
    /// The column it writes; the first of several.
    pub out: Place,
    /// How far ahead of the clock the column runs, so that lanes of clocks before 0 stay 0; `None`
    /// for a copy of a column in which they do.
    pub skew: Option<u64>,
    pub work: Work,
}

impl Step {
    /// Evaluates lanes `from..clocks` of this batch; those below `from` belong to clocks before the
    /// first and become 0.
    pub fn run(&mut self, memory: &mut Memory, from: usize, clocks: usize) {
        let out = self.out.index;
        match &mut self.work {
            Work::Narrow(kernel, a, b) => memory.write_narrow(out, |memory, out| {
                kernel.run(
                    out.write(0, clocks),
                    narrow(memory, *a, clocks),
                    narrow(memory, *b, clocks),
                );
            }),
            Work::Widening(kernel, a, b) => memory.write_wide(out, |memory, out| {
                kernel.run(
                    out.write(0, clocks),
                    narrow(memory, *a, clocks),
                    narrow(memory, *b, clocks),
                );
            }),
            Work::Wide(kernel, a, b) => memory.write_wide(out, |memory, out| {
                kernel.run(
                    out.write(0, clocks),
                    wide(memory, *a, clocks),
                    wide(memory, *b, clocks),
                );
            }),
            Work::Narrowing(kernel, a, b) => memory.write_narrow(out, |memory, out| {
                kernel.run(
                    out.write(0, clocks),
                    wide(memory, *a, clocks),
                    wide(memory, *b, clocks),
                );
            }),
            Work::Product(sum) => sum.run(memory, out, clocks),
            Work::Products2(sum) => sum.run(memory, out, clocks),
            Work::Products3(sum) => sum.run(memory, out, clocks),
            Work::ChooseNarrow(kernel, c, a, b) => memory.write_narrow(out, |memory, out| {
                let (a, b) = (narrow(memory, *a, clocks), narrow(memory, *b, clocks));
                kernel.run(out.write(0, clocks), narrow(memory, *c, clocks), a, b);
            }),
            Work::ChooseWide(kernel, c, a, b) => memory.write_wide(out, |memory, out| {
                let (a, b) = (wide(memory, *a, clocks), wide(memory, *b, clocks));
                kernel.run(out.write(0, clocks), narrow(memory, *c, clocks), a, b);
            }),
            Work::Serial(serial) if self.out.wide => {
                memory.write_wide(out, |memory, out| serial.run(memory, out, from, clocks));
            }
            Work::Serial(serial) => {
                memory.write_narrow(out, |memory, out| serial.run(memory, out, from, clocks))
            }
            Work::Component(members) => {
                for at in from..clocks {
                    members.iter().for_each(|member| member.evaluate(memory, at));
                }
            }
        }
        if from > 0 {
            self.clear(memory, from);
        }
    }

    fn clear(&self, memory: &mut Memory, to: usize) {
        match &self.work {
            Work::Component(members) => {
                members.iter().for_each(|member| memory.fill(member.out, 0, to, 0))
            }
            _ => memory.fill(self.out, 0, to, 0),
        }
    }
}
