//! Puts operators into the kernel of the operator behind or before them, where nothing else reads
//! in between.
//!
//! All that is fused over a register maps 0 to 0, so that registers in between, which hold 0 at
//! first, change nothing.
mod extreme;
mod post;
mod products;

use std::collections::{HashMap, HashSet};

use specula_datapath::Design;
use specula_datapath::design::{NodeId, Op};
use specula_kernels::Post;

use super::flow::{Flow, Fused, Source};
use super::memory::fits_narrow;

/// What is done to the raw result of each root, and the range of what is stored.
#[derive(Default)]
pub struct Fusion {
    posts: HashMap<NodeId, Post>,
    stored: HashMap<NodeId, NodeId>,
}

impl Fusion {
    /// What happens to the raw result of `root` before it is stored.
    pub fn post(&self, root: NodeId) -> Post {
        self.posts.get(&root).copied().unwrap_or_default()
    }

    /// The signal whose (unregistered) value the column of `root` holds.
    pub fn stored(&self, root: NodeId) -> NodeId {
        self.stored.get(&root).copied().unwrap_or(root)
    }
}

/// The readers of each root.
struct Readers {
    /// The only reader, or `None` where there are more or the value is watched.
    only: HashMap<NodeId, Option<NodeId>>,
}

impl Readers {
    fn of(design: &Design, flow: &Flow, needed: &[NodeId], watched: &[NodeId]) -> Readers {
        let mut only: HashMap<NodeId, Option<NodeId>> = HashMap::new();
        for &user in needed {
            for Source { root, .. } in flow.operands(design, user) {
                only.entry(root).and_modify(|reader| *reader = None).or_insert(Some(user));
            }
        }
        for &id in watched {
            only.insert(flow.source(id).root, None);
        }
        Readers { only }
    }

    fn only(&self, root: NodeId) -> Option<NodeId> {
        self.only.get(&root).copied().flatten()
    }
}

/// Fuses what can be fused of the roots that are needed for what is watched; `flow` then leads past
/// what was. What may overflow stays as it is, and is wrapped.
pub fn fuse(
    design: &Design,
    flow: &mut Flow,
    (needed, watched): (&[NodeId], &[NodeId]),
    in_component: &dyn Fn(NodeId) -> bool,
    overflowing: HashSet<NodeId>,
) -> Fusion {
    let readers = Readers::of(design, flow, needed, watched);
    let (fusion, half_rounded) = (Fusion::default(), HashSet::new());
    let mut fuser =
        Fuser { design, flow, readers, in_component, overflowing, fusion, half_rounded };
    for &id in needed {
        fuser.look_at(id);
    }
    fuser.fusion
}

/// Fusing under way.
struct Fuser<'a> {
    design: &'a Design,
    flow: &'a mut Flow,
    readers: Readers,
    in_component: &'a dyn Fn(NodeId) -> bool,
    overflowing: HashSet<NodeId>,
    fusion: Fusion,
    /// Roots to which a 1 has been added: the shift that makes a rounding of it comes next.
    half_rounded: HashSet<NodeId>,
}

impl Fuser<'_> {
    fn look_at(&mut self, id: NodeId) {
        let op = self.op(id);
        if let Some(value) = post::own(self.design.node(id)) {
            self.fusion.posts.insert(id, value);
        }
        if self.overflowing.contains(&id) {
            let wrap = post::wrap_to(self.design.node(id).range);
            self.fusion.posts.insert(id, Post { wrap, ..Post::default() });
        } else if !self.stands_apart(id) && !self.narrow(id) {
            let fused = match op {
                Op::Add(a, b) => self.sum(id, a, b),
                Op::Sub(a, b) => self.difference(id, a, b),
                Op::Select(condition, yes, no) => self.extreme(id, condition, [yes, no]),
                _ => None,
            };
            if let Some((fused, post)) = fused {
                self.flow.fused.insert(id, fused);
                self.fusion.posts.insert(id, post);
            }
        }
    }

    fn op(&self, id: NodeId) -> Op {
        self.design.node(id).op
    }

    /// Whether a signal is evaluated in a way of its own.
    fn stands_apart(&self, id: NodeId) -> bool {
        (self.in_component)(id) || self.flow.recurrences[id.0 as usize].is_some()
    }

    /// Whether nobody but `reader` reads a root, and so its operator can be evaluated with the
    /// reader's. A register may read a later signal without being feedback; what has not been
    /// looked at yet cannot be taken in.
    fn serves(&self, root: NodeId, reader: NodeId) -> bool {
        root < reader
            && self.readers.only(self.fusion.stored(root)) == Some(reader)
            && !self.stands_apart(root)
    }

    /// Whether a root's column holds the exact result of its operator.
    fn is_untouched(&self, root: NodeId) -> bool {
        let post = self.fusion.post(root);
        self.fusion.stored(root) == root && post == Post { plus: post.plus, ..Post::default() }
    }

    /// Whether a column has 32-bit lanes.
    fn has_narrow_lanes(&self, root: NodeId) -> bool {
        fits_narrow(self.design.node(self.fusion.stored(root)).range)
    }
}
