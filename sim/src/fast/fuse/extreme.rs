//! A comparison and the choice between what it compares are the smaller or the larger of the two.
use specula_datapath::design::{NodeId, Op};
use specula_kernels::{Extreme, Post, Wrap};

use super::{Fused, Fuser, post};
use crate::fast::flow::raw_range;

impl Fuser<'_> {
    /// The extreme that a choice comes to, if only it reads its condition. A register between the
    /// two would be 0 at first, and the choice the second.
    pub(super) fn extreme(
        &self,
        id: NodeId,
        condition: NodeId,
        [yes, no]: [NodeId; 2],
    ) -> Option<(Fused, Post)> {
        let condition = self.flow.source(condition);
        let Op::LessThan(a, b) = self.op(condition.root) else { return None };
        if condition.delay > 0
            || !self.serves(condition.root, id)
            || !self.is_untouched(condition.root)
        {
            return None;
        }
        let which = match (self.are_same([yes, no], [a, b]), self.are_same([yes, no], [b, a])) {
            (true, _) => Extreme::Min,
            (_, true) => Extreme::Max,
            _ => return None,
        };
        let operands = [self.factor(self.flow.source(a))?, self.factor(self.flow.source(b))?];
        let range = self.design.node(id).range;
        let stays_within =
            raw_range(self.design, self.op(id)).narrow().is_ok_and(|raw| range.hull(raw) == range);
        let wrap = if stays_within { Wrap::None } else { post::wrap_to(range) };
        self.has_narrow_lanes(id)
            .then_some((Fused::Extreme(which, operands), Post { wrap, ..Post::default() }))
    }

    fn are_same(&self, these: [NodeId; 2], those: [NodeId; 2]) -> bool {
        let same = |a: NodeId, b: NodeId| {
            let (a, b) = (self.flow.source(a), self.flow.source(b));
            a == b
                || self
                    .op(a.root)
                    .constant()
                    .is_some_and(|value| self.op(b.root).constant() == Some(value))
        };
        these.into_iter().zip(those).all(|(a, b)| same(a, b))
    }
}
