//! Signs of products with constants: where the lowest signed digit of a constant is -1, the sum of
//! the shifted values is the negative of the product, and a sum that alone reads the product takes the
//! sign over, which saves an adder and its register:
//!
//! ```text
//! a + (-p) = a - p     (-p) + b = b - p     a - (-p) = a + p     (-p) - (-q) = q - p
//! ```
use std::collections::{HashMap, HashSet};

use super::constant::digits;
use crate::design::{NodeId, Op, Range};
use crate::graph::{Graph, Value};

/// The products of a graph whose negatives are computed in their place.
#[derive(Debug, Default)]
pub struct Negated(HashSet<NodeId>);

impl Negated {
    /// Those of a graph with these loops; what stands in a loop stays as it is.
    pub fn of(graph: &Graph, loops: &[Option<usize>]) -> Negated {
        let ids =
            (0..graph.values.len() as u32).map(NodeId).filter(|id| loops[id.0 as usize].is_none());
        let mut readers: HashMap<NodeId, u32> = HashMap::new();
        let operands = graph.values.iter().flat_map(|value| value.op.operands());
        operands.for_each(|id| *readers.entry(id).or_default() += 1);
        let grouped: HashSet<NodeId> = graph.groups.iter().flatten().copied().collect();
        let is_candidate = |id: NodeId| {
            loops[id.0 as usize].is_none()
                && !graph.value(id).named
                && readers.get(&id) == Some(&1)
                && !grouped.contains(&id)
                && factors(graph, graph.value(id))
                    .is_some_and(|(_, constant)| is_negative(constant))
        };
        let mut negated = HashSet::new();
        for id in ids {
            // Of two terms one at least stays positive.
            match graph.value(id).op {
                Op::Add(a, b) if a != b && is_candidate(b) => negated.insert(b),
                Op::Add(a, b) if a != b && is_candidate(a) => negated.insert(a),
                Op::Sub(a, b) if a != b && is_candidate(b) => {
                    if is_candidate(a) {
                        negated.insert(a);
                    }
                    negated.insert(b)
                }
                _ => false,
            };
        }
        Negated(negated)
    }

    /// The operator of a sum with the signs of its terms, other operators as they are.
    pub fn with_signs(&self, op: Op) -> Op {
        match op {
            Op::Add(a, b) if self.0.contains(&b) => Op::Sub(a, b),
            Op::Add(a, b) if self.0.contains(&a) => Op::Sub(b, a),
            Op::Sub(a, b) if self.0.contains(&a) => Op::Sub(b, a),
            Op::Sub(a, b) if self.0.contains(&b) => Op::Add(a, b),
            op => op,
        }
    }

    /// What is computed in the place of a product, if that is its negative.
    pub fn negative(&self, graph: &Graph, id: NodeId) -> Option<Negative> {
        let value = graph.value(id);
        let (variable, constant) = factors(graph, value).filter(|_| self.0.contains(&id))?;
        let Range { low, high } = value.range;
        Some(Negative { variable, constant: -constant, range: Range::new(-high, -low) })
    }
}

/// The negative of a product with a constant.
#[derive(Clone, Copy, Debug)]
pub struct Negative {
    /// The variable, a value of the old graph.
    pub variable: NodeId,
    /// The negative of the constant.
    pub constant: i64,
    /// Every raw value of the negative.
    pub range: Range,
}

/// The variable and the constant of a product.
fn factors(graph: &Graph, value: &Value) -> Option<(NodeId, i64)> {
    let Op::Mul(a, b) = value.op else { return None };
    let constant = |id: NodeId| graph.value(id).op.constant();
    match (constant(a), constant(b)) {
        (None, Some(constant)) => Some((a, constant)),
        (Some(constant), None) => Some((b, constant)),
        _ => None,
    }
}

/// Whether the sum of a constant's signed digits is computed as that of its negative.
fn is_negative(constant: i64) -> bool {
    digits(constant).first().is_some_and(|&(_, negative)| negative)
}
