//! Branches of the fixed-point value: multiplexers, and what their bits say.
use specula_datapath::design::{NodeId, Op};
use specula_datapath::graph::Graph;

use super::Writer;
use crate::number;

/// The multiplexer that a value comes from, if it does, and which operand it takes.
pub type Branch = Option<(NodeId, bool)>;

/// Both branches of a value that a multiplexer of its unit gives, and else the value as it is.
pub fn branches(graph: &Graph, id: NodeId) -> Vec<Branch> {
    match multiplexer(graph, id) {
        Some(select) => vec![Some((select, true)), Some((select, false))],
        None => vec![None],
    }
}

fn multiplexer(graph: &Graph, id: NodeId) -> Option<NodeId> {
    let value = graph.value(id);
    match value.op {
        _ if graph.is_state(value) => None,
        Op::Select(..) => Some(id),
        Op::Copy(a) | Op::Wrap(a) if graph.value(a).scope == value.scope => multiplexer(graph, a),
        _ => None,
    }
}

impl Writer<'_> {
    /// The value in a branch, with what the multiplexer's bit says as hypotheses. Whether it fits the
    /// bits that a clamp keeps is what the goal about its range says.
    pub fn in_branch(&mut self, id: NodeId, branch: Branch) -> String {
        let graph = self.graph;
        let Some((select, bit)) = branch else { return self.fixed(id) };
        let operand = match graph.value(id).op {
            Op::Select(condition, yes, no) if id == select => {
                self.say(condition, bit);
                let taken = if bit { yes } else { no };
                return self.with_point(taken, id, 0);
            }
            Op::Copy(a) | Op::Wrap(a) => a,
            _ => return self.fixed(id),
        };
        let taken = self.in_branch(operand, branch);
        let bits = |id: NodeId| i64::from(graph.value(id).fraction_bits);
        self.moved(taken, bits(operand) - bits(id))
    }

    /// What a bit says where it is known.
    fn say(&mut self, bit: NodeId, is_set: bool) {
        let graph = self.graph;
        let value = graph.value(bit);
        if value.scope != self.scope || graph.is_state(value) {
            return;
        }
        match (value.op, is_set) {
            (Op::Copy(a), _) => self.say(a, is_set),
            (Op::Not(a), _) => self.say(a, !is_set),
            (Op::And(a, b), true) | (Op::Or(a, b), false) => {
                self.say(a, is_set);
                self.say(b, is_set);
            }
            (Op::LessThan(a, b), _) => self.compare([a, b], is_set),
            _ => {}
        }
    }

    /// a < b, or a ≥ b: raw values with one point, so that the smaller one is a unit less at least.
    fn compare(&mut self, [a, b]: [NodeId; 2], is_less: bool) {
        let graph = self.graph;
        let at = -i64::from(graph.value(a).fraction_bits);
        let constant = |id: NodeId| graph.value(id).op.constant();
        let next = i64::from(is_less);
        let hypothesis = match (constant(a), constant(b)) {
            (None, Some(limit)) => {
                let (a, sign) = (self.fixed(a), if is_less { "<=" } else { ">=" });
                format!("{a} {sign} {}", number::scaled(limit - next, at))
            }
            (Some(limit), None) => {
                let at = -i64::from(graph.value(b).fraction_bits);
                let (b, sign) = (self.fixed(b), if is_less { ">=" } else { "<=" });
                format!("{b} {sign} {}", number::scaled(limit + next, at))
            }
            _ => {
                let (x, y) = (self.fixed(a), self.fixed(b));
                let y = self.moved(y, i64::from(graph.value(b).fraction_bits) + at);
                if is_less {
                    format!("{x} - {y} <= {}", number::scaled(-1, at))
                } else {
                    format!("{x} - {y} >= 0")
                }
            }
        };
        self.suppose(hypothesis);
    }
}
