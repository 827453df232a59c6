//! What the formula says, as expressions of real values.
use specula_datapath::graph::{RealId, Rule};

use super::fixed::constants_last;
use super::script::{Writer, interval, literal};
use super::{Detail, number, select};

/// 1 as a number of a script.
const ONE: &str = "1b0";

/// An operator's expression. What is 0 or 1 exactly is left out, as it is where operators are folded.
pub fn combined(operator: char, a: &str, b: &str) -> String {
    match (a, operator, b) {
        ("0", '+', _) | (ONE, '*', _) | (_, '*', "0") => b.to_owned(),
        (_, '+' | '-', "0") | (_, '*', ONE) | ("0", '*', _) => a.to_owned(),
        _ => format!("{a} {operator} {b}"),
    }
}

impl Writer<'_> {
    /// The real value.
    pub fn real(&mut self, id: RealId) -> String {
        if let Some(known) = self.reals.get(&id) {
            return known.clone();
        }
        let name =
            if id != self.goal && self.is_parted(id) { self.given(id) } else { self.by_rule(id) };
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
        if let Some(fact) = select::fact(graph, id) {
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
            Rule::Product(a, b) => self.product([*a, *b]),
            Rule::Square(a) => self.product([*a, *a]),
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
        let name = self.define('R', &graph.value(real.value).name, expression);
        self.say_folded(id, &name);
        name
    }

    fn binary(&mut self, operator: char, a: RealId, b: RealId) -> String {
        let [a, b] = [a, b].map(|operand| self.real(operand));
        combined(operator, &a, &b)
    }

    /// A product; powers of two come last, as they do where points are moved.
    fn product(&mut self, factors: [RealId; 2]) -> String {
        let graph = self.graph;
        let ordered = constants_last(graph, factors, |id| graph.real(id).value);
        let [(a, m), (b, n)] = ordered.map(|id| self.unscaled(id));
        let product = self.binary('*', a, b);
        self.moved(product, m + n)
    }

    /// A real value of which this one is a multiple by a power of two, and the exponent.
    fn unscaled(&self, id: RealId) -> (RealId, i64) {
        match self.graph.real(id).rule {
            _ if self.is_parted(id) => (id, 0),
            Rule::Scaled(of, exponent) => {
                let (of, more) = self.unscaled(of);
                (of, more + i64::from(exponent))
            }
            Rule::Same(of) if select::fact(self.graph, id).is_none() => {
                // A port is a value of its own.
                let scope = |id: RealId| self.graph.value(self.graph.real(id).value).scope;
                if scope(of) == scope(id) { self.unscaled(of) } else { (id, 0) }
            }
            _ => (id, 0),
        }
    }

    /// Where an operator with a constant is folded, the fixed-point value has no such operator and the
    /// real one has: R = R_a + R_b, and F is F_a or F_b.
    fn say_folded(&mut self, id: RealId, real: &str) {
        let (Rule::Sum(a, b) | Rule::Difference(a, b) | Rule::Product(a, b)) =
            self.graph.real(id).rule
        else {
            return;
        };
        let fixed = self.fixed_of(id);
        let [f_a, f_b] = [a, b].map(|of| self.fixed_of(of));
        if fixed != f_a && fixed != f_b {
            return;
        }
        let [r_a, r_b] = [a, b].map(|of| self.real(of));
        let by_way = match (&self.graph.real(id).rule, fixed == f_b) {
            (Rule::Sum(..), true) => format!("({fixed} - {r_b}) - {r_a}"),
            (Rule::Sum(..), false) => format!("({fixed} - {r_a}) - {r_b}"),
            (Rule::Difference(..), false) => format!("({fixed} - {r_a}) + {r_b}"),
            (Rule::Product(..), true) => format!("({fixed} - {r_b}) + (1b0 - {r_a}) * {r_b}"),
            (Rule::Product(..), false) => format!("({fixed} - {r_a}) + (1b0 - {r_b}) * {r_a}"),
            _ => return,
        };
        let whole = format!("{fixed} - {real}");
        if real != r_a && real != r_b && whole != by_way {
            self.hint(&whole, &by_way);
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
