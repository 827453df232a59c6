//! Puts shifts, rounding and wrapping into the kernel of the operator before them, where nothing else reads in between.
//!
//! All that is fused maps 0 to 0, so that registers in between, which hold 0 at first, change nothing.
use std::collections::{HashMap, HashSet};

use specula_hdl::Design;
use specula_hdl::design::{NodeId, Op, Range};
use specula_kernels::{Post, Shift, Wrap};

use super::flow::{Flow, Source};
use super::idle::overflowing;

/// What is done to the raw result of each root, and the range of what is stored.
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
            for operand in flow.operands(design, user) {
                let root = flow.source(operand).root;
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

/// Fuses what can be fused; `flow` then leads past what was.
pub fn fuse(
    design: &Design,
    flow: &mut Flow,
    needed: &[NodeId],
    watched: &[NodeId],
    in_component: &dyn Fn(NodeId) -> bool,
) -> Fusion {
    let readers = Readers::of(design, flow, needed, watched);
    let mut fusion = Fusion { posts: HashMap::new(), stored: HashMap::new() };
    // Roots to which a 1 has been added: the shift that makes a rounding of it comes next.
    let mut half_rounded: HashSet<NodeId> = HashSet::new();
    let overflowing = overflowing(design);
    for &id in needed {
        if let Some(value) = own_post(design, id) {
            fusion.posts.insert(id, value);
        }
        if overflowing.contains(&id) {
            fusion.posts.insert(id, Post { shift: Shift::None, wrap: wrap_to(design.node(id).range) });
            continue;
        }
        if in_component(id) || flow.recurrences[id.0 as usize].is_some() {
            continue;
        }
        // A register may read a later signal without being feedback; what has not been looked at yet cannot take it in.
        let Some(operand) = narrowed_operand(design, id).filter(|&operand| operand < id) else { continue };
        let Source { root, delay } = flow.source(operand);
        let reads_alone = readers.only(fusion.stored(root)) == Some(id);
        let absorbs = is_arithmetic(design, root) && !in_component(root) && flow.recurrences[root.0 as usize].is_none();
        if !reads_alone || !absorbs {
            continue;
        }
        let post = fusion.post(root);
        let node = design.node(id);
        let fused = match node.op {
            Op::Add(..) => {
                let shift_follows = readers.only(id).is_some_and(|next| next > id && is_halving(design, flow, next, id));
                if post.wrap == Wrap::None && !matches!(post.shift, Shift::Round(_)) && shift_follows {
                    half_rounded.insert(root);
                    Some(post)
                } else {
                    None
                }
            }
            Op::ShiftRight(_, bits) => shifted(post, bits, half_rounded.remove(&root)),
            Op::Wrap(_) if post.wrap == Wrap::None => Some(Post { wrap: wrap_to(node.range), ..post }),
            _ => None,
        };
        if let Some(post) = fused {
            fusion.posts.insert(root, post);
            fusion.stored.insert(root, id);
            redirect(flow, id, Source { root, delay });
        }
    }
    fusion
}

/// Signals that came from `id` now come from `source`, and as many clocks later as before.
fn redirect(flow: &mut Flow, id: NodeId, source: Source) {
    for s in &mut flow.sources {
        if s.root == id {
            *s = Source { root: source.root, delay: source.delay + s.delay };
        }
    }
}

/// What a shift or wrap that stands alone does to its operand.
fn own_post(design: &Design, id: NodeId) -> Option<Post> {
    let node = design.node(id);
    match node.op {
        Op::ShiftRight(_, bits) => Some(Post { shift: Shift::Floor(bits.min(63)), wrap: Wrap::None }),
        Op::Wrap(_) => Some(Post { shift: Shift::None, wrap: wrap_to(node.range) }),
        _ => None,
    }
}

fn wrap_to(range: Range) -> Wrap {
    if range.signed() { Wrap::Signed(range.width()) } else { Wrap::Unsigned(range.width()) }
}

/// The operand that a shift, wrap or addition of 1 works on.
fn narrowed_operand(design: &Design, id: NodeId) -> Option<NodeId> {
    match design.node(id).op {
        Op::ShiftRight(a, _) | Op::Wrap(a) => Some(a),
        Op::Add(a, b) if design.node(b).op == Op::Constant(1) => Some(a),
        _ => None,
    }
}

fn is_arithmetic(design: &Design, root: NodeId) -> bool {
    matches!(design.node(root).op, Op::Add(..) | Op::Sub(..) | Op::Mul(..) | Op::ShiftRight(..) | Op::Wrap(_))
}

fn is_halving(design: &Design, flow: &Flow, next: NodeId, of: NodeId) -> bool {
    matches!(design.node(next).op, Op::ShiftRight(a, 1) if flow.source(a).root == of)
}

fn shifted(post: Post, bits: u32, half_rounded: bool) -> Option<Post> {
    match (post.shift, post.wrap) {
        (Shift::None, Wrap::None) if half_rounded => Some(Post { shift: Shift::Round(0), ..post }),
        (Shift::Floor(dropped), Wrap::None) if half_rounded => Some(Post { shift: Shift::Round(dropped), ..post }),
        (Shift::None, Wrap::None) => Some(Post { shift: Shift::Floor(bits.min(63)), ..post }),
        _ => None,
    }
}
