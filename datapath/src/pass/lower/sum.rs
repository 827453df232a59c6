//! Sums and differences, long ones in pieces: with k bits in the low piece,
//!
//! ```text
//! low  = a mod 2^k + b mod 2^k                     its bit k is the carry c
//! high = floor(a / 2^k) + floor(b / 2^k) + c
//!      = floor((2 floor(a / 2^k) + 1 + 2 floor(b / 2^k) + c) / 2)
//! ```
//!
//! so that the carry enters the high piece's own carry chain. Differences borrow likewise. What
//! stands below one operand's lowest bit that is ever 1 passes without an adder.
use super::{Lowering, Place, place};
use crate::design::{NodeId, Op, Range};
use crate::graph::Value;

impl Lowering<'_> {
    /// A sum or difference.
    pub(super) fn sum(&mut self, value: Value) -> NodeId {
        let op = self.summed(place(&value), value.op, value.range);
        self.finished(Value { op, ..value })
    }

    /// A new sum or difference with this range.
    pub(super) fn new_sum(&mut self, at: Place, op: Op, range: Range, part: &str) -> NodeId {
        let op = self.summed(at, op, range);
        self.emit(at, op, range, part)
    }

    /// The operator that gives a sum or difference, whose parts are added before.
    fn summed(&mut self, at: Place, op: Op, range: Range) -> Op {
        let (a, b) = match op {
            Op::Add(a, b) | Op::Sub(a, b) => (a, b),
            _ => return op,
        };
        let is_sum = matches!(op, Op::Add(..));
        if is_sum && self.constant(a) == Some(0) {
            return Op::Copy(b);
        }
        if self.constant(b) == Some(0) {
            return Op::Copy(a);
        }
        if is_sum && self.zeros(a) > self.zeros(b) {
            return self.summed(at, Op::Add(b, a), range);
        }
        match self.zeros(b) {
            0 => {}
            passing if passing < range.width() => {
                return self.above(at, [a, b], is_sum, range, passing);
            }
            // The second operand has no bits that the result has.
            _ => return Op::Wrap(a),
        }
        // An operator has the bits of all that its operands allow, also those that are dropped.
        let whole = self.interval(op).and_then(|whole| whole.narrow().ok());
        let width = whole.map_or(range.width(), |whole| whole.width().max(range.width()));
        if width <= self.widest_sum {
            return op;
        }
        // A piece has a carry on its left, and the next one a bit for it on its right.
        let pieces = width.div_ceil(self.widest_sum - 1);
        let bits = width.div_ceil(pieces);
        // A high piece would be dropped altogether.
        if bits >= range.width() {
            return op;
        }
        self.in_two(at, [a, b], is_sum, range, bits)
    }

    /// The low `bits` of the first operand pass, since the second has none there.
    fn above(
        &mut self,
        at: Place,
        [a, b]: [NodeId; 2],
        is_sum: bool,
        range: Range,
        bits: u32,
    ) -> Op {
        let [high_a, high_b] = [a, b].map(|id| self.high(at, id, bits));
        let op = if is_sum { Op::Add(high_a, high_b) } else { Op::Sub(high_a, high_b) };
        let high = self.new_sum(at, op, range.shifted_right(bits), "above");
        if self.zeros(a) >= bits {
            return Op::ShiftLeft(high, bits);
        }
        let low = self.low(at, a, bits);
        self.joined_with(at, high, low, bits)
    }

    /// The low `bits` first, then the others with the carry.
    fn in_two(
        &mut self,
        at: Place,
        [a, b]: [NodeId; 2],
        is_sum: bool,
        range: Range,
        bits: u32,
    ) -> Op {
        self.carries += 1;
        let [low_a, low_b] = [a, b].map(|id| self.low(at, id, bits));
        let [high_a, high_b] = [a, b].map(|id| self.high(at, id, bits));
        let (low_range_a, low_range_b) = (self.range(low_a), self.range(low_b));
        let (low, carry) = if is_sum {
            let low =
                self.emit(at, Op::Add(low_a, low_b), low_range_a.plus(low_range_b), "low_sum");
            (low, self.emit(at, Op::ShiftRight(low, bits), Range::new(0, 1), "carry"))
        } else {
            let shape = low_range_a.minus(low_range_b);
            let low = self.emit(at, Op::Sub(low_a, low_b), shape, "low_difference");
            let zero = self.integer(at, 0);
            let borrows = self.range(low).low < 0;
            let borrow = |lowering: &mut Self| {
                lowering.emit(at, Op::LessThan(low, zero), Range::new(0, 1), "borrow")
            };
            (low, if borrows { borrow(self) } else { zero })
        };
        let one = self.integer(at, i64::from(is_sum));
        let first = self.with_bit(at, high_a, one);
        let second = self.with_bit(at, high_b, carry);
        let op = if is_sum { Op::Add(first, second) } else { Op::Sub(first, second) };
        let range_of_high = range.shifted_right(bits);
        // Twice the high piece, and 0 or 1.
        let doubled = Range::new(2 * range_of_high.low, 2 * range_of_high.high + 1);
        let twice = self.new_sum(at, op, doubled, "high_sum");
        let high = self.emit(at, Op::ShiftRight(twice, 1), range_of_high, "high");
        let low = self.emit(at, Op::Wrap(low), Range::whole(bits, false), "low");
        self.joined_with(at, high, low, bits)
    }

    /// Twice a value, and a bit.
    pub(super) fn with_bit(&mut self, at: Place, id: NodeId, bit: NodeId) -> NodeId {
        if let (Some(value), Some(bit)) = (self.constant(id), self.constant(bit)) {
            return self.integer(at, 2 * value + bit);
        }
        if self.constant(bit) == Some(0) {
            return self.shifted(at, id, 1);
        }
        let range = self.range(id);
        let op = match self.constant(id) {
            Some(0) => return bit,
            _ => self.joined_with(at, id, bit, 1),
        };
        self.emit(at, op, Range::new(2 * range.low, 2 * range.high + 1), "with_bit")
    }
}
