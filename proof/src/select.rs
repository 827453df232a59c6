//! Which real values are asked about.
use std::collections::BTreeSet;

use specula_datapath::design::Op;
use specula_datapath::graph::{Graph, RealId, Rule};

use super::{About, Fact};

/// The real values that leave a unit or enter one, that are narrowed, that a fact is stated of, or that
/// are parted into cases.
pub fn asked(graph: &Graph) -> Vec<RealId> {
    let reached = reached(graph);
    let crossing = reached.iter().filter_map(|&id| crossed(graph, id));
    let outputs = graph.outputs.iter().map(|(_, id)| *id);
    let kept = reached.iter().copied().filter(|&id| is_asked(graph, id));
    let all: BTreeSet<RealId> = crossing.chain(outputs).chain(kept).collect();
    let mut named: BTreeSet<RealId> = all.iter().map(|&id| producer(graph, id)).collect();
    named.retain(|&id| !is_given(graph, id));
    named.into_iter().collect()
}

/// Whether nothing is to be proven of it: it is an input of the design, or exact as a bit is.
fn is_given(graph: &Graph, id: RealId) -> bool {
    matches!(graph.real(id).rule, Rule::Input { .. } | Rule::Exact)
}

/// What is reached from what leaves the design and from what crosses a unit's border.
fn reached(graph: &Graph) -> BTreeSet<RealId> {
    let numbers = (0..graph.reals.len() as u32).map(RealId);
    let crossing = numbers.filter(|&id| crossed(graph, id).is_some());
    let mut open: Vec<RealId> =
        graph.outputs.iter().map(|(_, id)| *id).chain(crossing).collect();
    let mut reached = BTreeSet::new();
    while let Some(id) = open.pop() {
        if reached.insert(id) {
            let rule = &graph.real(id).rule;
            open.extend(rule.operands());
            for &vector in rule.vectors() {
                open.extend(graph.vectors[vector.0 as usize].components);
            }
        }
    }
    reached
}

/// The real value on the other side of a unit's border, if it is that one's copy here.
fn crossed(graph: &Graph, id: RealId) -> Option<RealId> {
    let real = graph.real(id);
    let Rule::Same(other) = real.rule else { return None };
    let scope = |id: RealId| graph.value(graph.real(id).value).scope;
    (scope(id) != scope(other)).then_some(other)
}

fn is_asked(graph: &Graph, id: RealId) -> bool {
    let real = graph.real(id);
    match real.rule {
        Rule::Exact | Rule::Input { .. } => false,
        Rule::Scaled(..) | Rule::Sum(..) | Rule::Difference(..) => false,
        Rule::Product(..) | Rule::Square(_) => false,
        Rule::Same(_) => fact(graph, id).is_some(),
        _ => true,
    }
}

/// The same real value where it is computed: ports, delays and more bits at the right are no other
/// one.
pub fn producer(graph: &Graph, id: RealId) -> RealId {
    let real = graph.real(id);
    match real.rule {
        Rule::Same(other) if fact(graph, id).is_none() => producer(graph, other),
        _ => id,
    }
}

/// The fact that is stated of this very value.
pub fn fact(graph: &Graph, id: RealId) -> Option<Fact> {
    let real = graph.real(id);
    let (name, about) = match &real.rule {
        Rule::Tightened { proof, .. } | Rule::Overridden { proof, .. } => {
            ((*proof).to_owned(), About::Error)
        }
        Rule::Within { fact, .. } => (fact.clone(), About::Real),
        Rule::LoopInvariant { .. } => (LOOP.to_owned(), About::Error),
        Rule::Table { .. } => (TABLE.to_owned(), About::Error),
        Rule::Same(other) if graph.real(*other).value != real.value => {
            (assumption(graph, id)?, About::Range)
        }
        _ => return None,
    };
    Some(Fact { name, about })
}

/// What a loop's error rests on.
pub const LOOP: &str = "loop invariant";

/// What the error of a table's entries rests on.
pub const TABLE: &str = "table entries";

fn assumption(graph: &Graph, id: RealId) -> Option<String> {
    let node = graph.real(id).value;
    if !matches!(graph.value(node).op, Op::Wrap(_)) {
        return None;
    }
    let stated = graph.assumptions.iter().find(|assumption| assumption.node == node)?;
    Some(stated.fact.clone())
}
