//! Signals that compute the same of the same, which synthesis makes one of, whatever units they are
//! in.
use std::collections::HashMap;

use crate::design::{Design, NodeId, Op};

/// A signal's operator; that of a choice whose bit is constant is a wire.
pub fn decided(design: &Design, id: NodeId) -> Op {
    match design.node(id).op {
        Op::Select(choice, a, b) => match design.node(choice).op.constant() {
            Some(0) => Op::Copy(b),
            Some(_) => Op::Copy(a),
            None => Op::Select(choice, a, b),
        },
        op => op,
    }
}

/// For each signal the first that is the same.
pub fn firsts(design: &Design, in_block: &[bool]) -> Vec<NodeId> {
    let mut firsts: Vec<NodeId> = Vec::with_capacity(design.nodes.len());
    let mut known = HashMap::new();
    for (id, node) in design.iter() {
        // A register of a loop reads what comes later.
        let is_own = node.op == Op::Input
            || in_block[id.0 as usize]
            || decided(design, id).operands().any(|operand| operand >= id);
        let first = if is_own {
            id
        } else {
            let op = decided(design, id).map(|operand| firsts[operand.0 as usize]);
            let shape = (node.width(), node.range.signed());
            match op {
                Op::Copy(from) if !node.registered() && shape == of(design, from) => from,
                _ => *known.entry((op, shape, node.register)).or_insert(id),
            }
        };
        firsts.push(first);
    }
    firsts
}

fn of(design: &Design, id: NodeId) -> (u32, bool) {
    (design.node(id).width(), design.node(id).range.signed())
}
