//! Which values do not depend on what registers held before reset.
//!
//! Icarus begins with X there, and a netlist's registers of data have no reset. Where a value might
//! be X it is not compared.
use specula_datapath::Design;
use specula_datapath::design::{Node, Op, Register};

/// For every signal at every clock, whether it is known; `values` are those of a run from clock 0
/// on.
pub fn known(design: &Design, values: &[Vec<i64>]) -> Vec<Vec<bool>> {
    let mut registers = vec![false; design.nodes.len()];
    // In the clock of reset no value is known but the inputs and what holds validity.
    let reset = settled(design, &registers, &|_| None);
    registers = after_edge(design, &reset, &|_| None);
    let mut columns = vec![vec![]; design.nodes.len()];
    for clock in 0..values.first().map_or(0, Vec::len) {
        let value = |node: usize| values[node].get(clock).copied();
        let now = settled(design, &registers, &value);
        columns.iter_mut().zip(&now).for_each(|(column, &known)| column.push(known));
        registers = after_edge(design, &now, &value);
    }
    columns
}

type Values<'a> = &'a dyn Fn(usize) -> Option<i64>;

fn settled(design: &Design, registers: &[bool], value: Values) -> Vec<bool> {
    let mut now = registers.to_vec();
    for (id, node) in design.iter().filter(|(_, node)| node.register == Register::None) {
        now[id.0 as usize] = follows(node, &now, value);
    }
    now
}

fn after_edge(design: &Design, now: &[bool], value: Values) -> Vec<bool> {
    design
        .nodes
        .iter()
        .map(|node| node.register == Register::Validity || follows(node, now, value))
        .collect()
}

/// Whether all is known that the result depends on.
fn follows(node: &Node, now: &[bool], value: Values) -> bool {
    let known = |id: specula_datapath::design::NodeId| now[id.0 as usize];
    match node.op {
        Op::Select(c, a, b) => match value(c.0 as usize).filter(|_| known(c)) {
            Some(1) => known(a),
            Some(_) => known(b),
            None => false,
        },
        op => op.operands().all(known),
    }
}
