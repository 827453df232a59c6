//! A design as synthesis sees it: twins are one, wires are passed over, and what nobody reads is not
//! there.
use super::{needed, twins};
use crate::design::{Design, MultiplierBlock, NodeId, Op};

/// A design with what reads each signal.
pub struct Wiring<'a> {
    /// The design.
    pub design: &'a Design,
    /// Operators, on the first of twins.
    ops: Vec<Op>,
    /// The signal whose bits each signal has: its own, or that of the operand of a wire; a single bit
    /// of a signal is its own.
    sources: Vec<NodeId>,
    /// The signal of which a signal is a single bit.
    bit_of: Vec<Option<NodeId>>,
    /// How many operators, blocks and outputs read each signal that is no wire.
    readers: Vec<u32>,
    /// The bits of each signal that are read.
    needed: Vec<u64>,
    /// How many of the lowest bits of each signal are always 0.
    zeros: Vec<u32>,
    /// Whether a signal is inside a multiplier block.
    in_block: Vec<bool>,
    /// Whether a signal is the first of its twins.
    is_first: Vec<bool>,
}

impl<'a> Wiring<'a> {
    /// That of a design.
    pub fn of(design: &'a Design) -> Wiring<'a> {
        let count = design.nodes.len();
        let mut in_block = vec![false; count];
        let inside = design.multipliers.iter().flat_map(MultiplierBlock::inside);
        inside.for_each(|id| in_block[id.0 as usize] = true);
        let firsts = twins::firsts(design, &in_block);
        let first = |id: NodeId| firsts[id.0 as usize];
        let op = |id| twins::decided(design, id).map(first);
        let ops: Vec<Op> = design.iter().map(|(id, _)| op(id)).collect();
        let factors = design.multipliers.iter().flat_map(|block| block.factors);
        let ends: Vec<NodeId> = factors.chain(design.outputs.iter().copied()).map(first).collect();
        let needed = needed::bits(design, |id| ops[id.0 as usize], ends.iter().copied());
        let is_first = design.iter().map(|(id, _)| first(id) == id).collect();
        let mut wiring = Wiring {
            design,
            ops,
            sources: vec![],
            bit_of: vec![None; count],
            readers: vec![0; count],
            needed,
            zeros: Vec::with_capacity(count),
            in_block,
            is_first,
        };
        wiring.trace();
        let read = wiring.operators().flat_map(|(_, op)| op.operands());
        for id in read.chain(ends).collect::<Vec<_>>() {
            let source = wiring.source(id);
            wiring.readers[source.0 as usize] += 1;
        }
        wiring
    }

    /// Finds sources.
    fn trace(&mut self) {
        for (id, node) in self.design.iter() {
            let from = self.wired(id).map(|from| self.sources[from.0 as usize]);
            let is_bit = from.is_some_and(|from| node.width() == 1 && self.width(from) > 1);
            if is_bit {
                self.bit_of[id.0 as usize] = from;
            }
            self.sources.push(from.filter(|_| !is_bit).unwrap_or(id));
            self.zeros.push(self.lowest_zeros(id));
        }
    }

    /// How many of a signal's lowest bits are always 0, as far as those of its operands tell, which
    /// are known already but for what goes round a loop.
    fn lowest_zeros(&self, id: NodeId) -> u32 {
        let of = |id: NodeId| self.zeros.get(id.0 as usize).copied().unwrap_or(0);
        match self.ops[id.0 as usize] {
            Op::Copy(from) | Op::Wrap(from) => of(from),
            Op::ShiftLeft(from, bits) => of(from) + bits,
            Op::ShiftRight(from, bits) => of(from).saturating_sub(bits),
            Op::Add(a, b) | Op::Sub(a, b) => of(a).min(of(b)),
            op => op.constant().map_or(0, i64::trailing_zeros),
        }
    }

    /// The signals outside blocks that are no wires and that anything reads, each with its operator.
    pub fn operators(&self) -> impl Iterator<Item = (NodeId, Op)> {
        self.design.iter().map(|(id, _)| (id, self.ops[id.0 as usize])).filter(|&(id, op)| {
            let index = id.0 as usize;
            self.is_first[index]
                && !self.in_block[index]
                && self.needed[index] != 0
                && op.constant().is_none()
                && self.wired(id).is_none()
        })
    }

    /// The operand of a wire.
    fn wired(&self, id: NodeId) -> Option<NodeId> {
        if self.design.node(id).registered() || self.in_block[id.0 as usize] {
            return None;
        }
        match self.ops[id.0 as usize] {
            Op::Copy(from) | Op::ShiftLeft(from, _) | Op::ShiftRight(from, _) | Op::Wrap(from) => {
                Some(from)
            }
            // The sign.
            Op::LessThan(from, zero) if self.constant(zero) == Some(0) => Some(from),
            _ => None,
        }
    }

    /// A signal's operator, on the first of twins.
    pub fn op(&self, id: NodeId) -> Op {
        self.ops[id.0 as usize]
    }

    /// The signal whose bits a signal has.
    pub fn source(&self, id: NodeId) -> NodeId {
        self.sources[id.0 as usize]
    }

    /// The signal of which a signal is a single bit.
    pub fn bit_of(&self, id: NodeId) -> Option<NodeId> {
        self.bit_of[self.source(id).0 as usize]
    }

    /// How many read a signal that is no wire.
    pub fn readers(&self, id: NodeId) -> u32 {
        self.readers[id.0 as usize]
    }

    /// The bits of a signal that are read.
    pub fn needed(&self, id: NodeId) -> u64 {
        self.needed[id.0 as usize]
    }

    /// How many of the lowest bits of a signal are always 0.
    pub fn zeros(&self, id: NodeId) -> u32 {
        self.zeros[id.0 as usize]
    }

    /// How many bits of a signal are read.
    pub fn needed_bits(&self, id: NodeId) -> u64 {
        u64::from(self.needed(id).count_ones())
    }

    /// The value of a constant.
    pub fn constant(&self, id: NodeId) -> Option<i64> {
        self.design.node(id).op.constant()
    }

    /// A signal's width in bits.
    pub fn width(&self, id: NodeId) -> u64 {
        u64::from(self.design.node(id).width())
    }

    /// Whether a signal is the output of a register.
    pub fn registered(&self, id: NodeId) -> bool {
        self.design.node(id).registered()
    }

    /// Whether a signal is computed by operators outside blocks and registers.
    pub fn is_in_logic(&self, id: NodeId) -> bool {
        !self.registered(id) && !self.in_block[id.0 as usize]
    }

    /// Whether an operator only puts two values side by side.
    pub fn is_join(&self, op: Op) -> bool {
        op.is_join(|id| {
            let node = self.design.node(id);
            (node.op, node.range)
        })
    }

    /// Flip-flops outside blocks that nothing reads, or that are twins of others.
    pub fn superfluous_flip_flops(&self) -> u64 {
        let registers = self.design.iter().filter(|&(id, node)| {
            node.registered() && !self.in_block[id.0 as usize] && node.op.constant().is_none()
        });
        let kept = |id: NodeId| if self.is_first[id.0 as usize] { self.needed_bits(id) } else { 0 };
        registers.map(|(id, _)| self.width(id) - kept(id)).sum()
    }
}
