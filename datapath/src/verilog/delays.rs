//! Registers that only delay: which of a module's form lines, and what such a line is called.
use std::collections::{HashMap, HashSet};

use super::gated_sum_modules::GatedSum;
use crate::block::{AtomKind, Cell, Module};
use crate::design::{MultiplierBlock, NodeId, Op, Primitives, Register};
use crate::names::first_taken;

/// The clocks of the shortest line that is an instance of its own, unless shorter ones are memories.
const SHORTEST: usize = 4;

/// What delay lines are made of that the target would have as memories.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LongDelays {
    /// Memories used as circular buffers, which hold only what is still to leave.
    Memories,
    /// Shift registers, in which a trace finds the value of every stage.
    ShiftRegisters,
}

/// What a delay line is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Storage {
    /// A shift register.
    ShiftRegister,
    /// A memory used as a circular buffer.
    Memory,
}

/// Registers in a row, each of which takes what the one before it held.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DelayLine {
    /// The name of the instance, or of the vector.
    pub name: String,
    /// The wire that enters.
    pub input: u32,
    /// The wires of the registers, in order; what the last one holds leaves.
    pub stages: Vec<u32>,
    /// Clocks of the shortest line that is a memory.
    pub shortest_memory: usize,
}

impl DelayLine {
    /// Clocks from what enters to what leaves.
    pub fn clocks(&self) -> usize {
        self.stages.len()
    }

    /// The wire that leaves; a line has at least one stage.
    pub fn output(&self) -> u32 {
        self.stages.last().copied().unwrap_or(self.input)
    }

    /// Whether it is a memory.
    pub fn is_memory(&self, long: LongDelays) -> bool {
        self.storage(long) == Storage::Memory
    }

    /// What it is made of.
    pub fn storage(&self, long: LongDelays) -> Storage {
        match long {
            LongDelays::Memories if self.clocks() >= self.shortest_memory => Storage::Memory,
            _ => Storage::ShiftRegister,
        }
    }
}

/// The delay lines of a module.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Delays {
    /// Lines of data that are instances: at least four clocks long, or as long as a memory, and only
    /// the next register reads a stage that is not the last.
    pub lines: Vec<DelayLine>,
    /// Lines of validity that are vectors: at least two clocks long, and anything may read a stage.
    pub validity: Vec<DelayLine>,
    members: HashSet<u32>,
    /// What is inside multiplier blocks.
    in_blocks: HashSet<u32>,
    /// Names of the instances of multiplier blocks and sums, by the wires that leave them.
    blocks: HashMap<NodeId, String>,
    /// Sums that are instances of their own.
    pub gated_sums: Vec<GatedSum>,
}

impl Delays {
    /// The delay lines of `module`.
    pub fn of(module: &Module) -> Delays {
        let readers = Readers::of(module);
        let data = readers.rows(Register::Data, |wire| readers.only_delay(wire));
        let bits = readers.rows(Register::Validity, |wire| readers.first_validity(wire));
        let mut names = Names::of(module);
        let shortest_memory = module.primitives().shortest_memory as usize;
        let longest_memory = module.primitives().longest_memory as usize;
        let mut named = |rows: Vec<(u32, Vec<u32>)>, shortest: usize, suffix: &str| {
            let long = rows.into_iter().filter(|(_, stages)| stages.len() >= shortest);
            let line = |(input, stages): (u32, Vec<u32>)| {
                let entering = &module.wires()[input as usize].wire_type().name;
                let name = names.unique(&format!("{entering}_{suffix}"));
                DelayLine { name, input, stages, shortest_memory }
            };
            long.map(line).collect::<Vec<_>>()
        };
        let data = data.into_iter().map(|row| behind_register(module, row));
        let data = data.flat_map(|row| segments(row, longest_memory)).collect();
        let lines = named(data, SHORTEST.min(shortest_memory), "delay");
        let validity = named(bits, 2, "line");
        let gated_sums = GatedSum::all(module);
        let products = module.multipliers().iter().map(|block| block.product);
        let sums = gated_sums.iter().map(|of| NodeId(of.sum));
        let blocks = products.chain(sums).map(|result| {
            let name = &module.wires()[result.0 as usize].wire_type().name;
            (result, names.unique(&format!("{name}_block")))
        });
        let blocks = blocks.collect();
        let members = lines.iter().chain(&validity).flat_map(|l| l.stages.clone()).collect();
        let in_blocks = inside_blocks(module);
        Delays { lines, validity, members, in_blocks, blocks, gated_sums }
    }

    /// Whether this wire is driven inside a multiplier block.
    pub fn in_block(&self, wire: u32) -> bool {
        self.in_blocks.contains(&wire)
    }

    /// The name of the instance that a product or sum leaves.
    pub fn block_name(&self, result: NodeId) -> &str {
        self.blocks.get(&result).map_or("", String::as_str)
    }

    /// Whether this wire is the sum of an instance.
    pub fn is_gated_sum(&self, wire: u32) -> bool {
        self.blocks.contains_key(&NodeId(wire)) && !self.in_block(wire)
    }

    /// Whether the register of this wire is part of a line.
    pub fn contains(&self, wire: u32) -> bool {
        self.members.contains(&wire)
    }
}

/// The part of a row that a memory may be: without the first register, which takes what logic gives,
/// where the target's memories take what a register gives.
fn behind_register(module: &Module, (input, stages): (u32, Vec<u32>)) -> (u32, Vec<u32>) {
    let Primitives { shortest_memory, registered_memories, .. } = module.primitives();
    let has_memory = stages.len() >= shortest_memory as usize;
    let stored = module.wires()[input as usize].wire_type().stored;
    match stages.split_first() {
        Some((&first, rest)) if registered_memories && has_memory && !stored => {
            (first, rest.to_vec())
        }
        _ => (input, stages),
    }
}

/// A row of registers in parts of at most so many clocks, as long as each other as can be.
fn segments((input, stages): (u32, Vec<u32>), longest: usize) -> Vec<(u32, Vec<u32>)> {
    let parts = stages.len().div_ceil(longest);
    let mut entering = input;
    let chunks = stages.chunks(stages.len().div_ceil(parts));
    let segment = |chunk: &[u32]| {
        let from = entering;
        entering = chunk.last().copied().unwrap_or(from);
        (from, chunk.to_vec())
    };
    chunks.map(segment).collect()
}

/// The wires that are driven inside multiplier blocks.
fn inside_blocks(module: &Module) -> HashSet<u32> {
    module.multipliers().iter().flat_map(MultiplierBlock::inside).map(|id| id.0).collect()
}

/// The operand of a register that only delays it: a variable of the same width.
pub fn delayed(module: &Module, cell: &Cell) -> Option<u32> {
    let Op::Copy(operand) = cell.op else { return None };
    let [from, to] = [operand.0, cell.wire].map(|wire| module.wires()[wire as usize].wire_type());
    let same = from.width == to.width && from.kind != AtomKind::Constant;
    (same && cell.register != Register::None).then_some(operand.0)
}

/// Who reads the wires of a module.
struct Readers<'a> {
    module: &'a Module,
    /// How often each wire is read, by cells and by children.
    reads: Vec<u32>,
    /// The registers that delay each wire.
    delays: Vec<Vec<&'a Cell>>,
}

impl<'a> Readers<'a> {
    fn of(module: &'a Module) -> Readers<'a> {
        let wires = module.wires().len();
        let mut readers = Readers { module, reads: vec![0; wires], delays: vec![vec![]; wires] };
        for block in module.multipliers() {
            block.factors.iter().for_each(|factor| readers.reads[factor.0 as usize] += 1);
        }
        let inside = inside_blocks(module);
        for cell in module.cells().filter(|cell| !inside.contains(&cell.wire)) {
            cell.op.operands().for_each(|operand| readers.reads[operand.0 as usize] += 1);
            if let Some(from) = delayed(module, cell) {
                readers.delays[from as usize].push(cell);
            }
        }
        for child in module.children() {
            child.inputs.iter().for_each(|&(_, wire)| readers.reads[wire as usize] += 1);
        }
        readers
    }

    /// The register of data behind a wire that nothing else reads.
    fn only_delay(&self, wire: u32) -> Option<u32> {
        let local = self.module.wires()[wire as usize].wire_type().kind == AtomKind::LocalSignal;
        let [cell] = self.delays[wire as usize][..] else { return None };
        let only = local && self.reads[wire as usize] == 1 && cell.register == Register::Data;
        only.then_some(cell.wire)
    }

    /// The first register of validity behind a wire.
    fn first_validity(&self, wire: u32) -> Option<u32> {
        let mut cells = self.delays[wire as usize].iter();
        cells.find(|cell| cell.register == Register::Validity).map(|cell| cell.wire)
    }

    /// Delay registers of a kind in rows, each with the wire that enters it; `next` is the register
    /// that goes on behind another. Registers in a ring begin nowhere and are in no row.
    fn rows(&self, kind: Register, next: impl Fn(u32) -> Option<u32>) -> Vec<(u32, Vec<u32>)> {
        let inside = inside_blocks(self.module);
        let of_kind = || {
            let outside = |cell: &&Cell| !inside.contains(&cell.wire);
            self.module.cells().filter(outside).filter(|cell| cell.register == kind)
        };
        let registers: HashSet<u32> = of_kind()
            .filter(|cell| delayed(self.module, cell).is_some())
            .map(|cell| cell.wire)
            .collect();
        let continues =
            |from: u32, wire: u32| registers.contains(&from) && next(from) == Some(wire);
        of_kind()
            .filter_map(|cell| Some((delayed(self.module, cell)?, cell.wire)))
            .filter(|&(from, wire)| !continues(from, wire))
            .map(|(from, wire)| (from, std::iter::successors(Some(wire), |&at| next(at)).collect()))
            .collect()
    }
}

/// Names that a module's text has already.
struct Names(HashSet<String>);

impl Names {
    fn of(module: &Module) -> Names {
        let wires = module.wires().iter().map(|wire| wire.wire_type().name.clone());
        let instances = module.children().iter().map(|child| child.module.instance.clone());
        Names(wires.chain(instances).chain([module.instance.clone()]).collect())
    }

    fn unique(&mut self, name: &str) -> String {
        first_taken(name, |candidate| self.0.insert(candidate.to_owned()))
    }
}
