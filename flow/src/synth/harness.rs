//! A core between two shift registers, so that it needs three pins.
use std::fmt::Write;

use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, ScopeId};

/// Name of the harness's module.
pub const MODULE: &str = "specula_harness";
/// Name of the core's instance in it.
pub const INSTANCE: &str = "core";

/// A port of the core with its width in bits.
struct Port {
    name: String,
    width: u32,
}

/// The harness of a design as Verilog.
///
/// Inputs come bit by bit from one shift register. Outputs go into another, which takes them over
/// or shifts them out as the last bit of the first says. So every path into and out of the core
/// begins and ends in a flip-flop, as it would between other parts of a design, and no bit is
/// known beforehand.
pub fn text(design: &Design) -> String {
    let inputs = inputs(design);
    let outputs: Vec<Port> =
        [design.valid_out].iter().chain(&design.outputs).map(|&id| port(design, id)).collect();
    let bits = |ports: &[Port]| ports.iter().map(|port| port.width).sum::<u32>();
    let (bits_in, bits_out) = (bits(&inputs), bits(&outputs));
    let mut text = format!(
        "module {MODULE} (input wire clk, input wire serial_in, output wire serial_out);\n\
        \x20 reg [{bits_in}:0] bits_in;\n\
        \x20 wire [{last}:0] bits_out;\n\
        \x20 reg [{last}:0] taken;\n\
        \x20 always @(posedge clk) bits_in <= {{bits_in[{before}:0], serial_in}};\n\
        \x20 always @(posedge clk) taken <= bits_in[{bits_in}] ? bits_out : taken << 1;\n\
        \x20 assign serial_out = taken[{last}];\n",
        last = bits_out.saturating_sub(1),
        before = bits_in.saturating_sub(1),
    );
    let is_clocked = design.nodes.iter().any(Node::registered);
    let clock = is_clocked.then(|| ".clock(clk)".to_owned());
    let connections: Vec<String> = clock
        .into_iter()
        .chain(connections(&inputs, "bits_in"))
        .chain(connections(&outputs, "bits_out"))
        .collect();
    let module = &design.scope(ScopeId::TOP).instance;
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "  {module} {INSTANCE} (\n    {}\n  );\nendmodule",
        connections.join(",\n    ")
    );
    text
}

/// Everything that the core takes besides its clock.
fn inputs(design: &Design) -> Vec<Port> {
    let reset = design.to_block().has_reset().then(|| Port { name: "reset".to_owned(), width: 1 });
    let ids =
        [design.valid, design.start].into_iter().chain(design.inputs.iter().flatten().copied());
    let is_port = |id: &NodeId| design.node(*id).op == Op::Input;
    reset.into_iter().chain(ids.filter(is_port).map(|id| port(design, id))).collect()
}

fn port(design: &Design, id: NodeId) -> Port {
    let node = design.node(id);
    Port { name: node.name.clone(), width: node.width() }
}

/// Each port with its bits of `vector`, the first ones on the right.
fn connections(ports: &[Port], vector: &str) -> Vec<String> {
    let connection = |first: &mut u32, port: &Port| {
        let right = *first;
        *first += port.width;
        Some(format!(".{}({vector}[{}:{right}])", port.name, *first - 1))
    };
    ports.iter().scan(0, connection).collect()
}
