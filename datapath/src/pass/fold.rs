//! Leaves out operators whose result is known or is one of their operands.
//!
//! This is about raw values alone. A constant 0 may stand for a real value that the host rounded to
//! 0, and what adds or multiplies it is off by what that makes of it: [`Sig`](crate::builder::Sig) keeps the
//! operator's own error, whichever signal its values come from.
use crate::builder::{Facts, State};
use crate::design::{NodeId, Op, wrapped};
use crate::graph::Pace;

/// The signal that an operator's result is already, if it is one; what is saved is noted.
pub fn folded(state: &mut State, op: Op, facts: &Facts) -> Option<NodeId> {
    if let Some(value) = known_value(state, op, facts) {
        note(state, op, &format!("its result is always {value}"));
        return Some(state.constant(value, facts.fraction_bits));
    }
    if let Some((factor, bits)) = power_of_two_times(state, op) {
        note(state, op, &format!("it multiplies by 2^{bits}, which wires do"));
        return Some(state.emit(Op::ShiftLeft(factor, bits), Pace::Wire, facts.clone()));
    }
    let constant = |id| state.is_constant(id);
    let (same, why) = match op {
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
    // The operand's raw value is the result's only where both count in the same unit in the last
    // place.
    let fits = state.graph.value(same).fraction_bits == facts.fraction_bits;
    if !fits {
        return None;
    }
    note(state, op, why);
    Some(same)
}

/// Of a product with 2^k, k > 0: the other factor and k.
fn power_of_two_times(state: &State, op: Op) -> Option<(NodeId, u32)> {
    let Op::Mul(a, b) = op else { return None };
    let exponent = |id| {
        state
            .is_constant(id)
            .filter(|&value| value > 1 && value.count_ones() == 1)
            .map(i64::trailing_zeros)
    };
    exponent(b).map(|bits| (a, bits)).or_else(|| exponent(a).map(|bits| (b, bits)))
}

fn known_value(state: &State, op: Op, facts: &Facts) -> Option<i64> {
    let range = facts.range.narrow().ok()?;
    if let (Some(value), false) = (range.only(), op == Op::Input) {
        return Some(value);
    }
    let all_constant = op.operands().all(|o| state.is_constant(o).is_some());
    let value_of = |id: NodeId| state.is_constant(id).unwrap_or(0);
    // As in the hardware: the last bits that the result's width has room for.
    let value =
        || wrapped(op.evaluate(&state.graph.tables, value_of), range.width(), range.signed());
    (all_constant && op.operands().next().is_some()).then(value)
}

fn note(state: &mut State, op: Op, why: &str) {
    let width = |id: NodeId| state.graph.value(id).range.width();
    let what = match op {
        Op::Mul(a, b) => format!("multiplier {} x {} bits", width(a), width(b)),
        Op::Add(a, b) => format!("adder {} + {} bits", width(a), width(b)),
        Op::Sub(a, b) => format!("subtractor {} - {} bits", width(a), width(b)),
        Op::Select(_, a, b) => format!("multiplexer {} bits", width(a).max(width(b))),
        Op::LessThan(a, b) => format!("comparator {} bits", width(a).max(width(b))),
        // Wires cost nothing, so leaving one out saves nothing.
        _ => return,
    };
    state.leave_out(&what, why);
}
