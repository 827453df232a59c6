//! Bits of nets that nothing reads, so that a linter need not be told to look away.
use std::collections::HashSet;

use super::{Nets, statement};
use crate::block::{AtomKind, Module};
use crate::design::{MultiplierBlock, NodeId, Op};

/// The bits of each net that nothing in the module reads, as Verilog selections in the order of the
/// nets.
pub fn unread_bits(module: &Module, nets: &Nets) -> Vec<String> {
    let all: Vec<u64> =
        module.wires().iter().map(|w| u64::MAX >> (64 - w.wire_type().width)).collect();
    let mut unread = all.clone();
    let inside: HashSet<NodeId> =
        module.multipliers().iter().flat_map(MultiplierBlock::inside).collect();
    for block in module.multipliers() {
        block.factors.iter().for_each(|factor| unread[factor.0 as usize] = 0);
        let held = block.inside().filter(|&id| id != block.product);
        held.for_each(|id| unread[id.0 as usize] = 0);
    }
    for cell in module.cells().filter(|cell| !inside.contains(&NodeId(cell.wire))) {
        let width = module.wires()[cell.wire as usize].wire_type().width;
        for operand in cell.op.operands() {
            let index = operand.0 as usize;
            let own = module.wires()[index].wire_type().width;
            let mask = match sign_alone(module, cell.op) {
                Some(signed) if signed == operand => all[index] >> 1,
                _ => statement::unread_bits(cell.op, width, NodeId(operand.0), own),
            };
            unread[index] &= mask;
        }
    }
    for child in module.children() {
        child.inputs.iter().for_each(|&(_, wire)| unread[wire as usize] = 0);
    }
    let named = (0..).zip(module.wires()).zip(&unread);
    let read_outside = |kind| matches!(kind, AtomKind::OutputParameter | AtomKind::Constant);
    named
        // Reset is read by the registers' control, which is no operator.
        .filter(|((number, wire), _)| {
            !read_outside(wire.wire_type().kind) && !module.is_reset(*number)
        })
        .flat_map(|((number, wire), &mask)| {
            selections(nets.name(number), wire.wire_type().width, mask)
        })
        .collect()
}

/// The signed operand of a comparison with 0, of which only the sign is read.
fn sign_alone(module: &Module, op: Op) -> Option<NodeId> {
    let Op::LessThan(a, b) = op else { return None };
    let [left, right] = [a, b].map(|id| &module.wires()[id.0 as usize]);
    let with_zero = right.wire_type().kind == AtomKind::Constant && right.value() == 0;
    (with_zero && left.wire_type().signed).then_some(a)
}

/// The runs of 1 in `mask` as bit and part selects.
fn selections(name: &str, width: u32, mask: u64) -> Vec<String> {
    let mut runs = vec![];
    let mut bit = 0;
    while bit < width {
        let length = (mask >> bit).trailing_ones().min(width - bit);
        match length {
            0 => {}
            _ if length == width => runs.push(name.to_owned()),
            1 => runs.push(format!("{name}[{bit}]")),
            _ => runs.push(format!("{name}[{}:{bit}]", bit + length - 1)),
        }
        bit += length.max(1);
    }
    runs
}

#[cfg(test)]
mod tests {
    use super::selections;

    #[test]
    fn runs_of_bits_become_selections() {
        assert_eq!(selections("x", 8, 0b1001_1101), ["x[0]", "x[4:2]", "x[7]"]);
        assert_eq!(selections("x", 3, 0b111), ["x"]);
        assert!(selections("x", 3, 0).is_empty());
    }
}
