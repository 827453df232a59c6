//! Leaves out operators whose result is known or is one of their operands.
//!
//! The pass runs as operators are added, so that what is left out is noted in the unit it would have
//! been in. It is about raw values alone. A constant 0 may stand for a real value that the host
//! rounded to 0, and what adds or multiplies it is off by what that makes of it:
//! [`Sig`](crate::builder::Sig) keeps the operator's own error, whichever value stands for it.
use crate::design::{NodeId, Op, Range, wrapped};
use crate::graph::Graph;

/// What takes an operator's place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Folded {
    /// The same raw value at every clock.
    Constant(i64),
    /// A value times 2^k, which wires do.
    ShiftLeft(NodeId, u32),
    /// A value that is there already.
    Same(NodeId),
}

/// Hardware that is saved, and why nothing is lost.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saved {
    /// The hardware.
    pub what: String,
    /// Why nothing is lost.
    pub why: String,
}

/// What takes the place of an operator whose result has this range and so many fraction bits, and
/// what that saves; none where the operator is needed.
pub fn folded(
    graph: &Graph,
    op: Op,
    range: Option<Range>,
    fraction_bits: u32,
) -> Option<(Folded, Option<Saved>)> {
    if let Some(value) = known_value(graph, op, range?) {
        return Some((
            Folded::Constant(value),
            saved(graph, op, &format!("its result is always {value}")),
        ));
    }
    if let Some((factor, bits)) = power_of_two_times(graph, op) {
        let why = format!("it multiplies by 2^{bits}, which wires do");
        return Some((Folded::ShiftLeft(factor, bits), saved(graph, op, &why)));
    }
    let (same, why) = same_as_operand(graph, op)?;
    // The operand's raw value is the result's only where both count in the same unit in the last
    // place.
    let fits = graph.value(same).fraction_bits == fraction_bits;
    fits.then(|| (Folded::Same(same), saved(graph, op, why)))
}

/// The operand that an operator's result is, and why.
fn same_as_operand(graph: &Graph, op: Op) -> Option<(NodeId, &'static str)> {
    let constant = |id| graph.value(id).op.constant();
    let same = match op {
        Op::Add(a, b) if constant(b) == Some(0) => (a, "it adds 0"),
        Op::Add(a, b) if constant(a) == Some(0) => (b, "it adds 0"),
        Op::Or(a, b) if constant(a) == Some(0) => (b, "it adds no bit"),
        Op::Sub(a, b) if constant(b) == Some(0) => (a, "it subtracts 0"),
        Op::Mul(a, b) if constant(b) == Some(1) => (a, "it multiplies by 1"),
        Op::Mul(a, b) if constant(a) == Some(1) => (b, "it multiplies by 1"),
        Op::Select(c, a, b) => match constant(c)? {
            0 => (b, "its condition is always 0"),
            _ => (a, "its condition is always 1"),
        },
        _ => return None,
    };
    Some(same)
}

/// Of a product with 2^k, k > 0: the other factor and k.
fn power_of_two_times(graph: &Graph, op: Op) -> Option<(NodeId, u32)> {
    let Op::Mul(a, b) = op else { return None };
    let exponent = |id| {
        let constant = graph.value(id).op.constant();
        constant.filter(|&value| value > 1 && value.count_ones() == 1).map(i64::trailing_zeros)
    };
    exponent(b).map(|bits| (a, bits)).or_else(|| exponent(a).map(|bits| (b, bits)))
}

fn known_value(graph: &Graph, op: Op, range: Range) -> Option<i64> {
    if let (Some(value), false) = (range.only(), op == Op::Input) {
        return Some(value);
    }
    let all_constant = op.operands().all(|o| graph.is_constant(o));
    let value_of = |id: NodeId| graph.value(id).op.constant().unwrap_or(0);
    // As in the hardware: the last bits that the result's width has room for.
    let value = || wrapped(op.evaluate(&graph.tables, value_of), range.width(), range.signed());
    (all_constant && op.operands().next().is_some()).then(value)
}

/// The hardware of an operator; none of what is wires.
fn saved(graph: &Graph, op: Op, why: &str) -> Option<Saved> {
    let width = |id: NodeId| graph.value(id).range.width();
    let what = match op {
        Op::Mul(a, b) => format!("multiplier {} x {} bits", width(a), width(b)),
        Op::Add(a, b) => format!("adder {} + {} bits", width(a), width(b)),
        Op::Sub(a, b) => format!("subtractor {} - {} bits", width(a), width(b)),
        Op::Select(_, a, b) => format!("multiplexer {} bits", width(a).max(width(b))),
        Op::LessThan(a, b) => format!("comparator {} bits", width(a).max(width(b))),
        _ => return None,
    };
    Some(Saved { what, why: why.to_owned() })
}
