//! Shifts, rounding and wrapping go into the kernel of the operator before them.
use specula_datapath::design::{Node, NodeId, Op, Range};
use specula_kernels::{Post, Shift, Wrap};

use super::{Fused, Fuser, Source};
use crate::fast::memory::fits_narrow;

/// Most bits that a shift drops before it rounds: there is room for half of what is dropped.
const MOST_BEFORE_ROUNDING: u32 = 61;

impl Fuser<'_> {
    /// Puts a shift, a wrap or the 1 of a rounding into the kernel of its operand, and says whether
    /// it could.
    pub(super) fn narrow(&mut self, id: NodeId) -> bool {
        let Some(operand) = narrowed_operand(self, id) else { return false };
        let Source { root, delay } = self.flow.source(operand);
        if !self.serves(root, id) || !self.takes_in(root, id) {
            return false;
        }
        let post = self.fusion.post(root);
        let fused = match self.op(id) {
            Op::Add(..) => {
                before_shift(post).filter(|post| self.rounds_next(id) && self.has_room(root, *post))
            }
            Op::ShiftRight(_, bits) => before_shift(post)
                .and_then(|post| shifted(post, bits, self.half_rounded.contains(&root))),
            _ if post.wrap == Wrap::None => {
                Some(Post { wrap: wrap_to(self.design.node(id).range), ..post })
            }
            _ => None,
        };
        let Some(post) = fused else { return false };
        if let Op::Add(..) = self.op(id) {
            self.half_rounded.insert(root);
        } else {
            self.half_rounded.remove(&root);
        }
        self.fusion.posts.insert(root, post);
        self.fusion.stored.insert(root, id);
        self.flow.redirect(id, Source { root, delay });
        true
    }

    /// Whether the kernel of a root can do to what it computes what `id` does.
    fn takes_in(&self, root: NodeId, id: NodeId) -> bool {
        match self.flow.fused.get(&root) {
            Some(Fused::Products(..)) => true,
            // Its kernel writes lanes of 32 bits.
            Some(Fused::Extreme(..)) => {
                matches!(self.op(id), Op::Wrap(_)) && fits_narrow(self.design.node(id).range)
            }
            None => matches!(
                self.op(root),
                Op::Add(..) | Op::Sub(..) | Op::Mul(..) | Op::ShiftRight(..) | Op::Wrap(_)
            ),
        }
    }

    /// Whether the next that happens to a sum with 1 is that it is halved.
    fn rounds_next(&self, id: NodeId) -> bool {
        let halves = |next: NodeId| matches!(self.op(next), Op::ShiftRight(a, 1) if self.flow.source(a).root == id);
        self.readers.only(id).is_some_and(|next| next > id && halves(next))
    }

    /// Whether the half of rounding can be added to what the kernel of a root computes.
    fn has_room(&self, root: NodeId, post: Post) -> bool {
        let dropped = match post.shift {
            Shift::None => 0,
            Shift::Floor(bits) => bits,
            Shift::Round(_) => return false,
        };
        // A shift or wrap that stands alone copies its operand.
        let raw = match self.op(root) {
            Op::ShiftRight(a, _) | Op::Wrap(a) => a,
            _ => root,
        };
        let most = match post.first {
            Wrap::None => highest(self.design.node(raw).range),
            Wrap::Signed(width) => Range::whole(width, true).high,
            Wrap::Unsigned(width) => Range::whole(width, false).high,
        };
        dropped <= MOST_BEFORE_ROUNDING && most.checked_add(1 << dropped).is_some()
    }
}

/// The highest number of a range's width: what it may be before the first pixel.
fn highest(range: Range) -> i64 {
    Range::whole(range.width(), range.signed()).high
}

/// What a shift or wrap that stands alone does to its operand.
pub(super) fn own(node: &Node) -> Option<Post> {
    match node.op {
        Op::ShiftRight(_, bits) => {
            Some(Post { shift: Shift::Floor(bits.min(63)), ..Post::default() })
        }
        Op::Wrap(_) => Some(Post { wrap: wrap_to(node.range), ..Post::default() }),
        _ => None,
    }
}

pub(super) fn wrap_to(range: Range) -> Wrap {
    if range.signed() { Wrap::Signed(range.width()) } else { Wrap::Unsigned(range.width()) }
}

/// The operand that a shift, wrap or addition of 1 works on.
fn narrowed_operand(fuser: &Fuser, id: NodeId) -> Option<NodeId> {
    match fuser.op(id) {
        Op::ShiftRight(a, _) | Op::Wrap(a) => Some(a),
        Op::Add(a, b) if fuser.op(b) == Op::Constant(1) => Some(a),
        _ => None,
    }
}

/// The same, so that a shift can follow: bits dropped on the left are dropped before it.
fn before_shift(post: Post) -> Option<Post> {
    match post {
        Post { wrap: Wrap::None, .. } => Some(post),
        Post { first: Wrap::None, shift: Shift::None, wrap, .. } => {
            Some(Post { first: wrap, wrap: Wrap::None, ..post })
        }
        _ => None,
    }
}

fn shifted(post: Post, bits: u32, half_rounded: bool) -> Option<Post> {
    let shift = match post.shift {
        Shift::None if half_rounded => Shift::Round(0),
        Shift::Floor(dropped) if half_rounded => Shift::Round(dropped),
        Shift::None => Shift::Floor(bits.min(63)),
        _ => return None,
    };
    Some(Post { shift, ..post })
}
