//! Draws netlists.
//!
//! Every stated range is true: it follows from the operands' ranges, or holds more than that.
//! Registers and inputs can be 0, since they are in reset.
mod feedback;
mod net;
mod operators;
mod ranges;
mod stimulus;
mod units;

use specula_datapath::design::{NodeId, Op, Register};

use crate::netlists::case::{Case, Subject};
use crate::netlists::profile::Profile;
pub use net::{Net, empty, node, scope};
use specula_fixtures::Draw;

/// A netlist with its stimulus.
pub fn case(draw: &mut Draw, profile: Profile) -> Case {
    let mut net = Net::new(draw, profile);
    add_inputs(&mut net);
    while net.design.nodes.len() < profile.signals {
        grow(&mut net);
    }
    feedback::close(&mut net);
    add_outputs(&mut net);
    let design = net.design;
    let packets = stimulus::packets(draw, &design, profile);
    let bubbles = (draw.below(2) == 0).then(|| draw.below(1000) as u64);
    Case { design, packets, bubbles, window: None, watched: vec![], subject: Subject::RustHdl }
}

fn add_inputs(net: &mut Net) {
    let count = 1 + net.draw.below(5);
    for _ in 0..count {
        let range =
            if net.draw.below(4) == 0 { ranges::bit() } else { ranges::around_zero(net.draw) };
        let id = net.input(range);
        net.design.inputs.push(Some(id));
    }
    // A port that is constant has no signal.
    if net.draw.below(4) == 0 {
        let at = net.draw.below(net.design.inputs.len() + 1);
        net.design.inputs.insert(at, None);
    }
}

fn grow(net: &mut Net) {
    match net.draw.below(100) {
        0..=9 if net.profile.units > 0 => units::go_elsewhere(net),
        10..=14 if net.profile.feedback => feedback::open_register(net),
        15..=17 => feedback::held(net),
        18..=20 => feedback::held_or_loaded(net),
        21..=25 => feedback::accumulator(net),
        26..=33 => operators::rounding(net),
        34..=36 => operators::clamp(net),
        37..=39 => operators::delays(net),
        _ => operators::any(net),
    }
}

/// Copies in the core leave it; validity comes out after some clocks.
fn add_outputs(net: &mut Net) {
    net.scope = specula_datapath::design::ScopeId::TOP;
    let mut valid = net.design.valid;
    let clocks = net.draw.below(9);
    for _ in 0..clocks {
        valid = net.place(Op::Copy(valid), Register::Validity, ranges::bit());
    }
    net.design.nodes[valid.0 as usize].stage = net.draw.between(1, 12) as u32;
    net.design.valid_out = valid;
    let ordinary = |id: &NodeId| {
        let node = net.design.node(*id);
        node.scope == net.scope && !matches!(node.op, Op::Input | Op::Constant(_))
    };
    let readable: Vec<NodeId> =
        (0..net.design.nodes.len() as u32).map(NodeId).filter(ordinary).collect();
    for id in readable {
        if net.profile.verilog || net.draw.below(4) == 0 {
            let range = net.design.node(id).range;
            let out = net.place(Op::Copy(id), Register::None, range);
            net.design.outputs.push(out);
        }
    }
}
