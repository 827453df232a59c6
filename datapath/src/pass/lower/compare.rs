//! Comparisons: a < b where a - b is negative. A difference has one carry chain, of which the sign
//! comes last; what synthesis makes of `<` has two, one behind the other.
use super::{Lowering, Place, place};
use crate::design::{NodeId, Op, Range};
use crate::graph::Value;

impl Lowering<'_> {
    /// Whether the first value is less than the second.
    pub(super) fn comparison(&mut self, value: Value, [a, b]: [NodeId; 2]) -> NodeId {
        let is_zero = |id| self.constant(id) == Some(0);
        let at = place(&value);
        if is_zero(a) && self.range(b).low >= 0 {
            let op = self.any(at, a, b);
            return self.push(Value { op, ..value });
        }
        // Of a value less than zero it is the sign alone.
        if is_zero(b) || self.range(a).width().max(self.range(b).width()) <= NARROW {
            return self.push(value);
        }
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

    /// Whether any bit of a value without sign is 1, in parts of a few look-up tables.
    fn any(&mut self, at: Place, zero: NodeId, id: NodeId) -> Op {
        if self.range(id).width() <= TWO_LEVELS {
            return Op::LessThan(zero, id);
        }
        let parts = [self.low(at, id, TWO_LEVELS), self.high(at, id, TWO_LEVELS)];
        let [low, high] = parts.map(|part| {
            let op = self.any(at, zero, part);
            self.emit(at, op, Range::new(0, 1), "any")
        });
        Op::Or(low, high)
    }

    /// Every value of as many bits as a value has; a constant alone.
    fn whole(&self, id: NodeId) -> Range {
        let range = self.range(id);
        range.only().map_or(Range::whole(range.width(), range.signed()), Range::single)
    }
}

/// Bits up to which a comparison is a few look-up tables.
const NARROW: u32 = 2;
/// Bits of which two look-up tables in a row see whether any is 1.
const TWO_LEVELS: u32 = 16;
