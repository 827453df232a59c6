//! What happens in a design that no pixel has reached.
use std::collections::HashSet;

use specula_datapath::Design;
use specula_datapath::design::{NodeId, Op, Register, wrapped};

/// The sums, differences and products that overflow while a design is idle.
///
/// Proven ranges hold where a pixel is. Before the first one, a register holds 0, which may lie
/// outside its range, and idle inputs may contradict what units assume. A signal at stage s depends
/// on no input in the first s clocks, so idle clocks from the first one on show all there is; its
/// low bits, as many as it is wide, are then its value, as they are in hardware.
pub fn overflowing(design: &Design) -> HashSet<NodeId> {
    let mut found = HashSet::new();
    let mut values = vec![0i64; design.nodes.len()];
    let mut registers = vec![0i64; design.nodes.len()];
    for _ in 0..design.latency() + 2 {
        for (id, node) in design.iter() {
            let index = id.0 as usize;
            if node.register == Register::None {
                values[index] = settle(design, id, &values, &mut found);
            } else {
                values[index] = registers[index];
            }
        }
        for (id, node) in design.iter() {
            if node.register != Register::None {
                registers[id.0 as usize] = settle(design, id, &values, &mut found);
            }
        }
    }
    found
}

fn settle(design: &Design, id: NodeId, values: &[i64], found: &mut HashSet<NodeId>) -> i64 {
    let node = design.node(id);
    let raw = node.op.evaluate(&design.tables, |operand| values[operand.0 as usize]);
    let value = wrapped(raw, node.width(), node.range.signed());
    if raw != value && matches!(node.op, Op::Add(..) | Op::Sub(..) | Op::Mul(..)) {
        found.insert(id);
    }
    value
}
