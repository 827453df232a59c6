//! Where values come from: registers and ports become delays of the column they copy.
use std::collections::{HashMap, HashSet};

use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, Register, WideRange};
use specula_kernels::{Extreme, Second};

/// A signal's value at clock c is `root`'s unregistered value at clock c - `delay`, and 0 before
/// that.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// The signal whose operator is evaluated.
    pub root: NodeId,
    /// Registers between.
    pub delay: u32,
}

impl Source {
    /// The same, some clocks later.
    pub fn later(self, clocks: u32) -> Source {
        Source { delay: self.delay + clocks, ..self }
    }
}

/// Feedback that has a kernel of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recurrence {
    /// value = first ? start : state; state ← valid ? value + step : state, wrapped to the register
    /// `state`. Behind it there may be other registers, each of which takes over what the one before
    /// it held, where `valid` is 1: the last one is then the state that is read.
    Accumulate {
        /// The bit with which the registers take over what is next.
        valid: NodeId,
        /// The bit that loads.
        first: NodeId,
        /// What is loaded.
        start: NodeId,
        /// What is added.
        step: NodeId,
        /// The first register.
        state: NodeId,
        /// How many registers there are.
        registers: usize,
    },
    /// A register with an enable: state ← enable ? value : state, wrapped to its width.
    Hold {
        /// The enable.
        enable: NodeId,
        /// What is taken over.
        value: NodeId,
    },
}

/// What a fused operator reads: 32-bit lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// A signal.
    Variable(Source),
    /// A number.
    Constant(i32),
}

impl Factor {
    /// The same, some clocks later.
    pub fn later(self, clocks: u32) -> Factor {
        match self {
            Factor::Variable(source) => Factor::Variable(source.later(clocks)),
            constant => constant,
        }
    }
}

/// An operator that others have been fused into.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fused {
    /// A sum of up to three products of these factors, the second added or subtracted.
    Products(Vec<[Factor; 2]>, Second),
    /// The smaller or larger of two.
    Extreme(Extreme, [Factor; 2]),
}

/// The flow of values through a design.
pub struct Flow {
    /// Where each signal's value comes from.
    sources: Vec<Source>,
    /// The recurrence that computes a signal, where there is one.
    pub recurrences: Vec<Option<Recurrence>>,
    /// What has been fused into a signal's operator and takes its place.
    pub fused: HashMap<NodeId, Fused>,
}

impl Fused {
    fn factors(&self) -> &[Factor] {
        match self {
            Fused::Products(products, _) => products.as_flattened(),
            Fused::Extreme(_, factors) => factors,
        }
    }

    fn factors_mut(&mut self) -> &mut [Factor] {
        match self {
            Fused::Products(products, _) => products.as_flattened_mut(),
            Fused::Extreme(_, factors) => factors,
        }
    }

    /// The signals that it reads.
    fn sources(&self) -> impl Iterator<Item = Source> {
        self.factors().iter().filter_map(|factor| {
            if let Factor::Variable(source) = factor { Some(*source) } else { None }
        })
    }

    fn sources_mut(&mut self) -> impl Iterator<Item = &mut Source> {
        self.factors_mut().iter_mut().filter_map(|factor| {
            if let Factor::Variable(source) = factor { Some(source) } else { None }
        })
    }
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
            let copied = node
                .op
                .operands()
                .next()
                .filter(|_| keeps_value(design, node) && !looks_ahead(id, node));
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
        Flow { sources, recurrences, fused: HashMap::new() }
    }

    /// Has the signals that came from `id` come from `source`, and as many clocks later as before.
    pub fn redirect(&mut self, id: NodeId, source: Source) {
        let fused = self.fused.values_mut().flat_map(Fused::sources_mut);
        for s in self.sources.iter_mut().chain(fused).filter(|s| s.root == id) {
            *s = source.later(s.delay);
        }
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

    /// What a root's evaluation reads.
    pub fn operands(&self, design: &Design, root: NodeId) -> Vec<Source> {
        let sources = |ids: &[NodeId]| ids.iter().map(|&id| self.source(id)).collect();
        match (self.fused.get(&root), self.recurrences[root.0 as usize]) {
            (Some(fused), _) => fused.sources().collect(),
            (None, Some(Recurrence::Accumulate { valid, first, start, step, .. })) => {
                sources(&[valid, first, start, step])
            }
            (None, Some(Recurrence::Hold { enable, value })) => sources(&[enable, value]),
            (None, None) => design.node(root).op.operands().map(|id| self.source(id)).collect(),
        }
    }
}

fn recurrence(design: &Design, id: NodeId, node: &Node) -> Option<Recurrence> {
    if let (Some((enable, value)), Register::Data) = (node.clock_enable(id), node.register) {
        return Some(Recurrence::Hold { enable, value });
    }
    accumulator(design, id, node)
}

/// The accumulator that computes the value `id`.
fn accumulator(design: &Design, id: NodeId, node: &Node) -> Option<Recurrence> {
    let Op::Select(first, start, oldest) = node.op else { return None };
    let (valid, _) = design.node(oldest).clock_enable(oldest)?;
    let range = design.node(oldest).range;
    let mut state = oldest;
    // Feedback goes back over a pixel, in whose clocks each register of a row has its turn.
    for registers in 1..=design.interval as usize {
        let register = design.node(state);
        let (enable, next) = register.clock_enable(state)?;
        if enable != valid || register.range != range || register.register != Register::Data {
            return None;
        }
        if let Op::Add(value, step) = design.node(next).op {
            let plain = [id, next].iter().all(|&n| design.node(n).register == Register::None);
            let closes = value == id && step != id && plain;
            return closes.then_some(Recurrence::Accumulate {
                valid,
                first,
                start,
                step,
                state,
                registers,
            });
        }
        state = next;
    }
    None
}

/// Range of an operator's result before it is brought to the signal's width.
pub fn raw_range(design: &Design, op: Op) -> WideRange {
    use specula_datapath::design::Range;
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
fn bits_of(range: specula_datapath::design::Range) -> specula_datapath::design::Range {
    specula_datapath::design::Range::whole(range.width(), range.signed())
}
