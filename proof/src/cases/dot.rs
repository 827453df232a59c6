//! Dot products, of which more is known than of a sum of three products.
use specula_datapath::graph::{Graph, RealId, Rule, VectorId, VectorRule};

use super::{Writer, Written};
use crate::fixed::constants_last;
use crate::number;
use crate::real::combined;

/// What intervals cannot see.
const CAUCHY_SCHWARZ: &str = "Cauchy and Schwarz, of vectors' errors as wholes";

impl Writer<'_> {
    /// As the sum of products that it is.
    pub fn sum_of_products(mut self, of: RealId) -> Written {
        let fixed = self.fixed_of(self.goal);
        let real = self.real(of);
        self.no_shorter(&real);
        let goals = [Some(self.error_goal(&fixed, &real)), self.real_goal(&real)];
        self.written(goals.into_iter().flatten().collect())
    }

    /// A squared length is no smaller than that of the shortest vector that there is by a fact.
    fn no_shorter(&mut self, real: &str) {
        let graph = self.graph;
        let Rule::DotProduct { vectors: [a, b], .. } = graph.real(self.goal).rule else { return };
        let shortest = self.bounds.of_vector(graph, a).shortest;
        if a == b && shortest > 0.0 {
            self.suppose(format!("{real} >= {}", number::of(shortest * shortest)));
            self.premises.insert(facts_of_length(graph, a).join(", "));
        }
    }

    /// As a product of vectors, whose errors are known as wholes:
    ///
    /// ```text
    /// a.b - a'.b' = u (|a| e_b + |b| e_a + e_a e_b),   |u| ≤ 1
    /// ```
    pub fn dot_product(mut self) -> Written {
        let graph = self.graph;
        let Rule::DotProduct { vectors, lengths, .. } = &graph.real(self.goal).rule else {
            return self.written(vec![]);
        };
        let fixed = self.fixed_of(self.goal);
        let [left, right] = vectors.map(|vector| graph.vectors[vector.0 as usize].components);
        let mut exact = "0".to_owned();
        for (&a, &b) in left.iter().zip(&right) {
            let factors = constants_last(graph, [a, b], |id| graph.real(id).value);
            let [a, b] = factors.map(|id| self.fixed_of(id));
            let product = self.define('F', "exact", combined('*', &a, &b));
            exact = self.define('F', "exact", combined('+', &exact, &product));
        }
        let error = |of: usize| self.bounds.of_vector(graph, vectors[of]).error.length;
        let [a, b, e_a, e_b] =
            [lengths[0], lengths[1], error(0), error(1)].map(|number| self.number(number));
        let whole = format!("share * ({a} * {e_b} + {b} * {e_a} + {e_a} * {e_b})");
        let whole = self.define('E', "whole", whole);
        self.suppose("share in [-1, 1]".to_owned());
        let real = self.define('R', "whole", format!("{exact} - {whole}"));
        self.hint(&format!("{fixed} - {real}"), &format!("({fixed} - {exact}) + {whole}"));
        self.premises.insert(CAUCHY_SCHWARZ.to_owned());
        let goal = self.error_goal(&fixed, &real);
        self.written(vec![goal])
    }
}

/// The facts by which a vector is no shorter than it is said to be.
fn facts_of_length(graph: &Graph, id: VectorId) -> Vec<String> {
    let vector = &graph.vectors[id.0 as usize];
    let below = || vector.rule.operands().into_iter().flat_map(|of| facts_of_length(graph, of));
    match &vector.rule {
        VectorRule::NoShorter { fact, .. } => vec![fact.clone()],
        _ => below().collect(),
    }
}
