//! What has to be evaluated, in which order, and how far ahead.
use std::collections::{HashMap, HashSet};

use petgraph::algo::tarjan_scc;
use petgraph::graph::{DiGraph, NodeIndex};
use specula_datapath::Design;
use specula_datapath::design::NodeId;

use super::flow::{Flow, Source};

/// Signals that are evaluated together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Group {
    /// One signal, a column at a time.
    Column(NodeId),
    /// Signals that feed back on each other, clock by clock, in this order.
    Component(Vec<NodeId>),
}

impl Group {
    /// The signals of the group.
    pub fn members(&self) -> &[NodeId] {
        match self {
            Group::Column(id) => std::slice::from_ref(id),
            Group::Component(members) => members,
        }
    }
}

fn is_constant(design: &Design, id: NodeId) -> bool {
    design.node(id).op.constant().is_some()
}

fn operand_roots(design: &Design, flow: &Flow, root: NodeId) -> Vec<NodeId> {
    flow.operands(design, root)
        .into_iter()
        .map(|source| source.root)
        .filter(|&r| !is_constant(design, r))
        .collect()
}

/// The roots that the watched signals depend on, in id order.
pub fn needed(design: &Design, flow: &Flow, watched: &[NodeId]) -> Vec<NodeId> {
    let mut seen = HashSet::new();
    let mut open: Vec<NodeId> = watched.iter().map(|&w| flow.source(w).root).collect();
    while let Some(root) = open.pop() {
        if !is_constant(design, root) && seen.insert(root) {
            open.extend(operand_roots(design, flow, root));
        }
    }
    let mut roots: Vec<NodeId> = seen.into_iter().collect();
    roots.sort_unstable();
    roots
}

/// The members of all components.
pub fn in_components(groups: &[Group]) -> HashSet<NodeId> {
    let members = |group: &Group| match group {
        Group::Component(members) => members.clone(),
        Group::Column(_) => vec![],
    };
    groups.iter().flat_map(members).collect()
}

/// The groups of `roots`, operands first.
pub fn groups(design: &Design, flow: &Flow, roots: &[NodeId]) -> Vec<Group> {
    let mut graph: DiGraph<NodeId, ()> = DiGraph::new();
    let places: HashMap<NodeId, NodeIndex> =
        roots.iter().map(|&root| (root, graph.add_node(root))).collect();
    for &root in roots {
        for operand in operand_roots(design, flow, root) {
            if let Some(&place) = places.get(&operand) {
                graph.add_edge(places[&root], place, ());
            }
        }
    }
    let reads_itself = |id: NodeId| operand_roots(design, flow, id).contains(&id);
    let group = |component: Vec<NodeIndex>| {
        let mut members: Vec<NodeId> = component.into_iter().map(|place| graph[place]).collect();
        members.sort_unstable();
        match members[..] {
            [only] if !reads_itself(only) => Group::Column(only),
            _ => Group::Component(in_evaluation_order(design, flow, members)),
        }
    };
    // An edge leads from a reader to what it reads, so Tarjan's order has operands first.
    tarjan_scc(&graph).into_iter().map(group).collect()
}

/// The members of a component such that each comes behind those that it reads in the same clock.
fn in_evaluation_order(design: &Design, flow: &Flow, members: Vec<NodeId>) -> Vec<NodeId> {
    let reads_at_once = |id: NodeId| {
        let sources = flow.operands(design, id).into_iter();
        sources
            .filter(|s| s.delay == 0)
            .map(|s| s.root)
            .filter(|root| members.contains(root))
            .collect::<Vec<_>>()
    };
    let mut ordered = vec![];
    let mut left = members.clone();
    while !left.is_empty() {
        let ready = |id: &NodeId| reads_at_once(*id).iter().all(|root| ordered.contains(root));
        let next: Vec<NodeId> = left.iter().copied().filter(ready).collect();
        if next.is_empty() {
            // A loop without a register, which the builder cannot make: any order is as good.
            ordered.append(&mut left);
        }
        left.retain(|id| !next.contains(id));
        ordered.extend(next);
    }
    ordered
}

/// For each root, by how many clocks its column runs ahead: lane p holds clock p + skew.
///
/// In a pipeline whose operands are aligned the skew is the stage, and every operand is read in the
/// lane of its reader. What is still over a run of one frame runs ahead as far as its readers want.
pub fn skews(
    design: &Design,
    flow: &Flow,
    groups: &[Group],
    several_frames: bool,
) -> HashMap<NodeId, u64> {
    let is_still = |root: NodeId| !several_frames && design.node(root).still;
    let (still, moving): (Vec<&Group>, Vec<&Group>) =
        groups.iter().partition(|group| group.members().iter().all(|&member| is_still(member)));
    let mut skews = HashMap::new();
    for group in moving {
        let members = group.members();
        let ahead = |Source { root, delay }: Source| {
            skews.get(&root).map(|&skew: &u64| skew + u64::from(delay))
        };
        let outside = members.iter().flat_map(|&m| flow.operands(design, m));
        let skew =
            outside.filter(|s| !members.contains(&s.root)).filter_map(ahead).min().unwrap_or(0);
        skews.extend(members.iter().map(|&m| (m, skew)));
    }
    let mut wanted = HashMap::new();
    for (&reader, &skew) in &skews {
        want(&mut wanted, flow.operands(design, reader), skew);
    }
    for root in still.iter().rev().flat_map(|group| group.members()) {
        let skew = wanted.get(root).copied().unwrap_or(0);
        want(&mut wanted, flow.operands(design, *root), skew);
        skews.insert(*root, skew);
    }
    skews
}

/// Notes how far ahead a reader that is so by `skew` wants its operands.
fn want(wanted: &mut HashMap<NodeId, u64>, operands: Vec<Source>, skew: u64) {
    for Source { root, delay } in operands {
        let ahead = wanted.entry(root).or_default();
        *ahead = skew.saturating_sub(delay.into()).max(*ahead);
    }
}
