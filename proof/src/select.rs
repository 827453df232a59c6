//! Which real values are asked about.
use std::collections::{BTreeSet, HashMap};

use specula_datapath::design::ScopeId;
use specula_datapath::graph::{Graph, RealId, Rule};

use super::fixed::assumption;
use super::{About, Fact};

/// The real values that leave a unit or enter one, that are narrowed, that a fact is stated of, or that
/// are parted into cases; and which of them the bounds of the design rest on.
///
/// Of the others, such as the remainders of a division digit by digit, nothing but the range is of use
/// to anyone.
pub fn asked(graph: &Graph) -> Vec<(RealId, bool)> {
    let outputs = graph.outputs.iter().map(|(_, id)| *id);
    let crossing = (0..graph.reals.len() as u32).map(RealId);
    let crossing = crossing.filter(|&id| crossed(graph, id).is_some());
    let used = reached(graph, outputs.clone().collect(), true);
    let all = reached(graph, outputs.chain(crossing).collect(), false);
    let used = named(graph, &used);
    named(graph, &all).into_iter().map(|id| (id, used.contains(&id))).collect()
}

/// Those that are asked about, each where it is computed.
fn named(graph: &Graph, reached: &BTreeSet<RealId>) -> BTreeSet<RealId> {
    let crossing = reached.iter().filter_map(|&id| crossed(graph, id));
    let outputs = graph.outputs.iter().map(|(_, id)| *id);
    let kept = reached.iter().copied().filter(|&id| is_asked(graph, id));
    let all: BTreeSet<RealId> = crossing.chain(outputs).chain(kept).collect();
    let mut named: BTreeSet<RealId> = all.iter().map(|&id| producer(graph, id)).collect();
    named.retain(|&id| !is_given(graph, id));
    named
}

/// Whether nothing is to be proven of it: it is an input of the design, or exact as a bit is.
fn is_given(graph: &Graph, id: RealId) -> bool {
    matches!(graph.real(id).rule, Rule::Input { .. } | Rule::Exact)
}

/// What is reached from some real values by what rules depend on. Behind a proof that stands for rules
/// it is what enters the unit, which the proof is about, if `proofs` are asked about; of the core
/// itself, what the rules would depend on.
fn reached(graph: &Graph, mut open: Vec<RealId>, proofs: bool) -> BTreeSet<RealId> {
    let entering = entering(graph);
    let mut reached = BTreeSet::new();
    while let Some(id) = open.pop() {
        if !reached.insert(id) {
            continue;
        }
        let rule = &graph.real(id).rule;
        if proofs && matches!(rule, Rule::Overridden { .. }) {
            let scope = graph.value(graph.real(id).value).scope;
            if graph.unit(scope).parent.is_some() {
                open.extend(entering.get(&scope).into_iter().flatten());
                continue;
            }
        }
        open.extend(rule.operands());
        for &vector in rule.vectors() {
            open.extend(graph.vectors[vector.0 as usize].components);
        }
    }
    reached
}

/// What enters each unit from the one around it.
fn entering(graph: &Graph) -> HashMap<ScopeId, Vec<RealId>> {
    let mut entering: HashMap<ScopeId, Vec<RealId>> = HashMap::new();
    for id in (0..graph.reals.len() as u32).map(RealId) {
        let scope = graph.value(graph.real(id).value).scope;
        let from = crossed(graph, id).map(|other| graph.value(graph.real(other).value).scope);
        if from.is_some_and(|from| graph.unit(scope).parent == Some(from)) {
            entering.entry(scope).or_default().push(id);
        }
    }
    entering
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
            (assumption(graph, real.value)?.fact.clone(), About::Range)
        }
        _ => return None,
    };
    Some(Fact { name, about })
}

/// What a loop's error rests on.
pub const LOOP: &str = "loop invariant";

/// What the error of a table's entries rests on.
pub const TABLE: &str = "table entries";
