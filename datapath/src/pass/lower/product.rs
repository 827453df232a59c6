//! Products: in as few multiplier blocks as can be, and those with constants in logic where that is
//! cheaper than a block.
//!
//! A factor that is wider than a block's port is cut at the port's width without sign, k bits:
//!
//! ```text
//! a b = floor(a / 2^k) b 2^k + (a mod 2^k) b
//! a a = floor(a / 2^k)^2 2^2k + 2 floor(a / 2^k) (a mod 2^k) 2^k + (a mod 2^k)^2
//! ```
//!
//! A part of one or two bits is no product but a choice.
use super::constant::digits;
use super::sign::Negative;
use super::{Lowering, Place, narrowed, place};
use crate::design::{NodeId, Op, Range};
use crate::graph::Value;
use crate::names::unique;
use crate::target::Multiplier;

/// Bits of a factor up to which a product is a sum of choices.
const FEW_BITS: u32 = 2;

impl Lowering<'_> {
    /// A product.
    pub(super) fn product(&mut self, value: Value, [a, b]: [NodeId; 2]) -> NodeId {
        let at = place(&value);
        let op = match (self.constant(a), self.constant(b)) {
            (Some(_), None) => self.multiplied(at, [b, a], value.range),
            _ => self.multiplied(at, [a, b], value.range),
        };
        self.finished(Value { op, ..value })
    }

    /// The negative of a product with a constant.
    pub(super) fn negative_product(&mut self, product: Value, negative: Negative) -> NodeId {
        let at = place(&product);
        let variable = self.new[negative.variable.0 as usize];
        let constant = self.integer(at, negative.constant);
        let name = unique(&mut self.names, at.scope, &format!("{}_negative", at.name));
        self.product(Value { range: negative.range, name, ..product }, [variable, constant])
    }

    /// The operator that gives a product, whose parts are added before. A constant comes second.
    fn multiplied(&mut self, at: Place, [a, b]: [NodeId; 2], range: Range) -> Op {
        if let Some(constant) = self.constant(b).filter(|&constant| constant != 0)
            && self.is_cheaper_in_logic(a, constant)
            && let Some(op) = self.times_constant(at, a, constant, range)
        {
            return op;
        }
        let few = |id| self.range(id).width() <= FEW_BITS && self.constant(id).is_none();
        if few(b) {
            return self.chosen(at, [a, b], range);
        }
        if few(a) {
            return self.chosen(at, [b, a], range);
        }
        let Some(multiplier) = self.target.multiplier.clone() else {
            return self.rows(at, [a, b], range);
        };
        self.tiled(at, [a, b], range, &multiplier)
    }

    /// Whether the adders of a product with a constant are worth less than its blocks.
    fn is_cheaper_in_logic(&self, variable: NodeId, constant: i64) -> bool {
        let adders = digits(constant).len().saturating_sub(1) as u32;
        let bits = adders * self.range(variable).width();
        self.target.multiplier.as_ref().is_none_or(|multiplier| bits < multiplier.worth)
    }

    /// A product with a factor of one or two bits, the second.
    fn chosen(&mut self, at: Place, [a, b]: [NodeId; 2], range: Range) -> Op {
        let factor = self.range(b);
        let zero = self.integer(at, 0);
        let bit = |lowering: &mut Self, place: u32| {
            let high = lowering.high(at, b, place);
            lowering.low(at, high, 1)
        };
        let low_bit = bit(self, 0);
        let row = self.range(a).hull(Range::single(0));
        if factor.width() == 1 {
            // 0 and 1, or 0 and -1.
            let once = self.emit(at, Op::Select(low_bit, a, zero), row, "once");
            return if factor.signed() {
                Op::Copy(self.new_sum(at, Op::Sub(zero, once), range, "negative"))
            } else {
                Op::Copy(once)
            };
        }
        let once = self.emit(at, Op::Select(low_bit, a, zero), row, "once");
        let high_bit = bit(self, 1);
        let twice = self.emit(at, Op::Select(high_bit, a, zero), row, "twice");
        let twice = self.shifted(at, twice, 1);
        // The second bit of a signed factor counts -2.
        let op = if factor.signed() { Op::Sub(once, twice) } else { Op::Add(once, twice) };
        let sum = self.new_sum(at, op, range, "chosen");
        Op::Copy(sum)
    }

    /// A product without blocks: a sum over the second factor's pairs of bits.
    fn rows(&mut self, at: Place, [a, b]: [NodeId; 2], range: Range) -> Op {
        let [a, b] = if self.range(a).width() < self.range(b).width() { [b, a] } else { [a, b] };
        let width = self.range(b).width();
        let mut rows: Vec<(u32, NodeId)> = vec![];
        for at_bit in (0..width).step_by(FEW_BITS as usize) {
            let high = self.high(at, b, at_bit);
            let last = at_bit + FEW_BITS >= width;
            let part = if last { high } else { self.low(at, high, FEW_BITS) };
            let shape = self.range(a).times(self.range(part));
            let shape = shape.narrow().unwrap_or(range);
            let op = self.chosen(at, [a, part], shape);
            rows.push((at_bit, self.emit(at, op, shape, "row")));
        }
        Op::Copy(self.total(at, rows, range))
    }

    /// A product in blocks.
    fn tiled(
        &mut self,
        at: Place,
        [a, b]: [NodeId; 2],
        range: Range,
        multiplier: &Multiplier,
    ) -> Op {
        let [long, short] = multiplier.widths;
        let [long_unsigned, short_unsigned] = multiplier.unsigned;
        let fits = |id: NodeId, signed: u32, unsigned: u32| {
            let range = self.range(id);
            range.width() <= if range.signed() { signed } else { unsigned }
        };
        let wide = |id| !fits(id, long, long_unsigned);
        let narrow = |id| fits(id, short, short_unsigned);
        if !wide(a) && narrow(b) || !wide(b) && narrow(a) {
            return Op::Mul(a, b);
        }
        if a == b {
            return self.squared(at, a, range, multiplier);
        }
        // The wider factor is cut first.
        let [a, b] = if self.range(a).width() < self.range(b).width() { [b, a] } else { [a, b] };
        let cut = if narrow(b) { long_unsigned } else { short_unsigned };
        let low = self.low(at, a, cut);
        let high = self.high(at, a, cut);
        let parts = [low, high].map(|part| {
            let shape = narrowed(self.range(part).times(self.range(b)));
            let op = self.multiplied(at, [part, b], shape);
            self.emit(at, op, shape, "tile")
        });
        let total = self.total(at, vec![(0, parts[0]), (cut, parts[1])], range);
        Op::Copy(total)
    }

    /// A square of a value that is wider than a block's ports.
    fn squared(&mut self, at: Place, a: NodeId, range: Range, multiplier: &Multiplier) -> Op {
        let cut = multiplier.unsigned[1];
        let low = self.low(at, a, cut);
        let high = self.high(at, a, cut);
        let parts = [(low, low, 0), (low, high, cut + 1), (high, high, 2 * cut)];
        let parts = parts.map(|(first, second, shift)| {
            let shape = if first == second {
                narrowed(self.range(first).squared())
            } else {
                narrowed(self.range(first).times(self.range(second)))
            };
            let op = self.multiplied(at, [first, second], shape);
            (shift, self.emit(at, op, shape, "tile"))
        });
        Op::Copy(self.total(at, parts.to_vec(), range))
    }

    /// The sum of values times powers of two, which has this range.
    fn total(&mut self, at: Place, parts: Vec<(u32, NodeId)>, range: Range) -> NodeId {
        let mut parts = parts;
        while parts.len() > 1 {
            let last = parts.len() == 2;
            let pairs: Vec<Vec<(u32, NodeId)>> = parts.chunks(2).map(<[_]>::to_vec).collect();
            parts =
                pairs.into_iter().map(|pair| self.pair(at, &pair, last.then_some(range))).collect();
        }
        // There is a part at least, and it comes first where it is the only one.
        let (shift, only) = parts[0];
        self.shifted(at, only, shift)
    }

    /// Two neighbours as one, which has this range if one is given; a last one stays.
    fn pair(&mut self, at: Place, pair: &[(u32, NodeId)], range: Option<Range>) -> (u32, NodeId) {
        let [(low_shift, low), (high_shift, high)] = *pair else { return pair[0] };
        let shifted = self.shifted(at, high, high_shift - low_shift);
        let sum = narrowed(self.range(low).plus(self.range(shifted)));
        let range = range.filter(|_| low_shift == 0).unwrap_or(sum);
        (low_shift, self.new_sum(at, Op::Add(low, shifted), range, "tiles"))
    }
}
