//! Accumulators: a value that a step is added to with each pixel goes round through an adder alone.
//!
//! A loop has a multiplexer besides the adder as it is described, since the first pixel of a span
//! begins anew. Taken out of the loop, it chooses what is added to a register that is 0 for such a
//! pixel, since it was cleared a clock before:
//!
//! ```text
//! value(p) = start(p) or value(p - 1) + step(p - 1)
//!          = before(p) + added(p)      before(p) = 0        or value(p - 1)
//!                                      added(p)  = start(p) or step(p - 1)
//! ```
//!
//! Where the target's carry chains can clear a summand, the adder does so itself, and the register is
//! the only one that the sum goes to:
//!
//! ```text
//! value(p) = (0 for the first pixel, else value(p - 1)) + added(p)
//! ```
//!
//! The sum may be in pieces, each with a register of its own, a clock after the one on its right.
use std::collections::HashMap;

use super::interval::contains;
use super::{Lowering, Place, narrowed, place};
use crate::design::{NodeId, Op, Range};
use crate::graph::{Graph, GroupId, Pace, Value};

/// An accumulator of the old graph.
#[derive(Clone, Copy, Debug)]
pub struct Accumulator {
    /// The register.
    pub state: NodeId,
    /// 1 for the first pixel of a span.
    first: NodeId,
    start: NodeId,
    step: NodeId,
}

/// The accumulators of a graph, by the values that they accumulate.
pub fn accumulators(graph: &Graph) -> HashMap<NodeId, Accumulator> {
    let mut readers: HashMap<NodeId, Vec<NodeId>> = HashMap::new();
    for (value, index) in graph.values.iter().zip(0..) {
        value.op.operands().for_each(|id| readers.entry(id).or_default().push(NodeId(index)));
    }
    let only_reader = |id: NodeId| match readers.get(&id).map(Vec::as_slice) {
        Some(&[one]) => Some(one),
        _ => None,
    };
    let states = graph.values.iter().zip(0..).filter(|_| graph.loop_registers() == 1);
    let found = states.filter_map(|(state, index)| {
        let (Pace::Feedback, Op::Wrap(next)) = (state.pace, state.op) else { return None };
        let value = only_reader(NodeId(index))?;
        let Op::Select(first, start, kept) = graph.value(value).op else { return None };
        let Op::Add(from, step) = graph.value(next).op else { return None };
        let closes = kept == NodeId(index) && from == value;
        closes.then_some((value, Accumulator { state: kept, first, start, step }))
    });
    found.collect()
}

/// Whether each value of a graph may change from pixel to pixel of a span.
pub fn changing(graph: &Graph) -> Vec<bool> {
    let mut changing = vec![false; graph.values.len()];
    for (index, value) in graph.values.iter().enumerate() {
        let control = [graph.valid, graph.start, graph.steps].contains(&NodeId(index as u32));
        let operand = value.op.operands().any(|id| changing[id.0 as usize]);
        changing[index] = control || graph.is_state(value) || operand;
    }
    changing
}

impl Lowering<'_> {
    /// What an accumulator accumulates.
    pub(super) fn accumulated(&mut self, value: Value, of: Accumulator) -> NodeId {
        let at = place(&value);
        let step = if self.changing[of.step.0 as usize] {
            self.of_pixel_before(at, of.step)
        } else {
            self.new[of.step.0 as usize]
        };
        let [first, start] = [of.first, of.start].map(|id| self.new[id.0 as usize]);
        let range = self.range(start).hull(self.range(step));
        let added = self.emit(at, Op::Select(first, start, step), range, "added");
        let width = value.range.width();
        // A piece has a carry on its left and a bit for one on its right.
        let pieces = width.div_ceil(self.widest_loop - 2);
        let op = self.pieces(at, (first, added), value.range, width.div_ceil(pieces));
        self.finished(Value { op, pace: Pace::Wire, together: None, ..value })
    }

    /// What a value was for the pixel before.
    fn of_pixel_before(&mut self, at: Place, id: NodeId) -> NodeId {
        let now = self.new[id.0 as usize];
        let before = self.emit(at, Op::Copy(now), self.range(now), "step_before");
        self.kept(before, Pace::Feedback);
        before
    }

    /// Makes a register that is kept from pixel to pixel of a value.
    fn kept(&mut self, id: NodeId, pace: Pace) {
        self.graph.groups.push(vec![]);
        let group = GroupId(self.graph.groups.len() as u32 - 1);
        let value = &mut self.graph.values[id.0 as usize];
        (value.pace, value.together, value.still) = (pace, Some(group), false);
    }

    /// The accumulated value in pieces of so many bits from the right on.
    fn pieces(
        &mut self,
        at: Place,
        (first, added): (NodeId, NodeId),
        range: Range,
        bits: u32,
    ) -> Op {
        let mut carry = self.integer(at, 0);
        let mut done: Option<(NodeId, u32)> = None;
        let mut rest = added;
        loop {
            let below = done.map_or(0, |(_, bits)| bits);
            let last = range.width() - below <= bits;
            let shape = if last {
                Range::whole(range.width() - below, range.signed())
            } else {
                Range::whole(bits, false)
            };
            // What the last piece does not keep, its adder need not have.
            let part = if !last {
                self.low(at, rest, bits)
            } else if contains(shape, self.range(rest)) {
                rest
            } else {
                self.emit(at, Op::Wrap(rest), shape, "low")
            };
            let (sum, piece) = self.piece(at, first, (part, carry), shape);
            let joined = match done {
                None => piece,
                Some((low, below)) if last => return self.joined_with(at, piece, low, below),
                Some((low, below)) => {
                    let op = self.joined_with(at, piece, low, below);
                    self.emit(at, op, Range::whole(below + bits, false), "pieces")
                }
            };
            if last {
                return Op::Copy(joined);
            }
            carry = self.high(at, sum, bits);
            rest = self.high(at, rest, bits);
            done = Some((joined, below + bits));
        }
    }

    /// One piece: the sum with its carry, and what of it goes round.
    fn piece(
        &mut self,
        at: Place,
        first: NodeId,
        summand: (NodeId, NodeId),
        shape: Range,
    ) -> (NodeId, NodeId) {
        match self.target.gated_sum {
            Some(_) => self.gated_piece(at, first, summand, shape),
            None => self.cleared_piece(at, first, summand, shape),
        }
    }

    /// A piece whose adder clears what the pixel before gave.
    fn gated_piece(
        &mut self,
        at: Place,
        first: NodeId,
        (added, carry): (NodeId, NodeId),
        shape: Range,
    ) -> (NodeId, NodeId) {
        let zero = self.integer(at, 0);
        let held = self.emit(at, Op::Copy(zero), shape.hull(Range::single(0)), "held");
        self.kept(held, Pace::Feedback);
        let is_first_piece = self.constant(carry) == Some(0);
        // The bit beside the carry is cleared too: no piece of a first pixel gives a carry, since 0
        // is added to.
        let one = self.integer(at, 1);
        let [before, added] = if is_first_piece {
            [held, added]
        } else {
            [(held, one), (added, carry)].map(|(id, bit)| self.with_bit(at, id, bit))
        };
        let range = self.range(before).hull(Range::single(0));
        let gated = self.emit(at, Op::Select(first, zero, before), range, "before");
        self.paced(gated, Pace::Gate);
        let range = self.range(gated).plus(self.range(added));
        let sum = self.emit(at, Op::Add(gated, added), range, "sum");
        let sum = if is_first_piece {
            sum
        } else {
            // A sum of parts of a value that fits 63 bits.
            let range = narrowed(range).shifted_right(1);
            self.emit(at, Op::ShiftRight(sum, 1), range, "high")
        };
        let next = self.emit(at, Op::Wrap(sum), shape, "next");
        self.graph.values[held.0 as usize].op = Op::Copy(next);
        let piece = self.emit(at, Op::Copy(held), self.range(held), "piece");
        self.paced(piece, Pace::After);
        (sum, piece)
    }

    /// Says how a new value is clocked.
    fn paced(&mut self, id: NodeId, pace: Pace) {
        self.graph.values[id.0 as usize].pace = pace;
    }

    /// A piece whose register is cleared for a first pixel.
    fn cleared_piece(
        &mut self,
        at: Place,
        first: NodeId,
        (added, carry): (NodeId, NodeId),
        shape: Range,
    ) -> (NodeId, NodeId) {
        let zero = self.integer(at, 0);
        let before =
            self.emit(at, Op::Select(first, zero, zero), shape.hull(Range::single(0)), "before");
        self.kept(before, Pace::Cleared);
        let sum = match self.constant(carry) {
            Some(0) => {
                let range = self.range(before).plus(self.range(added));
                self.emit(at, Op::Add(before, added), range, "sum")
            }
            _ => self.sum_with_carry(at, [before, added], carry),
        };
        let piece = self.emit(at, Op::Wrap(sum), shape, "piece");
        self.graph.values[before.0 as usize].op = Op::Select(first, zero, piece);
        (sum, piece)
    }

    /// Two values and a bit, in one carry chain.
    fn sum_with_carry(&mut self, at: Place, [a, b]: [NodeId; 2], carry: NodeId) -> NodeId {
        let one = self.integer(at, 1);
        let [a, b] = [(a, one), (b, carry)].map(|(id, bit)| self.with_bit(at, id, bit));
        let range = self.range(a).plus(self.range(b));
        let twice = self.emit(at, Op::Add(a, b), range, "twice_sum");
        // A sum of parts of a value that fits 63 bits.
        let range = narrowed(range).shifted_right(1);
        self.emit(at, Op::ShiftRight(twice, 1), range, "sum")
    }
}
