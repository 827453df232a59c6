//! What can be taken away from a run.
use specula_datapath::design::{NodeId, Op, Range, Register, ScopeId};
use specula_sim::fast::Settings;

use super::rebuild::without_unused;
use crate::netlists::case::{Case, Subject};

/// A way of making a run smaller, at one of several places.
pub struct Reduction {
    pub places: fn(&Case) -> usize,
    pub at: fn(&Case, usize) -> Option<Case>,
}

const NODES: fn(&Case) -> usize = |case| case.design.nodes.len();

pub const ALL: &[Reduction] = &[
    Reduction { places: |case| case.watched.len(), at: unwatched },
    Reduction { places: |_| 1, at: |case, _| Some(without_unused(case)) },
    Reduction { places: |_| 1, at: flat },
    Reduction { places: |_| 1, at: whole_run },
    Reduction { places: |_| 1, at: without_bubbles },
    Reduction { places: |_| BATCHES.len(), at: with_batch },
    Reduction { places: |_| 1, at: one_thread },
    Reduction { places: NODES, at: constant },
    Reduction { places: NODES, at: opened },
    Reduction { places: NODES, at: copied },
    Reduction { places: NODES, at: unregistered },
    Reduction { places: |_| 1, at: |case, _| Some(without_unused(case)) },
    Reduction { places: |case| case.packets.len(), at: fewer_spans },
    Reduction { places: |case| case.packets.len(), at: shorter_span },
    Reduction { places: |case| case.packets.len() * case.design.inputs.len(), at: simpler_input },
    Reduction { places: |_| 1, at: less_idle },
];

const BATCHES: [usize; 6] = [64, 16, 8, 4, 2, 1];

fn unwatched(case: &Case, at: usize) -> Option<Case> {
    let mut less = case.clone();
    less.watched.remove(at);
    (!less.watched.is_empty()).then_some(less)
}

/// All in the core.
fn flat(case: &Case, _: usize) -> Option<Case> {
    let mut less = case.clone();
    less.design.scopes.truncate(1);
    less.design.nodes.iter_mut().for_each(|node| node.scope = ScopeId::TOP);
    Some(less)
}

fn whole_run(case: &Case, _: usize) -> Option<Case> {
    Some(Case { window: None, ..case.clone() })
}

fn without_bubbles(case: &Case, _: usize) -> Option<Case> {
    Some(Case { bubbles: None, ..case.clone() })
}

fn with_batch(case: &Case, at: usize) -> Option<Case> {
    let Subject::Fast(settings) = case.subject else { return None };
    let batch = BATCHES[at];
    (batch < settings.batch)
        .then(|| Case { subject: Subject::Fast(Settings { batch, ..settings }), ..case.clone() })
}

fn one_thread(case: &Case, _: usize) -> Option<Case> {
    let Subject::Fast(settings) = case.subject else { return None };
    Some(Case { subject: Subject::Fast(Settings { threads: 1, ..settings }), ..case.clone() })
}

/// The run with another operator at node `at`, if there is not one of its kind yet.
fn replaced(case: &Case, at: usize, op: Op, range: Range) -> Option<Case> {
    let mut less = case.clone();
    let node = &mut less.design.nodes[at];
    if at < 2 || matches!(node.op, Op::Constant(_)) {
        return None;
    }
    (node.op, node.range, node.register) = (op, range, Register::None);
    Some(less)
}

fn constant(case: &Case, at: usize) -> Option<Case> {
    let range = case.design.nodes[at].range;
    let value = 0.clamp(range.low, range.high);
    let id = NodeId(at as u32);
    if case.watched.contains(&id) || case.design.inputs.contains(&Some(id)) {
        return None;
    }
    replaced(case, at, Op::Constant(value), Range::single(value))
}

/// An input in the place of a signal, which goes up and down.
fn opened(case: &Case, at: usize) -> Option<Case> {
    let node = &case.design.nodes[at];
    if node.op == Op::Input || !node.range.contains(0) || node.scope != ScopeId::TOP {
        return None;
    }
    let mut less = replaced(case, at, Op::Input, node.range)?;
    less.design.inputs.push(Some(NodeId(at as u32)));
    let values = [node.range.high, node.range.low, 0];
    less.packets.iter_mut().enumerate().for_each(|(i, packet)| packet.inputs.push(values[i % 3]));
    Some(less)
}

/// A copy of an operand in the place of an operator.
fn copied(case: &Case, at: usize) -> Option<Case> {
    let node = &case.design.nodes[at];
    let within = |o: &NodeId| {
        let inner = case.design.node(*o).range;
        (o.0 as usize) < at && node.range.low <= inner.low && inner.high <= node.range.high
    };
    let operand = node.op.operands().find(within)?;
    if matches!(node.op, Op::Copy(_)) && !node.registered() {
        return None;
    }
    replaced(case, at, Op::Copy(operand), node.range)
}

fn unregistered(case: &Case, at: usize) -> Option<Case> {
    let node = &case.design.nodes[at];
    let possible = node.registered() && node.op.operands().all(|o| (o.0 as usize) < at);
    if possible { replaced(case, at, node.op, node.range) } else { None }
}

fn fewer_spans(case: &Case, at: usize) -> Option<Case> {
    let mut less = case.clone();
    less.packets.remove(at);
    (!less.packets.is_empty()).then_some(less)
}

fn shorter_span(case: &Case, at: usize) -> Option<Case> {
    let mut less = case.clone();
    let packet = &mut less.packets[at];
    let before = std::mem::replace(&mut packet.length, 1);
    (before > 1).then_some(less)
}

fn simpler_input(case: &Case, at: usize) -> Option<Case> {
    let inputs = case.design.inputs.len();
    let mut less = case.clone();
    let value = less.packets[at / inputs].inputs.get_mut(at % inputs)?;
    let before = std::mem::replace(value, 0);
    (before != 0).then_some(less)
}

fn less_idle(case: &Case, _: usize) -> Option<Case> {
    let mut less = case.clone();
    let idle = &mut less.design.nodes[case.design.valid_out.0 as usize].stage;
    *idle = idle.checked_sub(1)?;
    Some(less)
}
