//! Comparisons: a < b where a - b is negative. A difference has one carry chain, of which the sign
//! comes last; what synthesis makes of `<` has two, one behind the other.
use super::{Lowering, place};
use crate::design::{NodeId, Op, Range};
use crate::graph::Value;

impl Lowering<'_> {
    /// Whether the first value is less than the second.
    pub(super) fn comparison(&mut self, value: Value, [a, b]: [NodeId; 2]) -> NodeId {
        // The sign of one operand, or any bit of the other.
        let is_zero = |id| self.constant(id) == Some(0);
        let with_zero = is_zero(b) || is_zero(a) && self.range(b).low >= 0;
        if with_zero || self.range(a).width().max(self.range(b).width()) <= NARROW {
            return self.push(value);
        }
        let at = place(&value);
        // The sign has to be right for whatever bits stand there while no pixel does, so the
        // difference is as wide as the operands ask for, a bit more than they are.
        let [whole_a, whole_b] = [a, b].map(|id| self.whole(id));
        let Ok(range) = whole_a.minus(whole_b).narrow() else {
            return self.push(value);
        };
        let difference = self.new_sum(at, Op::Sub(a, b), range, "difference");
        let zero = self.integer(at, 0);
        self.push(Value { op: Op::LessThan(difference, zero), ..value })
    }
}

impl Lowering<'_> {
    /// Every value of as many bits as a value has; a constant alone.
    fn whole(&self, id: NodeId) -> Range {
        let range = self.range(id);
        range.only().map_or(Range::whole(range.width(), range.signed()), Range::single)
    }
}

/// Bits up to which a comparison is a few look-up tables.
const NARROW: u32 = 2;
