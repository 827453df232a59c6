//! Operators as a target has them: products in multiplier blocks, products with constants as sums,
//! long sums in pieces, comparisons as signs of differences.
//!
//! The pass makes a graph of a graph. What a value stands for stays: each value of the new graph that
//! takes the place of one has its raw values, its name and its real values, but for products whose sign
//! a sum takes over. What goes round a loop stays as it is, accumulators apart.
mod accumulator;
mod compare;
mod constant;
mod interval;
mod product;
mod sign;
mod sum;

use std::collections::{HashMap, HashSet};

use rustc_hash::FxHashSet;

use super::loops::loops;
use crate::design::{NodeId, Op, Range, ScopeId, WideRange};
use crate::format::WIDEST_SIGNAL;
use crate::graph::{Graph, Pace, Value};
use crate::names::unique;
use crate::target::Target;
use accumulator::{Accumulator, accumulators, changing};
use sign::Negated;

/// A graph of a target's operators.
pub struct Lowered {
    /// The graph.
    pub graph: Graph,
    /// Carries from a piece of a sum to the next one, those of accumulators apart.
    pub carries: u32,
}

/// The graph with the operators of a target at a clock; itself where no delays of the target are
/// known.
pub fn lowered(graph: &Graph, target: &Target, mhz: f64) -> Lowered {
    let Some(fabric) = &target.fabric else {
        return Lowered { graph: graph.clone(), carries: 0 };
    };
    let widest = |period| fabric.widest_sum(period).unwrap_or(1).max(NARROWEST_PIECE);
    let period = 1000.0 / mhz;
    // Without a gate before it, the sum of a loop goes to two registers.
    let in_loop = if target.gated_sum.is_some() { period } else { period - fabric.net };
    let widest_sums = (widest(period), widest(in_loop));
    let loops = loops(graph);
    let negated = Negated::of(graph, &loops);
    let mut lowering = Lowering::new(graph, target, widest_sums);
    let accumulators = accumulators(graph);
    // The rest of an accumulator's loop is no loop any more.
    let states = accumulators.values().map(|of| loops[of.state.0 as usize]);
    let opened: HashSet<Option<usize>> = states.collect();
    let rounds: HashSet<usize> =
        (0..loops.len()).filter(|&index| opened.contains(&loops[index])).collect();
    for (index, value) in graph.values.iter().enumerate() {
        let id = NodeId(index as u32);
        let own =
            lowering.operands_of(&Value { op: negated.with_signs(value.op), ..value.clone() });
        let new = match (accumulators.get(&id), loops[index]) {
            (Some(accumulator), _) => lowering.accumulated(own, *accumulator),
            (None, Some(_)) if !rounds.contains(&index) => lowering.in_loop(own),
            (None, _) => match negated.negative(graph, id) {
                Some(factors) => lowering.negative_product(own, factors),
                None => lowering.operator(own),
            },
        };
        lowering.new.push(new);
    }
    lowering.finish(&accumulators)
}

/// Bits below which a sum is not cut any further, however fast the clock.
const NARROWEST_PIECE: u32 = 8;

/// A graph that is being made of another.
struct Lowering<'a> {
    from: &'a Graph,
    target: &'a Target,
    /// How parts of operators are clocked.
    pace: Pace,
    /// Most bits of a sum in one piece.
    widest_sum: u32,
    /// Most bits of one in a loop.
    widest_loop: u32,
    /// Carries from a piece of a sum to the next one.
    carries: u32,
    /// The new graph; its groups and real values are those of the old one until the end.
    graph: Graph,
    /// The new value of each old one.
    new: Vec<NodeId>,
    names: FxHashSet<(ScopeId, String)>,
    /// Odd multiples of values of a unit that are there, by value and factor.
    multiples: HashMap<(ScopeId, NodeId, i64), NodeId>,
    /// Which old values may change from pixel to pixel of a span.
    changing: Vec<bool>,
}

/// Where a new value belongs, and what its name begins with.
#[derive(Clone, Copy)]
struct Place<'a> {
    scope: ScopeId,
    name: &'a str,
    fraction_bits: u32,
}

impl<'a> Lowering<'a> {
    fn new(
        from: &'a Graph,
        target: &'a Target,
        (widest_sum, widest_loop): (u32, u32),
    ) -> Lowering<'a> {
        let names = from.values.iter().map(|value| (value.scope, value.name.clone()));
        let instances =
            from.units.iter().filter_map(|unit| Some((unit.parent?, unit.instance.clone())));
        let scopes = (0..from.units.len() as u32).map(ScopeId);
        let control =
            scopes.flat_map(|scope| crate::names::CONTROL.map(|name| (scope, name.to_owned())));
        Lowering {
            from,
            target,
            pace: Pace::Target,
            widest_sum,
            widest_loop,
            carries: 0,
            names: names.chain(instances).chain(control).collect(),
            graph: Graph { values: vec![], ..from.clone() },
            new: vec![],
            multiples: HashMap::new(),
            changing: changing(from),
        }
    }

    /// A value of the old graph that reads values of the new one; registers of loops read what
    /// comes later, and read it when all is there.
    fn operands_of(&self, value: &Value) -> Value {
        let new = |id: NodeId| self.new.get(id.0 as usize).copied().unwrap_or(id);
        Value { op: value.op.map(new), ..value.clone() }
    }

    /// A value outside loops.
    fn operator(&mut self, value: Value) -> NodeId {
        match value.op {
            Op::Mul(a, b) => self.product(value, [a, b]),
            Op::Add(..) | Op::Sub(..) => self.sum(value),
            Op::LessThan(a, b) => self.comparison(value, [a, b]),
            _ => self.push(value),
        }
    }

    /// A value of a loop, whose parts are all in its one clock: sums are not cut.
    fn in_loop(&mut self, value: Value) -> NodeId {
        let outside = (self.pace, self.widest_sum);
        (self.pace, self.widest_sum) = (Pace::Wire, WIDEST_SIGNAL);
        let new = match value.op {
            Op::Mul(..) => self.operator(value),
            _ => self.push(value),
        };
        (self.pace, self.widest_sum) = outside;
        new
    }

    /// The finished graph.
    fn finish(mut self, accumulators: &HashMap<NodeId, Accumulator>) -> Lowered {
        let new = |id: NodeId| self.new[id.0 as usize];
        let opened: HashSet<NodeId> = accumulators.values().map(|of| of.state).collect();
        for (old, value) in self.from.values.iter().enumerate() {
            if self.from.is_state(value) && !opened.contains(&NodeId(old as u32)) {
                let own = new(NodeId(old as u32));
                self.graph.values[own.0 as usize].op = value.op.map(new);
            }
        }
        let graph = &mut self.graph;
        graph.groups.iter_mut().flatten().for_each(|id| *id = new(*id));
        graph.reals.iter_mut().for_each(|real| real.value = new(real.value));
        graph.inputs.iter_mut().flatten().for_each(|id| *id = new(*id));
        graph.assumptions.iter_mut().for_each(|assumption| assumption.node = new(assumption.node));
        for id in [&mut graph.valid, &mut graph.start, &mut graph.steps, &mut graph.leaves] {
            *id = new(*id);
        }
        Lowered { graph: self.graph, carries: self.carries }
    }

    fn push(&mut self, value: Value) -> NodeId {
        self.graph.values.push(value);
        NodeId(self.graph.values.len() as u32 - 1)
    }

    fn value(&self, id: NodeId) -> &Value {
        self.graph.value(id)
    }

    fn range(&self, id: NodeId) -> Range {
        self.value(id).range
    }

    fn constant(&self, id: NodeId) -> Option<i64> {
        self.value(id).op.constant()
    }

    /// A new value, named after the one that it is a part of.
    fn emit(&mut self, at: Place, op: Op, range: impl Into<WideRange>, part: &str) -> NodeId {
        let value = self.part(at, op, narrowed(range.into()), part);
        self.finished(value)
    }

    /// An operator's result whatever its operands are, of which a value takes the low bits.
    fn emit_whole(&mut self, at: Place, op: Op, range: Range) -> NodeId {
        let value = self.part(at, op, range, "whole");
        self.push(value)
    }

    fn part(&mut self, at: Place, op: Op, range: Range, part: &str) -> Value {
        let name = unique(&mut self.names, at.scope, &format!("{}_{part}", at.name));
        let (pace, together, fraction_bits) = (self.pace, None, at.fraction_bits);
        let (scope, still, named) = (at.scope, self.graph.gives_still(op, pace), false);
        Value { op, pace, together, range, fraction_bits, still, scope, name, named }
    }

    fn integer(&mut self, at: Place, value: i64) -> NodeId {
        let (op, range) = (Op::Constant(value), Range::single(value));
        let name = String::new();
        let (pace, together, fraction_bits) = (Pace::Wire, None, at.fraction_bits);
        let (scope, still, named) = (at.scope, true, true);
        self.push(Value { op, pace, together, range, fraction_bits, still, scope, name, named })
    }

    /// A value divided by 2^`bits`, rounded down.
    fn high(&mut self, at: Place, id: NodeId, bits: u32) -> NodeId {
        if bits == 0 {
            return id;
        }
        if let Some((high, _)) = self.joined(id).filter(|(_, join)| *join == bits).map(|j| j.0) {
            return high;
        }
        if let Op::ShiftLeft(from, by) = self.value(id).op {
            match by.cmp(&bits) {
                std::cmp::Ordering::Equal => return from,
                std::cmp::Ordering::Greater => return self.shifted(at, from, by - bits),
                std::cmp::Ordering::Less => return self.high(at, from, bits - by),
            }
        }
        let range = self.range(id).shifted_right(bits);
        match (self.constant(id), range.only()) {
            (Some(value), _) => self.integer(at, value >> bits),
            (_, Some(value)) => self.integer(at, value),
            _ => self.emit(at, Op::ShiftRight(id, bits), range, "high"),
        }
    }

    /// The low `bits` of a value, as a number without sign.
    fn low(&mut self, at: Place, id: NodeId, bits: u32) -> NodeId {
        let range = self.range(id);
        if range.low >= 0 && range.width() <= bits {
            return id;
        }
        if let Some((_, low)) = self.joined(id).filter(|(_, join)| *join == bits).map(|j| j.0) {
            return low;
        }
        if let Some(value) = self.constant(id) {
            return self.integer(at, crate::design::wrapped(value, bits, false));
        }
        if self.zeros(id) >= bits {
            return self.integer(at, 0);
        }
        self.emit(at, Op::Wrap(id), Range::whole(bits, false), "low")
    }

    /// A value times 2^`bits`.
    fn shifted(&mut self, at: Place, id: NodeId, bits: u32) -> NodeId {
        if bits == 0 {
            return id;
        }
        let range = self.range(id).shifted_left(bits);
        match self.constant(id) {
            Some(value) => self.integer(at, value << bits),
            None => self.emit(at, Op::ShiftLeft(id, bits), range, "shifted"),
        }
    }

    /// A value times 2^`bits`, and one of so many bits without sign behind it.
    fn joined_with(&mut self, at: Place, high: NodeId, low: NodeId, bits: u32) -> Op {
        let high = self.shifted(at, high, bits);
        Op::Or(high, low)
    }

    /// What a value was put together of: high and low part, and the bits of the low one.
    fn joined(&self, id: NodeId) -> Option<((NodeId, NodeId), u32)> {
        let Op::Or(high, low) = self.value(id).op else { return None };
        let Op::ShiftLeft(from, bits) = self.value(high).op else { return None };
        self.is_join(self.value(id).op).then_some(((from, low), bits))
    }

    fn is_join(&self, op: Op) -> bool {
        op.is_join(|id: NodeId| (self.value(id).op, self.range(id)))
    }

    /// Bits at the right that are always 0.
    fn zeros(&self, id: NodeId) -> u32 {
        match self.value(id).op {
            Op::Constant(0) => 63,
            Op::Constant(value) => value.trailing_zeros(),
            Op::ShiftLeft(from, bits) => bits + self.zeros(from).min(32),
            _ => 0,
        }
    }
}

/// The place of a value's parts.
fn place(value: &Value) -> Place<'_> {
    Place { scope: value.scope, name: &value.name, fraction_bits: value.fraction_bits }
}

/// The range of a part of a value. A value fits 63 bits, and parts of it do; of one that did not, the
/// low bits would be those that the value needs.
fn narrowed(range: WideRange) -> Range {
    range.narrow().unwrap_or(Range::whole(WIDEST_SIGNAL, true))
}
