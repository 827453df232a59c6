//! Takes out what no watched signal depends on.
use specula_datapath::design::{NodeId, TableId};

use crate::netlists::case::Case;

/// The run without the signals that do not matter, the rest renumbered.
pub fn without_unused(case: &Case) -> Case {
    let needed = needed(case);
    let mut less = case.clone();
    let mut numbers = vec![NodeId(0); needed.len()];
    let mut nodes = vec![];
    for (old, node) in case.design.nodes.iter().enumerate().filter(|(i, _)| needed[*i]) {
        numbers[old] = NodeId(nodes.len() as u32);
        nodes.push(node.clone());
    }
    let new = |id: NodeId| numbers[id.0 as usize];
    for (number, node) in nodes.iter_mut().enumerate() {
        node.op = node.op.map(new);
        node.name = format!("n{number}");
    }
    less.design.nodes = nodes;
    less.watched.iter_mut().for_each(|id| *id = new(*id));
    less.design.outputs =
        case.design.outputs.iter().filter(|o| needed[o.0 as usize]).map(|&o| new(o)).collect();
    // How long a run goes on is told by the stage of the signal that validity leaves by; if it
    // goes, another tells it.
    let stage = case.design.node(case.design.valid_out).stage;
    less.design.valid_out = if needed[case.design.valid_out.0 as usize] {
        new(case.design.valid_out)
    } else {
        case.design.valid
    };
    less.design.nodes[less.design.valid_out.0 as usize].stage = stage;
    drop_inputs(&mut less, &needed, &new);
    drop_tables(&mut less);
    less
}

fn needed(case: &Case) -> Vec<bool> {
    let mut needed = vec![false; case.design.nodes.len()];
    let mut open: Vec<NodeId> =
        case.watched.iter().copied().chain([case.design.valid, case.design.start]).collect();
    while let Some(id) = open.pop() {
        if !std::mem::replace(&mut needed[id.0 as usize], true) {
            open.extend(case.design.node(id).op.operands());
        }
    }
    needed
}

fn drop_inputs(less: &mut Case, needed: &[bool], new: &dyn Fn(NodeId) -> NodeId) {
    let kept: Vec<bool> =
        less.design.inputs.iter().map(|id| id.is_some_and(|id| needed[id.0 as usize])).collect();
    let keep =
        |values: &[i64]| values.iter().zip(&kept).filter(|(_, k)| **k).map(|(&v, _)| v).collect();
    less.packets.iter_mut().for_each(|packet| packet.inputs = keep(&packet.inputs));
    less.design.inputs = less
        .design
        .inputs
        .iter()
        .zip(&kept)
        .filter(|(_, k)| **k)
        .map(|(id, _)| id.map(new))
        .collect();
}

fn drop_tables(less: &mut Case) {
    use specula_datapath::design::Op;
    let mut tables = vec![];
    for node in &mut less.design.nodes {
        if let Op::LookUp(_, table) = &mut node.op {
            tables.push(less.design.tables[table.0 as usize].clone());
            *table = TableId(tables.len() as u32 - 1);
        }
    }
    less.design.tables = tables;
}
