//! Registers that read what comes later.
use specula_datapath::design::{NodeId, Op, Range, Register, ScopeId};

use super::{Net, ranges};

/// A register that holds whatever its width allows; what it reads is decided when all else is
/// there.
pub fn open_register(net: &mut Net) {
    let range = ranges::whole(net.draw);
    let own = NodeId(net.design.nodes.len() as u32);
    net.place(Op::Copy(own), Register::Data, range);
    net.open.push(own);
}

/// Gives every open register its operator: one whose result its range holds, or the low bits of
/// something.
pub fn close(net: &mut Net) {
    for own in std::mem::take(&mut net.open) {
        net.scope = net.design.node(own).scope;
        let readable = net.readable();
        let mut op = Op::Wrap(one_of(net, &readable));
        for _ in 0..net.draw.below(3) {
            let candidate = closing(net, own, &readable);
            let held = net.range(own);
            let fits = |r: Range| held.low <= r.low && r.high <= held.high;
            // The Verilog of a comparison is one bit wide, and a linter asks why its register has
            // more.
            let odd = net.profile.verilog
                && matches!(candidate, Op::LessThan(..))
                && held != ranges::bit();
            if ranges::of(&net.design, candidate).is_some_and(fits) && !odd {
                op = candidate;
            }
        }
        net.design.nodes[own.0 as usize].op = op;
    }
    net.scope = ScopeId::TOP;
}

fn one_of(net: &mut Net, among: &[NodeId]) -> NodeId {
    among[net.draw.below(among.len())]
}

fn closing(net: &mut Net, own: NodeId, readable: &[NodeId]) -> Op {
    let (a, b) = (one_of(net, readable), one_of(net, readable));
    let bits: Vec<NodeId> =
        readable.iter().copied().filter(|&id| ranges::is_bit(net.range(id))).collect();
    match (net.draw.below(7), bits.is_empty()) {
        (0, false) => Op::Select(one_of(net, &bits), a, own),
        (1, false) => Op::Select(one_of(net, &bits), own, b),
        (2, _) => Op::ShiftRight(a, 1 + (net.draw.below(9) as u32).saturating_sub(4)),
        (3, _) => Op::LessThan(a, b),
        (4, _) => Op::Sub(a, b),
        (5, _) => Op::Add(a, b),
        _ => Op::Copy(a),
    }
}

/// A register with an enable.
pub fn held(net: &mut Net) {
    let enable = if net.draw.below(2) == 0 { enabling(net) } else { validity(net) };
    let value = net.pick();
    let own = NodeId(net.design.nodes.len() as u32);
    let range = net.range(value).hull(Range::single(0));
    net.place(Op::Select(enable, value, own), Register::Data, range);
}

/// A bit. That spans load is what accumulators are for; and in Verilog little shall depend on what
/// was there before.
fn enabling(net: &mut Net) -> NodeId {
    let by_spans = net.profile.verilog || net.draw.below(2) == 0;
    if by_spans && net.scope == ScopeId::TOP { net.design.start } else { net.pick_bit() }
}

/// A bit that is 1 where a pixel is, now and then some clocks ago, or any bit.
fn validity(net: &mut Net) -> NodeId {
    if net.scope != ScopeId::TOP || net.draw.below(4) == 0 {
        return net.pick_bit();
    }
    let clocks = net.draw.below(3);
    (0..clocks)
        .fold(net.design.valid, |at, _| net.place(Op::Copy(at), Register::Data, ranges::bit()))
}

/// A register with an enable and a load.
pub fn held_or_loaded(net: &mut Net) {
    let [enable, load] = [enabling(net), enabling(net)];
    let [value, loaded] = [net.pick(), net.pick()];
    let own = NodeId(net.design.nodes.len() as u32);
    let Some(range) = ranges::hull(net.range(value), net.range(loaded)) else { return };
    let range = range.hull(Range::single(0));
    net.place(Op::Copy(own), Register::Data, range);
    let kept = net.place(Op::Select(enable, value, own), Register::None, range);
    net.design.nodes[own.0 as usize].op = Op::Select(load, loaded, kept);
}

/// value = first ? start : state; state ← valid ? value + step : state, as the builder makes it, or
/// nearly so.
pub fn accumulator(net: &mut Net) {
    let (first, start) = (enabling(net), net.pick());
    let valid = validity(net);
    let room = net.draw.below(4) as u32;
    let signed = net.range(start).signed() || net.draw.below(2) == 0;
    let Some(both) = ranges::hull(
        Range::whole((net.range(start).width() + room).min(63), signed),
        net.range(start),
    ) else {
        return;
    };
    let whole = Range::whole(both.width(), both.signed());
    let own = NodeId(net.design.nodes.len() as u32);
    net.place(Op::Copy(own), Register::Data, whole);
    let value = net.place(Op::Select(first, start, own), Register::None, whole);
    // Now and then a step that depends on the value.
    let step = if net.draw.below(4) == 0 {
        net.add(Op::ShiftRight(value, 2), Register::None)
    } else {
        None
    };
    let step = step.unwrap_or_else(|| net.pick());
    let op = if net.draw.below(5) == 0 { Op::Sub(value, step) } else { Op::Add(value, step) };
    let next = net.add(op, Register::None).unwrap_or(value);
    let steps_always = net.draw.below(4) == 0;
    net.design.nodes[own.0 as usize].op =
        if steps_always { Op::Wrap(next) } else { Op::Select(valid, next, own) };
    if net.draw.below(2) == 0 {
        net.add(Op::Copy(value), Register::Data);
    }
}
