//! Choices and gates in look-up tables of four inputs. A gate that one other alone reads is part of
//! that one's look-up tables where all inputs together are four at most; so is, on some targets, a
//! sum, whose look-up tables have room for what is made of it.
use std::collections::{BTreeSet, HashSet};

use super::Wiring;
use crate::design::{NodeId, Op};
use crate::target::Carry;

/// Inputs of a look-up table.
const INPUTS: usize = 4;

/// The gates of a design.
pub struct Gates {
    /// Their look-up tables, without those that they share with sums.
    pub luts: u64,
    /// The inputs of each bit of a gate's look-up tables; none of signals that are no gates.
    inputs: Vec<Option<BTreeSet<Input>>>,
    /// Gates and sums that are part of a gate's look-up tables.
    absorbed: HashSet<NodeId>,
}

/// An input of a look-up table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Input {
    /// A signal's bit.
    Signal(NodeId),
    /// The carry into a sum's bit.
    Carry(NodeId),
}

impl Gates {
    /// Those of a design whose sums have their carries there.
    pub fn of(wiring: &Wiring, carry: Carry) -> Gates {
        let count = wiring.design.nodes.len();
        let mut gates = Gates { luts: 0, inputs: vec![None; count], absorbed: HashSet::new() };
        let held = held(wiring);
        let is_gate = |&(id, op): &(NodeId, Op)| match op {
            Op::And(..) | Op::Not(_) => true,
            Op::Or(..) => !wiring.is_join(op),
            Op::Select(..) => !held.contains(&id) && !is_control(wiring, id, op),
            _ => false,
        };
        let mut shared = 0;
        let all: Vec<(NodeId, Op)> = wiring.operators().filter(is_gate).collect();
        for &(id, op) in &all {
            let mut inputs = gates.cover(wiring, op);
            let sum = match carry {
                Carry::Beside => gates.add_sum(wiring, &mut inputs),
                Carry::Behind | Carry::Pair => None,
            };
            shared += sum.map_or(0, |sum| wiring.needed_bits(sum).min(wiring.needed_bits(id)));
            gates.inputs[id.0 as usize] = Some(inputs);
        }
        let own = all.iter().map(|&(id, op)| gates.luts_of(wiring, id, op)).sum::<u64>();
        gates.luts = own.saturating_sub(shared);
        gates
    }

    /// Look-up tables of a signal that are those of a gate.
    pub fn luts_of(&self, wiring: &Wiring, id: NodeId, op: Op) -> u64 {
        match &self.inputs[id.0 as usize] {
            Some(inputs) if !self.absorbed.contains(&id) => {
                let each = inputs.len().saturating_sub(1).div_ceil(INPUTS - 1).max(1) as u64;
                let luts = each * width(wiring, id, op);
                if is_row_of_square(wiring, op) { luts / 2 } else { luts }
            }
            _ => 0,
        }
    }

    /// The inputs of a gate, with those of the gates that become part of it.
    fn cover(&mut self, wiring: &Wiring, op: Op) -> BTreeSet<Input> {
        let operands: BTreeSet<NodeId> = variables(wiring, op).collect();
        let mut inputs: BTreeSet<Input> = operands.iter().copied().map(Input::Signal).collect();
        let mut by_size: Vec<(usize, NodeId)> = operands
            .into_iter()
            .filter(|&id| wiring.readers(id) == 1 && wiring.is_in_logic(id))
            .filter_map(|id| Some((self.inputs[id.0 as usize].as_ref()?.len(), id)))
            .collect();
        by_size.sort_unstable();
        for (_, id) in by_size {
            let own = self.inputs[id.0 as usize].clone().unwrap_or_default();
            self.merge(&mut inputs, id, own);
        }
        inputs
    }

    /// Adds those of a sum that becomes part of it, and gives the sum.
    fn add_sum(&mut self, wiring: &Wiring, inputs: &mut BTreeSet<Input>) -> Option<NodeId> {
        let signals = inputs.clone().into_iter().filter_map(|input| match input {
            Input::Signal(id) => Some(id),
            Input::Carry(_) => None,
        });
        let mut sums = signals.filter(|&id| {
            let is_sum = matches!(wiring.op(id), Op::Add(..) | Op::Sub(..));
            is_sum && wiring.is_in_logic(id) && wiring.readers(id) == 1
        });
        sums.find(|&sum| {
            let operands = variables(wiring, wiring.op(sum)).map(Input::Signal);
            let own = operands.chain([Input::Carry(sum)]).collect();
            self.merge(inputs, sum, own)
        })
    }

    /// Puts an input's own inputs in its place, if they are not too many.
    fn merge(&mut self, inputs: &mut BTreeSet<Input>, input: NodeId, own: BTreeSet<Input>) -> bool {
        let mut merged = inputs.clone();
        merged.remove(&Input::Signal(input));
        merged.extend(own);
        let fits = merged.len() <= INPUTS && !self.absorbed.contains(&input);
        if fits {
            *inputs = merged;
            self.absorbed.insert(input);
        }
        fits
    }
}

/// The signals that an operator reads, wires passed over.
fn variables(wiring: &Wiring, op: Op) -> impl Iterator<Item = NodeId> {
    let variables = op.operands().filter(|&id| wiring.constant(id).is_none());
    variables.map(|id| wiring.source(id))
}

/// Choices between a register's own value and a new one, where the register is cleared too: it has
/// pins for both.
fn held(wiring: &Wiring) -> HashSet<NodeId> {
    let cleared = wiring.operators().filter_map(|(id, op)| match op {
        Op::Select(_, zero, next) if wiring.registered(id) && wiring.constant(zero).is_some() => {
            Some((id, next))
        }
        _ => None,
    });
    let holds = |&(id, next): &(NodeId, NodeId)| matches!(wiring.op(next), Op::Select(_, _, own) if own == id);
    cleared.filter(holds).map(|(_, next)| next).collect()
}

/// Whether a choice is made by a register's own pins: its clock enable, or its set and reset, which
/// a single bit does not use.
fn is_control(wiring: &Wiring, id: NodeId, op: Op) -> bool {
    let Op::Select(_, a, b) = op else { return false };
    let resets = wiring.constant(a).is_some() && wiring.width(id) > 1;
    wiring.registered(id) && (b == id || resets)
}

/// Whether a choice is a value or 0 by a bit of that value: a row of a square, in which each product
/// of two bits is there twice.
fn is_row_of_square(wiring: &Wiring, op: Op) -> bool {
    let Op::Select(choice, a, b) = op else { return false };
    let of = wiring.bit_of(choice);
    wiring.constant(b) == Some(0) && of.is_some_and(|of| of == wiring.source(a))
}

/// Bits of a gate that are read and differ in more than constants.
fn width(wiring: &Wiring, id: NodeId, op: Op) -> u64 {
    let values = match op {
        Op::Select(_, a, b) => vec![a, b],
        _ => op.operands().collect(),
    };
    let variable = values.into_iter().filter(|&id| wiring.constant(id).is_none());
    let widest = variable.map(|id| wiring.width(id)).max().unwrap_or(1);
    widest.min(wiring.needed_bits(id))
}
