//! Products, and what is as good as one, go into the sum or difference that reads them.
use specula_datapath::design::{NodeId, Op};
use specula_kernels::{Post, Second};

use super::{Fused, Fuser, Source};
use crate::fast::flow::Factor;

/// Products in a kernel, at most.
const MOST: usize = 3;
/// A shift to the left by at most so many bits is a product with 32-bit lanes.
const MOST_LEFT: u32 = 30;

/// A sum of products, those that are subtracted, and a constant.
#[derive(Default)]
struct Sum {
    added: Vec<[Factor; 2]>,
    subtracted: Vec<[Factor; 2]>,
    plus: i64,
}

impl Sum {
    fn product(a: Factor, b: Factor) -> Sum {
        Sum { added: vec![[a, b]], ..Sum::default() }
    }

    /// `None` where constants overflow.
    fn and(mut self, other: Sum) -> Option<Sum> {
        self.added.extend(other.added);
        self.subtracted.extend(other.subtracted);
        self.plus = self.plus.checked_add(other.plus)?;
        Some(self)
    }

    fn negated(self) -> Option<Sum> {
        Some(Sum { added: self.subtracted, subtracted: self.added, plus: self.plus.checked_neg()? })
    }

    /// The same, some clocks later. Registers hold 0 at first, so what is not 0 for operands of 0
    /// cannot be.
    fn later(mut self, clocks: u32) -> Option<Sum> {
        let mut pairs = self.added.iter().chain(&self.subtracted);
        let starts_at_0 = self.plus == 0
            && !pairs.any(|pair| pair.iter().all(|factor| matches!(factor, Factor::Constant(_))));
        if clocks > 0 && !starts_at_0 {
            return None;
        }
        for factor in self.added.iter_mut().chain(&mut self.subtracted).flatten() {
            *factor = factor.later(clocks);
        }
        Some(self)
    }

    /// As a kernel computes it, if one does.
    fn fused(self) -> Option<(Fused, Post)> {
        let Sum { mut added, subtracted, plus } = self;
        let count = added.len() + subtracted.len();
        if added.is_empty() || subtracted.len() > 1 || count > MOST {
            return None;
        }
        let second = if subtracted.is_empty() { Second::Added } else { Second::Subtracted };
        added.splice(1..1, subtracted);
        Some((Fused::Products(added, second), Post { plus, ..Post::default() }))
    }
}

impl Fuser<'_> {
    /// a + b with the products that only this reads.
    pub(super) fn sum(&self, id: NodeId, a: NodeId, b: NodeId) -> Option<(Fused, Post)> {
        if !self.pays(id, a, b) {
            return None;
        }
        self.summand(id, a)?.and(self.summand(id, b)?)?.fused()
    }

    /// a - b with the products that only this reads.
    pub(super) fn difference(&self, id: NodeId, a: NodeId, b: NodeId) -> Option<(Fused, Post)> {
        if !self.pays(id, a, b) {
            return None;
        }
        self.summand(id, a)?.and(self.summand(id, b)?.negated()?)?.fused()
    }

    /// Whether an operand has products.
    fn pays(&self, id: NodeId, a: NodeId, b: NodeId) -> bool {
        [a, b].into_iter().any(|operand| self.inner(id, self.flow.source(operand)).is_some())
    }

    /// An operand of `id` as a sum of products: those that only `id` reads, or its column times 1.
    fn summand(&self, id: NodeId, operand: NodeId) -> Option<Sum> {
        let source = self.flow.source(operand);
        match self.op(source.root) {
            Op::Constant(plus) => Some(Sum { plus, ..Sum::default() }),
            _ => self
                .inner(id, source)
                .or_else(|| Some(Sum::product(self.factor(source)?, Factor::Constant(1)))),
        }
    }

    /// The products of an operand that only `id` reads.
    fn inner(&self, id: NodeId, Source { root, delay }: Source) -> Option<Sum> {
        if !self.serves(root, id) || !self.is_untouched(root) {
            return None;
        }
        let sum = match (self.flow.fused.get(&root), self.op(root)) {
            (Some(Fused::Products(products, second)), _) => {
                let mut added = products.clone();
                let subtracted =
                    if *second == Second::Subtracted { vec![added.remove(1)] } else { vec![] };
                Sum { added, subtracted, plus: self.fusion.post(root).plus }
            }
            (None, Op::Mul(a, b)) => {
                Sum::product(self.factor(self.flow.source(a))?, self.factor(self.flow.source(b))?)
            }
            (None, Op::ShiftLeft(a, bits)) if bits <= MOST_LEFT => {
                Sum::product(self.factor(self.flow.source(a))?, Factor::Constant(1 << bits))
            }
            _ => return None,
        };
        sum.later(delay)
    }

    /// A factor with 32-bit lanes.
    pub(super) fn factor(&self, source: Source) -> Option<Factor> {
        match self.op(source.root) {
            Op::Constant(value) => i32::try_from(value).ok().map(Factor::Constant),
            _ => self.has_narrow_lanes(source.root).then_some(Factor::Variable(source)),
        }
    }
}
