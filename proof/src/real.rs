//! What the formula says, as expressions of real values.
use specula_datapath::graph::{RealId, Rule};

use super::fixed::constants_last;
use super::script::{Writer, interval, literal};
use super::{Detail, number};

/// 1 as a number of a script.
const ONE: &str = "1b0";

impl Writer<'_> {
    /// The real value.
    pub fn real(&mut self, id: RealId) -> String {
        if let Some(known) = self.reals.get(&id) {
            return known.clone();
        }
        let name = if id != self.goal && self.is_parted(id) {
            self.given(id)
        } else {
            self.by_rule(id)
        };
        self.reals.insert(id, name.clone());
        name
    }

    /// Whether the unit is parted here: what is stated of the value is a hypothesis.
    fn is_parted(&self, id: RealId) -> bool {
        let real = self.graph.real(id);
        let is_foreign = self.graph.value(real.value).scope != self.scope;
        match real.rule {
            Rule::Exact => false,
            Rule::Same(_) | Rule::Scaled(..) | Rule::Sum(..) | Rule::Difference(..) => is_foreign,
            Rule::Product(..) | Rule::Square(_) => is_foreign,
            Rule::Tightened { .. } | Rule::Within { .. } => is_foreign,
            Rule::Rounded(_) | Rule::Truncated(_) => {
                is_foreign || self.detail == Detail::Narrowings
            }
            _ => true,
        }
    }

    /// A real value of which that is known which is stated of it.
    pub fn given(&mut self, id: RealId) -> String {
        let graph = self.graph;
        let bound = self.bounds.of(id);
        let fixed = self.fixed_of(id);
        if bound.is_exact() {
            return fixed;
        }
        if let Some(fact) = super::select::fact(graph, id) {
            self.premises.insert(fact.name);
        }
        let name = self.name('R', &graph.value(graph.real(id).value).name);
        if bound.error.is_finite() {
            self.suppose(format!("|{fixed} - {name}| <= {}", number::of(bound.error)));
        }
        if bound.real.magnitude().is_finite() {
            self.suppose(format!("{name} in {}", interval(bound.real)));
        }
        name
    }

    fn by_rule(&mut self, id: RealId) -> String {
        let graph = self.graph;
        let real = graph.real(id);
        let expression = match &real.rule {
            Rule::Exact => self.fixed_of(id),
            Rule::Same(a) => {
                // What is known of the range of the value here.
                self.fixed_of(id);
                self.real(*a)
            }
            Rule::Rounded(a) | Rule::Truncated(a) => self.real(*a),
            Rule::Scaled(a, exponent) => {
                let of = self.real(*a);
                self.moved(of, i64::from(*exponent))
            }
            Rule::Sum(a, b) => self.binary('+', *a, *b),
            Rule::Difference(a, b) => self.binary('-', *a, *b),
            Rule::Product(a, b) => {
                let [a, b] = constants_last(graph, [*a, *b], |id| graph.real(id).value);
                self.binary('*', a, b)
            }
            Rule::Square(a) => self.binary('*', *a, *a),
            Rule::Tightened { of, bound, proof } => {
                let of = self.real(*of);
                if id != self.goal && bound.error.is_finite() {
                    let fixed = self.fixed_of(id);
                    self.suppose(format!("|{fixed} - {of}| <= {}", number::of(bound.error)));
                    self.premises.insert((*proof).to_owned());
                }
                of
            }
            Rule::Within { of, real, fact } => {
                let of = self.real(*of);
                if id != self.goal {
                    self.within(&of, *real);
                    self.premises.insert(fact.clone());
                }
                of
            }
            // The others part the unit, and are the question's own cases.
            _ => self.given(id),
        };
        self.define('R', &graph.value(real.value).name, expression)
    }

    /// An operator's expression. What is 0 or 1 exactly is left out, as it is where operators are folded.
    fn binary(&mut self, operator: char, a: RealId, b: RealId) -> String {
        let [a, b] = [a, b].map(|operand| self.real(operand));
        match (a.as_str(), operator, b.as_str()) {
            ("0", '+', _) | (ONE, '*', _) | (_, '*', "0") => b,
            (_, '+' | '-', "0") | (_, '*', ONE) | ("0", '*', _) => a,
            _ => format!("{a} {operator} {b}"),
        }
    }

    fn within(&mut self, name: &str, real: specula_datapath::bound::Interval) {
        if real.low.is_finite() {
            self.suppose(format!("{name} >= {}", number::of(real.low)));
        }
        if real.high.is_finite() {
            self.suppose(format!("{name} <= {}", number::of(real.high)));
        }
    }

    /// A number of the formula.
    pub fn number(&self, value: f64) -> String {
        literal(number::of(value))
    }
}
