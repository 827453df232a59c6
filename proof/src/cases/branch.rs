//! Branches of the fixed-point value: multiplexers, and what their bits say.
use specula_datapath::design::{NodeId, Op, ScopeId};
use specula_datapath::graph::Graph;

use crate::number;
use super::Writer;

/// The multiplexers on the way to a value, and which operand each takes.
pub type Path = Vec<(NodeId, bool)>;

/// The most multiplexers behind one another that are followed.
const DEEPEST: usize = 3;

/// Every way to a value through the multiplexers of its unit; one without any where there are none.
pub fn paths(graph: &Graph, id: NodeId) -> Vec<Path> {
    ways(graph, graph.value(id).scope, id, DEEPEST)
}

fn ways(graph: &Graph, scope: ScopeId, id: NodeId, deep: usize) -> Vec<Path> {
    let value = graph.value(id);
    if value.scope != scope || graph.is_state(value) || deep == 0 {
        return vec![vec![]];
    }
    match value.op {
        Op::Copy(a) | Op::Wrap(a) => ways(graph, scope, a, deep),
        Op::Select(_, yes, no) => {
            let taken = |bit: bool, of: NodeId| {
                let rest = ways(graph, scope, of, deep - 1).into_iter();
                rest.map(move |rest| [vec![(id, bit)], rest].concat())
            };
            taken(true, yes).chain(taken(false, no)).collect()
        }
        _ => vec![vec![]],
    }
}

impl Writer<'_> {
    /// The value on a way through multiplexers, with what their bits say as hypotheses. Whether it
    /// fits the bits that a clamp keeps is what the goal about its range says.
    pub fn along(&mut self, id: NodeId, path: &[(NodeId, bool)]) -> String {
        let graph = self.graph;
        let Some(((select, bit), rest)) = path.split_first() else { return self.fixed(id) };
        let (value, bits) = (graph.value(id), |id: NodeId| graph.value(id).fraction_bits);
        let (operand, rest) = match value.op {
            Op::Copy(a) | Op::Wrap(a) => (a, path),
            Op::Select(condition, yes, no) if id == *select => {
                self.say(condition, *bit);
                (if *bit { yes } else { no }, rest)
            }
            _ => return self.fixed(id),
        };
        let taken = self.along(operand, rest);
        self.moved(taken, i64::from(bits(operand)) - i64::from(bits(id)))
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
