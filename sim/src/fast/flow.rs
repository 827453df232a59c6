//! Where values come from: registers and ports become delays of the column they copy.
use std::collections::HashSet;

use specula_hdl::Design;
use specula_hdl::design::{Node, NodeId, Op, Register, WideRange};

/// A signal's value at clock c is `root`'s unregistered value at clock c - `delay`, and 0 before that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// The signal whose operator is evaluated.
    pub root: NodeId,
    /// Registers between.
    pub delay: u32,
}

/// Feedback that has a kernel of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recurrence {
    /// value = first ? start : state; state ← value + step, wrapped to the register `state`.
    Accumulate {
        /// The bit that loads.
        first: NodeId,
        /// What is loaded.
        start: NodeId,
        /// What is added.
        step: NodeId,
        /// The register.
        state: NodeId,
    },
    /// A register with an enable: state ← enable ? value : state.
    Hold {
        /// The enable.
        enable: NodeId,
        /// What is taken over.
        value: NodeId,
    },
}

/// The flow of values through a design.
pub struct Flow {
    /// Where each signal's value comes from.
    pub sources: Vec<Source>,
    /// The recurrence that computes a signal, where there is one.
    pub recurrences: Vec<Option<Recurrence>>,
}

/// Whether the operand comes later in the design: feedback.
fn looks_ahead(id: NodeId, node: &Node) -> bool {
    node.op.operands().any(|o| o >= id)
}

/// Whether wrapping changes nothing, as the operand's proven range says.
fn keeps_value(design: &Design, node: &Node) -> bool {
    match node.op {
        Op::Copy(_) => true,
        Op::Wrap(a) => {
            let (inner, outer) = (design.node(a).range, node.range);
            outer.low <= inner.low && inner.high <= outer.high
        }
        _ => false,
    }
}

impl Flow {
    /// Works out the flow of a design.
    pub fn of(design: &Design) -> Flow {
        let mut sources: Vec<Source> = vec![];
        let mut recurrences = vec![];
        for (id, node) in design.iter() {
            let delay = u32::from(node.register != Register::None);
            let copied = node.op.operands().next().filter(|_| keeps_value(design, node) && !looks_ahead(id, node));
            let constant = |o: NodeId| design.node(o).op.constant().is_some();
            sources.push(match copied.filter(|&o| !constant(o)) {
                Some(o) => {
                    let Source { root, delay: before } = sources[o.0 as usize];
                    Source { root, delay: before + delay }
                }
                None => Source { root: id, delay },
            });
            recurrences.push(recurrence(design, id, node));
        }
        Flow { sources, recurrences }
    }

    /// Forgets the recurrences of these signals; says whether there were any.
    pub fn drop_recurrences(&mut self, of: &HashSet<NodeId>) -> bool {
        let mut dropped = false;
        for id in of {
            dropped |= self.recurrences[id.0 as usize].take().is_some();
        }
        dropped
    }

    /// Where a signal's value comes from.
    pub fn source(&self, id: NodeId) -> Source {
        self.sources[id.0 as usize]
    }

    /// The signals that a root's evaluation reads.
    pub fn operands(&self, design: &Design, root: NodeId) -> Vec<NodeId> {
        match self.recurrences[root.0 as usize] {
            Some(Recurrence::Accumulate { first, start, step, .. }) => vec![first, start, step],
            Some(Recurrence::Hold { enable, value }) => vec![enable, value],
            None => design.node(root).op.operands().collect(),
        }
    }
}

fn recurrence(design: &Design, id: NodeId, node: &Node) -> Option<Recurrence> {
    let Op::Select(condition, yes, no) = node.op else { return None };
    if no == id && node.register == Register::Data {
        return Some(Recurrence::Hold { enable: condition, value: yes });
    }
    let state = design.node(no);
    let Op::Wrap(next) = state.op else { return None };
    let Op::Add(value, step) = design.node(next).op else { return None };
    let plain = [id, next].iter().all(|&n| design.node(n).register == Register::None);
    let closes = value == id && step != no && step != id && state.register == Register::Data && no < id;
    (plain && closes).then_some(Recurrence::Accumulate { first: condition, start: yes, step, state: no })
}

/// Range of an operator's result before it is brought to the signal's width.
pub fn raw_range(design: &Design, op: Op) -> WideRange {
    use specula_hdl::design::Range;
    let range = |id: NodeId| design.node(id).range;
    let same = |r: Range| r.into();
    match op {
        Op::Input => same(Range::new(0, 0)),
        Op::Constant(value) => same(Range::single(value)),
        Op::Copy(a) | Op::Wrap(a) => same(range(a)),
        Op::Add(a, b) => range(a).plus(range(b)),
        Op::Sub(a, b) => range(a).minus(range(b)),
        Op::Mul(a, b) if a == b => range(a).squared(),
        Op::Mul(a, b) => range(a).times(range(b)),
        Op::ShiftLeft(a, bits) => range(a).shifted_left(bits),
        Op::ShiftRight(a, bits) => same(range(a).shifted_right(bits)),
        Op::LessThan(..) | Op::Not(_) => same(Range::new(0, 1)),
        Op::And(a, b) | Op::Or(a, b) => same(bits_of(range(a)).hull(bits_of(range(b)))),
        Op::Select(_, a, b) => same(range(a).hull(range(b))),
        Op::LookUp(_, table) => {
            let entries = design.tables[table.0 as usize].entries.iter().copied();
            same(entries.map(Range::single).fold(Range::single(0), Range::hull))
        }
    }
}

/// Every value of as many bits as the range needs.
fn bits_of(range: specula_hdl::design::Range) -> specula_hdl::design::Range {
    specula_hdl::design::Range::whole(range.width(), range.signed())
}
