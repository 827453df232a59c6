//! Which bits of each signal anything reads: the others are left out by synthesis.
use crate::design::{Design, NodeId, Op};

/// Masks of the bits of all signals that are read, by operators as `op` gives them.
pub fn bits(
    design: &Design,
    op: impl Fn(NodeId) -> Op,
    ends: impl Iterator<Item = NodeId>,
) -> Vec<u64> {
    let mut needed = Needed { design, masks: vec![0; design.nodes.len()], grew: true };
    ends.for_each(|id| needed.add(id, u64::MAX));
    // Registers of loops are read before what they read.
    while needed.grew {
        needed.grew = false;
        for index in (0..design.nodes.len() as u32).rev() {
            needed.pass_on(NodeId(index), op(NodeId(index)));
        }
    }
    needed.masks
}

struct Needed<'a> {
    design: &'a Design,
    masks: Vec<u64>,
    grew: bool,
}

impl Needed<'_> {
    /// What a signal's operator reads for the bits that are read of it.
    fn pass_on(&mut self, id: NodeId, op: Op) {
        let mask = self.masks[id.0 as usize];
        if mask == 0 {
            return;
        }
        let below = u64::MAX >> mask.leading_zeros();
        match op {
            Op::Input | Op::Constant(_) => {}
            Op::Copy(a) | Op::Wrap(a) | Op::Not(a) => self.add(a, mask),
            Op::And(a, b) | Op::Or(a, b) => [a, b].into_iter().for_each(|id| self.add(id, mask)),
            Op::ShiftLeft(a, bits) => self.add(a, mask >> bits),
            Op::ShiftRight(a, bits) => self.add(a, mask << bits.min(63)),
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) => {
                [a, b].into_iter().for_each(|id| self.add(id, below));
            }
            Op::LessThan(a, b) if self.design.node(b).op == Op::Constant(0) => {
                self.add(a, 1 << (self.design.node(a).width() - 1));
            }
            Op::LessThan(a, b) => [a, b].into_iter().for_each(|id| self.add(id, u64::MAX)),
            Op::Select(choice, a, b) => {
                self.add(choice, 1);
                [a, b].into_iter().for_each(|id| self.add(id, mask));
            }
            Op::LookUp(address, _) => self.add(address, u64::MAX),
        }
    }

    /// Notes that bits of a signal are read; those above its highest are its sign.
    fn add(&mut self, id: NodeId, mask: u64) {
        let node = self.design.node(id);
        let own = u64::MAX >> (64 - node.width());
        let sign =
            if mask & !own != 0 && node.range.signed() { 1 << (node.width() - 1) } else { 0 };
        let old = self.masks[id.0 as usize];
        let new = old | mask & own | sign;
        self.grew |= new != old;
        self.masks[id.0 as usize] = new;
    }
}
