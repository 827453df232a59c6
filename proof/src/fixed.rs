//! What the operators compute, as expressions.
use specula_datapath::design::{Assumption, NodeId, Op};
use specula_datapath::graph::{Graph, RealId};

use super::number;
use super::script::{Writer, literal};

/// Factors in the order in which both fixed-point and real products have them, since Gappa compares
/// them factor by factor: where operators are folded a constant comes last.
pub fn constants_last<T: Copy>(
    graph: &Graph,
    [a, b]: [T; 2],
    node: impl Fn(T) -> NodeId,
) -> [T; 2] {
    if graph.is_constant(node(a)) { [b, a] } else { [a, b] }
}

/// The fact by which a value has fewer bits than its operand.
pub fn assumption(graph: &Graph, id: NodeId) -> Option<&Assumption> {
    let value = graph.value(id);
    let Op::Wrap(of) = value.op else { return None };
    graph.assumptions.iter().find(|stated| stated.node == of && stated.range == value.range)
}

impl Writer<'_> {
    /// The fixed-point value that stands for a real one.
    pub fn fixed_of(&mut self, id: RealId) -> String {
        let real = self.graph.real(id);
        let value = self.fixed(real.value);
        let seen = i64::from(real.fraction_bits);
        self.moved(value, i64::from(self.graph.value(real.value).fraction_bits) - seen)
    }

    /// The value of a node: its raw value with the point where the node has it.
    pub fn fixed(&mut self, id: NodeId) -> String {
        if let Some(known) = self.fixed.get(&id) {
            return known.clone();
        }
        let graph = self.graph;
        let value = graph.value(id);
        let expression = match value.op.constant() {
            Some(raw) => Some(literal(number::scaled(raw, -i64::from(value.fraction_bits)))),
            None if self.is_inside(id) => self.operator(id),
            None => None,
        };
        let name = match expression {
            Some(expression) => self.define('F', &value.name, expression),
            None => self.variable(id),
        };
        self.fixed.insert(id, name.clone());
        self.state_fact(id, &name);
        name
    }

    /// Whether what computes it belongs to the unit.
    fn is_inside(&self, id: NodeId) -> bool {
        let value = self.graph.value(id);
        value.scope == self.scope && !self.graph.is_state(value)
    }

    /// A value that is known by its range alone.
    fn variable(&mut self, id: NodeId) -> String {
        let value = self.graph.value(id);
        let name = self.name('F', &value.name);
        let at = -i64::from(value.fraction_bits);
        let [low, high] = [value.range.low, value.range.high].map(|raw| number::scaled(raw, at));
        self.suppose(format!("{name} in [{low}, {high}]"));
        self.suppose(format!("@FIX({name}, {at})"));
        name
    }

    /// A fact about the range of a value is a hypothesis, but not where the question is about it.
    fn state_fact(&mut self, id: NodeId, name: &str) {
        let graph = self.graph;
        let value = graph.value(id);
        let goal = graph.real(self.goal);
        let is_goal = goal.value == id
            && super::select::fact(graph, self.goal)
                .is_some_and(|fact| fact.about == super::About::Range);
        if is_goal || !self.is_inside(id) {
            return;
        }
        if let Some(stated) = assumption(graph, id) {
            let at = -i64::from(value.fraction_bits);
            let [low, high] =
                [stated.range.low, stated.range.high].map(|raw| number::scaled(raw, at));
            self.suppose(format!("{name} in [{low}, {high}]"));
            self.premises.insert(stated.fact.clone());
        }
    }

    /// An operator's expression; none where Gappa has no such operator.
    fn operator(&mut self, id: NodeId) -> Option<String> {
        let graph = self.graph;
        let value = graph.value(id);
        match value.op {
            Op::Copy(a) => Some(self.with_point(a, id, 0)),
            Op::Add(a, b) => {
                let [a, b] = [a, b].map(|operand| self.with_point(operand, id, 0));
                Some(format!("{a} + {b}"))
            }
            Op::Sub(a, b) => {
                let [a, b] = [a, b].map(|operand| self.with_point(operand, id, 0));
                Some(format!("{a} - {b}"))
            }
            Op::Mul(a, b) => {
                let [x, y] = constants_last(graph, [a, b], |id| id).map(|of| self.fixed(of));
                let bits = |id: NodeId| i64::from(graph.value(id).fraction_bits);
                Some(self.moved(format!("{x} * {y}"), bits(a) + bits(b) - bits(id)))
            }
            Op::ShiftLeft(a, bits) => Some(self.with_point(a, id, i64::from(bits))),
            Op::ShiftRight(a, bits) => {
                if self.detail == super::Detail::Narrowings && !self.is_goal(id) {
                    return None;
                }
                let (of, dropped, way) = match self.nearest(id) {
                    Some((of, dropped)) => (of, dropped, "nu"),
                    None => (a, bits, "dn"),
                };
                let whole = self.with_point(of, id, -i64::from(dropped));
                Some(format!("fixed<-{},{way}>({whole})", value.fraction_bits))
            }
            Op::Wrap(a) => {
                let (inner, outer) = (graph.value(a).range, value.range);
                let is_kept = outer.hull(inner) == outer || assumption(graph, id).is_some();
                is_kept.then(|| self.with_point(a, id, 0))
            }
            Op::Or(high, low) => {
                let of = |id| (graph.value(id).op, graph.value(id).range);
                value.op.is_join(of).then(|| {
                    let [high, low] = [high, low].map(|operand| self.with_point(operand, id, 0));
                    format!("{high} + {low}")
                })
            }
            _ => None,
        }
    }

    fn is_goal(&self, id: NodeId) -> bool {
        self.graph.real(self.goal).value == id
    }

    /// What `floor((floor(x / 2^(d-1)) + 1) / 2)` rounds to nearest, ties up, and d: it is
    /// `floor(x / 2^d + 1/2)`, since floor(y/2) = floor(floor(y)/2).
    fn nearest(&self, id: NodeId) -> Option<(NodeId, u32)> {
        let op = |id: NodeId| self.graph.value(id).op;
        let Op::ShiftRight(sum, 1) = op(id) else { return None };
        let Op::Add(kept, one) = op(sum) else { return None };
        if op(one).constant() != Some(1) {
            return None;
        }
        let (point, of_sum) = (self.graph.value(kept), self.graph.value(sum));
        let is_inside = self.is_inside(sum) && self.is_inside(kept);
        match point.op {
            Op::ShiftRight(x, dropped) if is_inside => Some((x, dropped + 1)),
            _ if point.range.plus(specula_datapath::design::Range::single(1))
                == of_sum.range.into() =>
            {
                Some((kept, 1))
            }
            _ => None,
        }
    }

    /// The raw value of `operand` times 2^`shift`, as a value with the point where `of` has it.
    pub fn with_point(&mut self, operand: NodeId, of: NodeId, shift: i64) -> String {
        let bits = |id: NodeId| i64::from(self.graph.value(id).fraction_bits);
        let moves = bits(operand) - bits(of) + shift;
        let value = self.fixed(operand);
        self.moved(value, moves)
    }

    /// An expression times a power of two.
    pub fn moved(&self, expression: String, by: i64) -> String {
        match by {
            0 => expression,
            _ => format!("({expression}) * 1b{by}"),
        }
    }
}
