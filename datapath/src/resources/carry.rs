//! Sums, differences and comparisons in carry chains.
use std::collections::BTreeMap;

use super::Wiring;
use crate::design::{NodeId, Op};
use crate::target::{Carry, Logic};

/// Look-up tables of all carry chains.
pub fn luts(wiring: &Wiring, logic: &Logic) -> u64 {
    let chains = wiring.operators().map(|(id, op)| chain(wiring, id, op, logic)).sum::<u64>();
    match logic.carry {
        Carry::Beside => chains + inverted(wiring),
        Carry::Behind | Carry::Pair => chains,
    }
}

/// Look-up tables of an operator's own chain.
fn chain(wiring: &Wiring, id: NodeId, op: Op, logic: &Logic) -> u64 {
    let width = |id| wiring.width(id);
    match op {
        Op::Add(a, b) => sum(wiring, id, wiring.zeros(a).max(wiring.zeros(b)), logic),
        Op::Sub(_, b) => sum(wiring, id, wiring.zeros(b), logic),
        // Whether any bit is 1.
        Op::LessThan(a, b) if wiring.constant(a) == Some(0) => (width(b) / 3).max(1),
        Op::LessThan(a, b) => match width(a).max(width(b)) {
            0..=2 => 1,
            bits => bits + 1,
        },
        _ => 0,
    }
}

/// Look-up tables of a sum whose lowest bits, so many, are those of an operand: what is added to them,
/// or subtracted, is 0.
fn sum(wiring: &Wiring, id: NodeId, passed: u32, logic: &Logic) -> u64 {
    let read = wiring.needed(id).checked_shr(passed).unwrap_or(0);
    logic.carry.luts(length(wiring, id).saturating_sub(passed.into()), read.count_ones().into())
}

/// Bits of a sum up to the highest that is read.
pub fn length(wiring: &Wiring, id: NodeId) -> u64 {
    u64::from(u64::BITS - wiring.needed(id).leading_zeros())
}

/// Look-up tables that invert what is subtracted: one for each bit but the
/// highest of what comes from a register or has other readers, whoever subtracts it. Others are made
/// inverted in the first place.
fn inverted(wiring: &Wiring) -> u64 {
    let mut widths: BTreeMap<NodeId, u64> = BTreeMap::new();
    for (id, op) in wiring.operators() {
        let Op::Sub(_, b) = op else { continue };
        let source = wiring.source(b);
        let stays = !wiring.is_in_logic(source)
            || wiring.op(source) == Op::Input
            || wiring.readers(source) > 1;
        if wiring.constant(b).is_none() && stays {
            let widest = widths.entry(source).or_default();
            *widest = (*widest).max((length(wiring, id) - 1).min(wiring.width(b)));
        }
    }
    widths.values().sum()
}
