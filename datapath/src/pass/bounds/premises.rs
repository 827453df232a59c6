//! What a bound rests on besides the rules.
use std::collections::BTreeSet;

use crate::graph::{Graph, RealId, VectorId};

/// The proofs and facts that the bound of a real value rests on, in the order of their names.
pub fn premises(graph: &Graph, of: RealId) -> Vec<&str> {
    let mut found = Found::default();
    found.scalar(graph, of);
    found.names.into_iter().collect()
}

#[derive(Default)]
struct Found<'a> {
    names: BTreeSet<&'a str>,
    scalars: BTreeSet<RealId>,
    vectors: BTreeSet<VectorId>,
}

impl<'a> Found<'a> {
    fn scalar(&mut self, graph: &'a Graph, of: RealId) {
        let mut open = vec![of];
        while let Some(id) = open.pop() {
            if self.scalars.insert(id) {
                let rule = &graph.reals[id.0 as usize].rule;
                self.names.extend(rule.premise());
                open.extend(rule.operands());
                for &vector in rule.vectors() {
                    self.vector(graph, vector, &mut open);
                }
            }
        }
    }

    fn vector(&mut self, graph: &'a Graph, of: VectorId, components: &mut Vec<RealId>) {
        let mut open = vec![of];
        while let Some(id) = open.pop() {
            if self.vectors.insert(id) {
                let vector = &graph.vectors[id.0 as usize];
                self.names.extend(vector.rule.premise());
                components.extend(vector.components);
                open.extend(vector.rule.operands());
            }
        }
    }
}
