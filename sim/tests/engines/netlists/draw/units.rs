//! Units: signals cross their borders by copies, as the builder makes them.
use specula_datapath::design::{NodeId, Op, Register, ScopeId};

use super::Net;
use super::net::scope;

/// Goes on in a neighbouring unit, an old one or a new one, and takes some signals there.
pub fn go_elsewhere(net: &mut Net) {
    let from = net.scope;
    let mut neighbours = children(net, from);
    neighbours.extend(net.design.scope(from).parent);
    let new = net.design.scopes.len();
    if new <= net.profile.units && (neighbours.is_empty() || net.draw.below(2) == 0) {
        net.design.scopes.push(scope(new, from));
        neighbours = vec![ScopeId(new as u32)];
    }
    if neighbours.is_empty() {
        return;
    }
    let to = neighbours[net.draw.below(neighbours.len())];
    for _ in 0..1 + net.draw.below(3) {
        take(net, from, to);
    }
    net.scope = to;
}

fn children(net: &Net, of: ScopeId) -> Vec<ScopeId> {
    let all = (0..net.design.scopes.len() as u32).map(ScopeId);
    all.filter(|&s| net.design.scope(s).parent == Some(of)).collect()
}

/// Makes a signal of `from` readable in `to`.
fn take(net: &mut Net, from: ScopeId, to: ScopeId) {
    net.scope = from;
    let readable = net.readable();
    if readable.is_empty() {
        return;
    }
    let mut id = readable[net.draw.below(readable.len())];
    let range = net.range(id);
    // A port of the input side is no output as well.
    if net.design.scope(from).parent == Some(to) && is_port(net, id) {
        id = net.place(Op::Copy(id), Register::None, range);
    }
    net.scope = to;
    // An instance's pin is connected once.
    let there = net.design.nodes.iter().any(|node| node.scope == to && node.op == Op::Copy(id));
    if net.profile.verilog && there {
        return;
    }
    net.place(Op::Copy(id), Register::None, range);
}

fn is_port(net: &Net, id: NodeId) -> bool {
    let node = net.design.node(id);
    let outside = net.design.scope(node.scope).parent;
    matches!(node.op, Op::Copy(from) if !node.registered() && outside == Some(net.design.node(from).scope))
}
