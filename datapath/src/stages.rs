//! A design clock by clock: what is computed in each, and which registers take it over.
use std::collections::HashSet;

use crate::block::Module;
use crate::design::{Design, MultiplierBlock, Node, NodeId, Op};
use crate::target::Shape;
use crate::verilog::{Delays, LongDelays};

/// A clock of a design, counted from the one in which a pixel enters.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stage {
    /// What is computed in the clock. Wires are not: ports, shifts, signs, bits side by side.
    pub operators: Vec<Computed>,
    /// Registers that take over at the end of the clock, and signals that leave the design in it.
    pub ends: Vec<NodeId>,
    /// The bits of those registers.
    pub carried: Carried,
}

/// An operator in one of its clocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Computed {
    /// The signal that it computes.
    pub node: NodeId,
    /// Of a product in a multiplier block: which of the block's clocks this is, from 1 on, and how
    /// many it has.
    pub in_block: Option<(u32, u32)>,
}

/// Register bits that take over at the end of a clock.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Carried {
    /// Inside multiplier blocks.
    pub in_blocks: u64,
    /// Flip-flops.
    pub flip_flops: u64,
    /// In memories that are delay lines.
    pub in_memories: u64,
}

impl Carried {
    /// All of them.
    pub fn total(&self) -> u64 {
        self.in_blocks + self.flip_flops + self.in_memories
    }

    /// These and others.
    pub fn plus(self, other: Carried) -> Carried {
        Carried {
            in_blocks: self.in_blocks + other.in_blocks,
            flip_flops: self.flip_flops + other.flip_flops,
            in_memories: self.in_memories + other.in_memories,
        }
    }
}

/// What an operator is, for people to read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum OperatorKind {
    /// A product of two variables.
    Multiplier,
    /// A product with a constant, as sums of shifts.
    ConstantProduct,
    /// A sum.
    Adder,
    /// A difference.
    Subtractor,
    /// A comparison of two values.
    Comparator,
    /// A look-up in a table.
    Table,
    /// A choice between two values.
    Multiplexer,
    /// A function of bits.
    Gate,
}

impl OperatorKind {
    /// One of the kind, and several.
    pub const fn words(self) -> [&'static str; 2] {
        match self {
            OperatorKind::Multiplier => ["multiplier", "multipliers"],
            OperatorKind::ConstantProduct => ["constant product", "constant products"],
            OperatorKind::Adder => ["adder", "adders"],
            OperatorKind::Subtractor => ["subtractor", "subtractors"],
            OperatorKind::Comparator => ["comparator", "comparators"],
            OperatorKind::Table => ["table", "tables"],
            OperatorKind::Multiplexer => ["multiplexer", "multiplexers"],
            OperatorKind::Gate => ["gate", "gates"],
        }
    }
}

impl Design {
    /// What is computed in each clock, from the one in which a pixel enters to the one in which it
    /// leaves. The register bits of all clocks are those of [`Design::size`].
    pub fn stages(&self) -> Vec<Stage> {
        let mut stages = vec![Stage::default(); self.depth() as usize + 1];
        let in_blocks: HashSet<NodeId> =
            self.multipliers.iter().flat_map(MultiplierBlock::inside).collect();
        let mut in_memories = HashSet::new();
        collect_memories(&self.to_block(), &mut in_memories);
        for (id, node) in self.iter() {
            let stage = &mut stages[self.clock_of(id, node) as usize];
            let bits = u64::from(node.width());
            if node.registered() {
                stage.ends.push(id);
                let carried = &mut stage.carried;
                let place = if in_blocks.contains(&id) {
                    &mut carried.in_blocks
                } else if in_memories.contains(&id) {
                    &mut carried.in_memories
                } else {
                    &mut carried.flip_flops
                };
                *place += bits;
            } else if self.outputs.contains(&id) || self.valid_out == id {
                stage.ends.push(id);
            }
            if self.operator_kind(id).is_some() && !in_blocks.contains(&id) {
                stage.operators.push(Computed { node: id, in_block: None });
            }
        }
        for block in &self.multipliers {
            let clocks = block.registers.max(1);
            let last = self.clock_of(block.product, self.node(block.product));
            for clock in 1..=clocks {
                let stage = &mut stages[(last + clock - clocks) as usize];
                let in_block = Some((clock, clocks));
                stage.operators.push(Computed { node: block.product, in_block });
            }
        }
        stages
    }

    /// What computes a signal; none of wires, constants, inputs, and registers alone.
    pub fn operator_kind(&self, id: NodeId) -> Option<OperatorKind> {
        let node = self.node(id);
        let is_block = || self.multipliers.iter().any(|block| block.product == id);
        let operation = |id: NodeId| (self.node(id).op, self.node(id).range);
        if node.clock_enable(id).is_some() || node.op.is_join(operation) {
            return None;
        }
        let width = |id: NodeId| match self.node(id).op {
            Op::Constant(0) => 0,
            _ => self.node(id).width(),
        };
        match node.op {
            Op::Copy(_) if is_block() => Some(OperatorKind::Multiplier),
            op if Shape::of(&op, node.width(), width) == Shape::Wires => None,
            Op::Mul(..) if self.factors(node).is_none() && !is_block() => {
                Some(OperatorKind::ConstantProduct)
            }
            Op::Mul(..) => Some(OperatorKind::Multiplier),
            Op::Add(..) => Some(OperatorKind::Adder),
            Op::Sub(..) => Some(OperatorKind::Subtractor),
            Op::LessThan(..) => Some(OperatorKind::Comparator),
            Op::LookUp(..) => Some(OperatorKind::Table),
            Op::Select(..) => Some(OperatorKind::Multiplexer),
            Op::And(..) | Op::Or(..) | Op::Not(_) => Some(OperatorKind::Gate),
            Op::Input
            | Op::Constant(_)
            | Op::Copy(_)
            | Op::ShiftLeft(..)
            | Op::ShiftRight(..)
            | Op::Wrap(_) => None,
        }
    }

    /// The clock in which a signal is computed. A register takes over what is there in the clock
    /// of its operands: that before its own, or its own if it goes round a loop.
    fn clock_of(&self, id: NodeId, node: &Node) -> u32 {
        if !node.registered() {
            return node.stage.min(self.depth());
        }
        let operands = node.op.operands().filter(|&operand| operand != id);
        let variable = operands.filter(|&operand| self.node(operand).op.constant().is_none());
        let latest = variable.map(|operand| self.node(operand).stage).max();
        latest.unwrap_or(node.stage.saturating_sub(1)).min(self.depth())
    }
}

/// Registers that the Verilog of a module and those in it has in memories; the last of a delay line
/// is a flip-flop behind its memory.
fn collect_memories(module: &Module, found: &mut HashSet<NodeId>) {
    let delays = Delays::of(module);
    let memories = delays.lines.iter().filter(|line| line.is_memory(LongDelays::Memories));
    for line in memories {
        let inside = line.stages.iter().take(line.clocks() - 1);
        found.extend(inside.map(|&wire| module.wires()[wire as usize].wire_type().node));
    }
    module.children().iter().for_each(|child| collect_memories(&child.module, found));
}
