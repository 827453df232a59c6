//! Operators on what is there.
use specula_datapath::design::{NodeId, Op, Range, Register, Table, TableId};

use super::{Net, ranges};

/// Some operator on some signals, if it fits 63 bits.
pub fn any(net: &mut Net) {
    let (a, b) = (net.pick(), net.pick());
    let register = net.any_register();
    let op = match net.draw.below(20) {
        0..=2 => Op::Add(a, b),
        3..=5 => Op::Sub(a, b),
        6..=7 => Op::Mul(a, b),
        8 => Op::Mul(a, other_name(net, a)),
        9 => Op::ShiftLeft(a, net.draw.below(40) as u32),
        10 => shift_right(net, a),
        11 | 12 => return wrap(net, a, register),
        13 => Op::LessThan(a, b),
        14 => bitwise(net, a, b),
        15 => Op::Not(net.pick_bit()),
        16 | 17 => Op::Select(net.pick_bit(), a, b),
        18 => match look_up(net) {
            Some(op) => op,
            None => return,
        },
        _ => Op::Copy(a),
    };
    if net.add(op, register).is_none() && !net.profile.verilog {
        // Too wide: what the next operators read gets narrower.
        wrap(net, a, register);
    }
}

/// The signal, or a copy of it: its square has a range that the ranges of the operands alone do not
/// show.
fn other_name(net: &mut Net, a: NodeId) -> NodeId {
    if net.draw.below(2) == 0 { a } else { net.add(Op::Copy(a), Register::None).unwrap_or(a) }
}

/// The low bits, fewer or more than the operand has.
fn wrap(net: &mut Net, a: NodeId, register: Register) {
    let range = match net.draw.below(4) {
        // The operand's own range: nothing is lost.
        0 if register == Register::None => net.range(a),
        _ => ranges::whole(net.draw),
    };
    net.place(Op::Wrap(a), register, range);
}

/// By less than the width or by more.
fn shift_right(net: &mut Net, a: NodeId) -> Op {
    let width = net.range(a).width() as usize;
    let beyond = if net.profile.verilog { 0 } else { 4 };
    let bits = if net.draw.below(8) == 0 && beyond > 0 {
        net.draw.below(63)
    } else {
        net.draw.below(width + beyond)
    };
    Op::ShiftRight(a, bits as u32)
}

fn bitwise(net: &mut Net, a: NodeId, b: NodeId) -> Op {
    let (a, b) = if net.draw.below(2) == 0 { (net.pick_bit(), net.pick_bit()) } else { (a, b) };
    if net.draw.below(2) == 0 { Op::And(a, b) } else { Op::Or(a, b) }
}

/// A table behind an unsigned signal that is not too wide, if there is one.
fn look_up(net: &mut Net) -> Option<Op> {
    let addresses: Vec<NodeId> =
        net.readable().into_iter().filter(|&id| net.range(id).low >= 0).collect();
    let short: Vec<NodeId> =
        addresses.iter().copied().filter(|&id| net.range(id).high < 64).collect();
    let among = if net.draw.below(5) == 0 || short.is_empty() { addresses } else { short };
    let at = *among.get(net.draw.below(among.len().max(1)))?;
    let range = ranges::whole(net.draw);
    let entries =
        (0..1 + net.draw.below(9)).map(|_| net.draw.between(range.low, range.high)).collect();
    net.design.tables.push(Table { entries });
    Some(Op::LookUp(at, TableId(net.design.tables.len() as u32 - 1)))
}

/// Shift, 1 added, shift by 1, wrap: the chain that engines put into one kernel; with registers or
/// without.
pub fn rounding(net: &mut Net) {
    let a = net.pick();
    let mut at = a;
    if net.draw.below(3) > 0 {
        let op = shift_right(net, at);
        let register = net.any_register();
        at = net.add(op, register).unwrap_or(at);
    }
    if net.draw.below(4) > 0 {
        let one = net.constant(1);
        let register = net.any_register();
        at = net.add(Op::Add(at, one), register).unwrap_or(at);
        let bits = if net.draw.below(5) == 0 { 2 } else { 1 };
        let register = net.any_register();
        at = net.add(Op::ShiftRight(at, bits), register).unwrap_or(at);
    }
    if net.draw.below(2) == 0 {
        let register = net.any_register();
        wrap(net, at, register);
    }
}

/// The value, or a limit where it is smaller; the range shows it.
pub fn clamp(net: &mut Net) {
    let a = net.pick();
    let range = net.range(a);
    if range.low == range.high {
        return;
    }
    let limit = net.draw.between(range.low + 1, range.high);
    let low = net.constant(limit);
    let less = net.place(Op::LessThan(a, low), Register::None, ranges::bit());
    let clamped = Range::new(limit, range.high);
    if net.draw.below(2) == 0 && !net.profile.verilog {
        net.place(Op::Select(less, low, a), Register::None, clamped);
        return;
    }
    let chosen = net.place(Op::Select(less, low, a), Register::None, range);
    net.place(Op::Wrap(chosen), Register::None, clamped);
}

/// A few delays in a row, or other names.
pub fn delays(net: &mut Net) {
    let mut at = net.pick();
    for _ in 0..1 + net.draw.below(6) {
        let register = if net.draw.below(4) == 0 { Register::None } else { Register::Data };
        at = net.add(Op::Copy(at), register).unwrap_or(at);
    }
}
