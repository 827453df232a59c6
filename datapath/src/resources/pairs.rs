//! Cells of a look-up table and a flip-flop, where each look-up table has a flip-flop beside it: those
//! that have a flip-flop alone, or a carry alone.
use super::{Gates, Wiring, carry};
use crate::design::{NodeId, Op};

/// Cells without a look-up table: of flip-flops that no look-up table stands before, or only one that
/// others read too, and of carries whose sum nobody reads.
pub fn alone(wiring: &Wiring, gates: &Gates) -> u64 {
    let registers = wiring.operators().filter(|&(id, _)| wiring.registered(id));
    let flip_flops: u64 = registers.map(|(id, op)| of_register(wiring, gates, id, op)).sum();
    let sums = wiring.operators().filter(|(_, op)| matches!(op, Op::Add(..) | Op::Sub(..)));
    let carries = sums.map(|(id, _)| carry::length(wiring, id) - wiring.needed_bits(id));
    flip_flops + carries.sum::<u64>()
}

/// Flip-flops of a register that are alone.
fn of_register(wiring: &Wiring, gates: &Gates, id: NodeId, op: Op) -> u64 {
    let bits = wiring.needed_bits(id);
    match op {
        Op::Copy(from) | Op::Wrap(from) | Op::ShiftLeft(from, _) | Op::ShiftRight(from, _) => {
            behind(wiring, from, bits)
        }
        Op::Or(high, low) if wiring.is_join(op) => behind_parts(wiring, [high, low], bits),
        Op::Select(_, next, own) if own == id => behind(wiring, next, bits),
        Op::Select(_, a, b) if gates.luts_of(wiring, id, op) == 0 => {
            let next = if wiring.constant(a).is_some() { b } else { a };
            match wiring.op(next) {
                // The register's own enable.
                Op::Select(_, next, own) if own == id => behind(wiring, next, bits),
                _ => behind(wiring, next, bits),
            }
        }
        _ => 0,
    }
}

/// Flip-flops that are alone, of those that take so many bits of a signal.
fn behind(wiring: &Wiring, taken: NodeId, bits: u64) -> u64 {
    let source = wiring.source(taken);
    let is_only = wiring.is_in_logic(source) && wiring.readers(source) == 1;
    match wiring.op(source) {
        Op::Constant(_) => 0,
        Op::Or(high, low) if is_only && wiring.is_join(wiring.op(source)) => {
            behind_parts(wiring, [high, low], bits)
        }
        Op::Input => bits,
        _ if is_only => 0,
        _ => bits,
    }
}

/// The same for two values side by side.
fn behind_parts(wiring: &Wiring, [high, low]: [NodeId; 2], bits: u64) -> u64 {
    let Op::ShiftLeft(high, place) = wiring.op(high) else { return bits };
    let above = behind(wiring, high, bits.saturating_sub(place.into()));
    above + behind(wiring, low, bits.min(wiring.width(low)))
}
