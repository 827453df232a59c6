//! Bounds |fixed - real| of everything that a graph computes.
//!
//! What a value stands for and what is rounded on the way to it are [rules](crate::graph::Rule) of
//! the graph; here stands what they mean for the error, for what else is known of the error, and for
//! where the real value lies. A bound depends on rules and ranges alone, not on the order in which
//! they were described.
//!
//! As [`fold`](super) does, the pass runs while a graph is described, so that units can ask what is
//! known of their inputs, and again over the finished graph, which is where the bounds of a design
//! come from.
mod premises;
mod rule;
mod vector;

use crate::bound::{Bound, VectorBound};
use crate::graph::{Graph, RealId, RealValue, RealVector, VectorId};

pub use premises::premises;

use vector::VectorFacts;

/// What is known of real values and vectors, each by its number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bounds {
    scalars: Vec<Bound>,
    vectors: Vec<Option<VectorFacts>>,
}

/// The bounds of all that a graph computes.
pub fn bounds(graph: &Graph) -> Bounds {
    let mut bounds = Bounds { scalars: Vec::with_capacity(graph.reals.len()), vectors: Vec::new() };
    bounds.vectors.resize(graph.vectors.len(), None);
    for real in &graph.reals {
        for &vector in real.rule.vectors() {
            bounds.work_out(graph, vector);
        }
        bounds.add(graph, real);
    }
    for index in 0..graph.vectors.len() as u32 {
        bounds.work_out(graph, VectorId(index));
    }
    bounds
}

impl Bounds {
    /// What is known of a real value and of the value that stands for it.
    pub fn of(&self, id: RealId) -> Bound {
        self.scalars[id.0 as usize]
    }

    /// The largest error of an output that the design's error is about.
    pub fn of_outputs(&self, graph: &Graph) -> f64 {
        graph.measured().map(|id| self.of(id).error).fold(0.0, f64::max)
    }

    /// What is known of a vector.
    pub fn of_vector(&self, graph: &Graph, id: VectorId) -> VectorBound {
        let facts = self.vectors[id.0 as usize].unwrap_or(VectorFacts::UNKNOWN);
        facts.with_components(self.components(&graph.vectors[id.0 as usize]))
    }

    /// Works out what is known of the real value that comes next.
    pub(crate) fn add(&mut self, graph: &Graph, real: &RealValue) {
        let bound = rule::bound(graph, self, real);
        self.scalars.push(bound);
    }

    /// Works out what is known of the vector that comes next.
    pub(crate) fn add_vector(&mut self, graph: &Graph, vector: &RealVector) {
        let facts = vector::facts(graph, self, vector);
        self.vectors.push(Some(facts));
    }

    /// What is known of a vector, once what it depends on is: its chain of vectors is as long as
    /// what units say of it.
    fn work_out(&mut self, graph: &Graph, id: VectorId) {
        if self.vectors[id.0 as usize].is_none() {
            let vector = &graph.vectors[id.0 as usize];
            for operand in vector.rule.operands() {
                self.work_out(graph, operand);
            }
            self.vectors[id.0 as usize] = Some(vector::facts(graph, self, vector));
        }
    }

    fn components(&self, vector: &RealVector) -> [Bound; 3] {
        vector.components.map(|component| self.of(component))
    }
}
