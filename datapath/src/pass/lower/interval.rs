//! Ranges of operators' results, from those of their operands alone: an engine may rely on them
//! whatever enters, so what is known beyond them stands behind an operator that drops bits.
use super::Lowering;
use crate::design::{NodeId, Op, Range, WideRange};
use crate::graph::Value;

impl Lowering<'_> {
    /// Adds a value whose operands say no more than `value.range` of it; where they do not say as
    /// much, the operator stands for itself, and the value is its low bits.
    pub(super) fn finished(&mut self, value: Value) -> NodeId {
        let whole = self.interval(value.op).and_then(|whole| whole.narrow().ok());
        let Some(whole) = whole.filter(|whole| !contains(value.range, *whole)) else {
            return self.push(value);
        };
        let at = super::place(&value);
        let whole = self.emit_whole(at, value.op, whole);
        self.push(Value { op: Op::Wrap(whole), ..value })
    }

    /// Every value of an operator's result; none of those that have no more than their range.
    pub(super) fn interval(&self, op: Op) -> Option<WideRange> {
        let range = |id: NodeId| self.range(id);
        Some(match op {
            Op::Add(a, b) => range(a).plus(range(b)),
            Op::Sub(a, b) => range(a).minus(range(b)),
            Op::Mul(a, b) if a == b => range(a).squared(),
            Op::Mul(a, b) => range(a).times(range(b)),
            Op::Copy(a) => range(a).into(),
            Op::ShiftLeft(a, bits) => range(a).shifted_left(bits),
            Op::ShiftRight(a, bits) => range(a).shifted_right(bits).into(),
            Op::Select(_, a, b) => range(a).hull(range(b)).into(),
            Op::Or(high, low) if self.is_join(op) => range(high).plus(range(low)),
            _ => return None,
        })
    }
}

/// Whether one range has all that another has.
pub(super) fn contains(range: Range, other: Range) -> bool {
    range.low <= other.low && other.high <= range.high
}
