//! What happens in a design where no pixel is.
use std::collections::HashSet;

use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, Range, Register, wrapped};

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

/// The sums, differences and products that may overflow where frames meet: what the last pixel of
/// one has left behind is then computed on with what holds for the next, whatever units assume of
/// both. So operands may be whatever their widths allow.
pub fn overflowing_between_frames(design: &Design) -> HashSet<NodeId> {
    let whole = |id: NodeId| match design.node(id).op {
        Op::Constant(value) => Range::single(value),
        _ => allowed(design.node(id)),
    };
    let overflows = |(_, node): &(NodeId, &Node)| {
        let raw = match node.op {
            Op::Add(a, b) => whole(a).plus(whole(b)),
            Op::Sub(a, b) => whole(a).minus(whole(b)),
            Op::Mul(a, b) => whole(a).times(whole(b)),
            _ => return false,
        };
        let own = allowed(node);
        raw.narrow().map_or(true, |raw| raw.hull(own) != own)
    };
    design.iter().filter(overflows).map(|(id, _)| id).collect()
}

/// Every value that a signal's width allows.
fn allowed(node: &Node) -> Range {
    Range::whole(node.width(), node.range.signed())
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
