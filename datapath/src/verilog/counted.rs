//! The cells of a device that a printed core asks for by name: flip-flops, multiplier blocks.
use std::collections::BTreeSet;

use serde::Serialize;

use super::LongDelays;
use super::delays::{Delays, Storage};
use crate::block::{AtomKind, Module};
use crate::design::Register;

/// Cells of a core.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counted {
    /// Flip-flops, those inside blocks apart.
    pub flip_flops: u64,
    /// Multiplier blocks.
    pub blocks: u64,
    /// Widths in bits of the delay lines that are memories.
    pub delay_memories: Vec<u64>,
    /// Counters of their addresses.
    pub counters: u64,
}

impl Counted {
    /// The cells of a core whose long delays are memories. Counters of memories that are equally
    /// long are one: they begin alike and count alike, which synthesis finds.
    pub fn of(core: &Module) -> Counted {
        let mut lengths = BTreeSet::new();
        let mut counted = Counted::default();
        counted.add(core, &mut lengths);
        counted.counters = lengths.len() as u64;
        let counters = lengths.into_iter().map(|clocks: usize| u64::from((clocks - 2).ilog2() + 1));
        counted.flip_flops += counters.sum::<u64>();
        counted
    }

    /// Memories with words of so many bits that delay lines take.
    pub fn memories(&self, word_bits: u64) -> u64 {
        self.delay_memories.iter().map(|width| width.div_ceil(word_bits)).sum()
    }

    fn add(&mut self, module: &Module, lengths: &mut BTreeSet<usize>) {
        let delays = Delays::of(module);
        let width = |wire: u32| u64::from(module.wires()[wire as usize].wire_type().width);
        let mut in_memory = BTreeSet::new();
        for line in &delays.lines {
            if line.storage(LongDelays::Memories) == Storage::Memory {
                lengths.insert(line.clocks());
                self.delay_memories.push(width(line.input));
                in_memory.extend(line.stages[..line.clocks() - 1].iter().copied());
            }
        }
        let kept = module.cells().filter(|cell| {
            cell.register != Register::None
                && !delays.in_block(cell.wire)
                && !in_memory.contains(&cell.wire)
                && module.wires()[cell.wire as usize].wire_type().kind != AtomKind::Constant
        });
        self.flip_flops += kept.map(|cell| width(cell.wire)).sum::<u64>();
        self.blocks += module.multipliers().len() as u64;
        module.children().iter().for_each(|child| self.add(&child.module, lengths));
    }
}
