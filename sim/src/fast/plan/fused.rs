//! The kernel for a product, and for an operator that others have been fused into.
use specula_datapath::design::{NodeId, Op, Range};
use specula_kernels::{
    Arithmetic, Magnitude, Post, Products, Second, Wrap, extreme, narrow_products,
    products_through_wide, wide_products,
};

use super::Planner;
use crate::fast::flow::{Factor, Fused};
use crate::fast::memory::fits_narrow;
use crate::fast::read::Read;
use crate::fast::step::{Sum, Work};

/// Products whose widths add up to this many bits, and sums of three of them, are 2^51 at most.
const EXACT_BITS: u32 = 49;

impl Planner<'_> {
    pub(super) fn fused(&mut self, root: NodeId, fused: &Fused) -> Work {
        match fused {
            Fused::Extreme(which, [a, b]) => {
                let skew = self.skews[&root];
                let (a, b) = (self.read_factor(*a, skew), self.read_factor(*b, skew));
                Work::Narrow(
                    extreme(*which, self.fusion.post(root).wrap, self.instruction_set),
                    a,
                    b,
                )
            }
            Fused::Products(factors, second) => self.products(root, factors, *second),
        }
    }

    /// The kernel of a product.
    pub(super) fn product(&mut self, root: NodeId, a: NodeId, b: NodeId, post: Post) -> Work {
        match [a, b].map(|operand| self.factor(operand)) {
            [Some(a), Some(b)] => self.products(root, &[[a, b]], Second::Added),
            _ => self.arithmetic(Arithmetic::Mul, root, a, b, post),
        }
    }

    /// An operand with 32-bit lanes.
    fn factor(&self, operand: NodeId) -> Option<Factor> {
        let source = self.flow.source(operand);
        match self.node(source.root).op {
            Op::Constant(value) => i32::try_from(value).ok().map(Factor::Constant),
            _ => (!self.is_wide(source.root)).then_some(Factor::Variable(source)),
        }
    }

    /// The kernel of one product or more.
    fn products(&mut self, root: NodeId, factors: &[[Factor; 2]], second: Second) -> Work {
        let skew = self.skews[&root];
        let magnitude = self.magnitude(factors);
        let reads: Vec<[Read; 2]> =
            factors.iter().map(|pair| pair.map(|factor| self.read_factor(factor, skew))).collect();
        match reads[..] {
            [a] => self.sum(root, [a], second, magnitude),
            [a, b] => self.sum(root, [a, b], second, magnitude),
            [a, b, c] => self.sum(root, [a, b, c], second, magnitude),
            _ => unreachable!("one to three products are fused"),
        }
    }

    fn sum<const N: usize>(
        &self,
        root: NodeId,
        factors: [[Read; 2]; N],
        second: Second,
        magnitude: Magnitude,
    ) -> Work
    where
        Sum<N>: Into<Work>,
    {
        let (post, instruction_set) = (self.fusion.post(root), self.instruction_set);
        let sum = if self.is_wide(root) {
            Sum::Wide(wide_products(second, magnitude, post, instruction_set), factors)
        } else {
            Sum::Narrow(self.narrow_sum(root, second, magnitude, post), factors)
        };
        sum.into()
    }

    fn narrow_sum<const N: usize>(
        &self,
        root: NodeId,
        second: Second,
        magnitude: Magnitude,
        post: Post,
    ) -> Products<i32, N> {
        // Before the first pixel, a value may be whatever its width allows.
        let range = self.node(root).range;
        if computes_narrow(Range::whole(range.width(), range.signed()), post) {
            narrow_products(second, post, self.instruction_set)
        } else {
            products_through_wide(second, magnitude, post, self.instruction_set)
        }
    }

    /// Before the first pixel, a factor may be whatever its width allows.
    fn magnitude(&self, factors: &[[Factor; 2]]) -> Magnitude {
        let width = |factor: &Factor| match factor {
            Factor::Variable(source) => self.node(self.fusion.stored(source.root)).width(),
            Factor::Constant(value) => Range::single(i64::from(*value)).width(),
        };
        let fits = |pair: &[Factor; 2]| pair.iter().map(width).sum::<u32>() <= EXACT_BITS;
        if factors.iter().all(fits) { Magnitude::UpTo51Bits } else { Magnitude::Any }
    }

    fn read_factor(&mut self, factor: Factor, skew: u64) -> Read {
        match factor {
            Factor::Variable(source) => {
                Read { place: self.places[&source.root], back: self.back(source, skew) }
            }
            Factor::Constant(value) => self.constant(value.into(), false),
        }
    }
}

/// Whether 32-bit lanes hold a raw result of this range and what becomes of it. What is wrapped
/// first may be whatever its width allows.
pub(super) fn computes_narrow(raw: Range, post: Post) -> bool {
    let shifted = match post.first {
        Wrap::None => raw,
        Wrap::Signed(width) => Range::whole(width, true),
        Wrap::Unsigned(width) => Range::whole(width, false),
    };
    fits_narrow(raw)
        && fits_narrow(Range::new(shifted.low, shifted.high.saturating_add(post.half())))
}
