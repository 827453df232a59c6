//! What a netlist means, from the meaning of each operator, clock by clock and as plainly as can
//! be.
use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op, Range, Register};

/// What goes in at a clock.
#[derive(Clone, Debug)]
pub struct Row {
    pub valid: bool,
    pub start: bool,
    pub inputs: Vec<i64>,
}

/// A signal that left its stated range, which makes the netlist no fair test.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Untrue(String);

impl std::fmt::Display for Untrue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// The value of every signal at every clock, after one clock of reset with all registers and
/// inputs 0.
pub fn interpret(design: &Design, rows: &[Row]) -> Result<Vec<Vec<i64>>, Untrue> {
    let mut registers = vec![0; design.nodes.len()];
    let idle = Row { valid: false, start: false, inputs: vec![0; design.inputs.len()] };
    let now = settled(design, &registers, &idle)?;
    registers = after_edge(design, &now, true)?;
    let mut columns = vec![vec![]; design.nodes.len()];
    for row in rows {
        let now = settled(design, &registers, row)?;
        columns.iter_mut().zip(&now).for_each(|(column, &value)| column.push(value));
        registers = after_edge(design, &now, false)?;
    }
    Ok(columns)
}

/// The values of all signals in a clock. Signals without register read earlier ones or registers
/// only.
fn settled(design: &Design, registers: &[i64], row: &Row) -> Result<Vec<i64>, Untrue> {
    let mut now = registers.to_vec();
    now[design.valid.0 as usize] = row.valid.into();
    now[design.start.0 as usize] = row.start.into();
    for (input, &value) in design.inputs.iter().zip(&row.inputs) {
        if let Some(input) = input {
            now[input.0 as usize] = value;
        }
    }
    for (id, node) in design.iter() {
        if node.register == Register::None && node.op != Op::Input {
            now[id.0 as usize] = result(design, (id, node), &now)?;
        }
    }
    Ok(now)
}

fn after_edge(design: &Design, now: &[i64], reset: bool) -> Result<Vec<i64>, Untrue> {
    let next = |(id, node): (NodeId, &Node)| match node.register {
        Register::None => Ok(0),
        Register::Validity if reset => Ok(0),
        _ => result(design, (id, node), now),
    };
    design.iter().map(next).collect()
}

/// What a signal's operator gives.
fn result(design: &Design, (id, node): (NodeId, &Node), now: &[i64]) -> Result<i64, Untrue> {
    let value = |id: NodeId| i128::from(now[id.0 as usize]);
    let exact = match node.clock_enable(id) {
        // A register of a loop has the low bits of what it takes over.
        Some((enable, next)) if value(enable) == 1 => {
            low_bits(value(next), node.width(), node.range.signed())
        }
        _ => meaning(design, node, value),
    };
    let Range { low, high } = node.range;
    if (i128::from(low)..=i128::from(high)).contains(&exact) {
        return Ok(exact as i64);
    }
    Err(Untrue(format!("{} = {:?} gives {exact}, not {low}..{high}", node.name, node.op)))
}

fn meaning(design: &Design, node: &Node, value: impl Fn(NodeId) -> i128) -> i128 {
    match node.op {
        Op::Input => 0,
        Op::Constant(constant) => constant.into(),
        Op::Copy(a) => value(a),
        Op::Add(a, b) => value(a) + value(b),
        Op::Sub(a, b) => value(a) - value(b),
        Op::Mul(a, b) => value(a) * value(b),
        Op::ShiftLeft(a, bits) => value(a) * (1 << bits),
        Op::ShiftRight(a, bits) => value(a).div_euclid(1 << bits),
        Op::Wrap(a) => low_bits(value(a), node.width(), node.range.signed()),
        Op::LessThan(a, b) => (value(a) < value(b)).into(),
        Op::And(a, b) => value(a) & value(b),
        Op::Or(a, b) => value(a) | value(b),
        Op::Not(a) => 1 - value(a),
        Op::Select(c, a, _) if value(c) == 1 => value(a),
        Op::Select(_, _, b) => value(b),
        Op::LookUp(at, table) => {
            design.tables[table.0 as usize].entries.get(value(at) as usize).map_or(0, |&e| e.into())
        }
    }
}

/// `value` modulo 2^`width`, the upper half of the values counted as negative if `signed`.
fn low_bits(value: i128, width: u32, signed: bool) -> i128 {
    let modulus = 1i128 << width;
    let low = value.rem_euclid(modulus);
    if signed && low >= modulus / 2 { low - modulus } else { low }
}
