//! Makes a schedule real: each operator with its register, and delays, so that what belongs to the
//! same pixel is there in the same clock. All readers of a value share one line of delays.
//!
//! What a register keeps from pixel to pixel it changes with a valid pixel only: it has the pixel's
//! validity at its own stage as its clock enable (decision 0021).
mod multiplier;
mod validity;

use std::collections::HashMap;

use rustc_hash::FxHashSet;

use crate::design::{
    Design, MultiplierBlock, Node, NodeId, Op, Primitives, Register, Scope, ScopeId,
};
use crate::graph::{Graph, Pace, Value};
use crate::names::{CONTROL, unique};

use super::{Bounds, Schedule};

/// A graph with its registers. Signals stand in the order of the graph's values, each delay before
/// its first reader.
pub fn placed(graph: &Graph, schedule: &Schedule, bounds: &Bounds) -> Design {
    let mut placing = Placing::new(graph, schedule);
    for (index, value) in graph.values.iter().enumerate() {
        placing.place(NodeId(index as u32), value);
    }
    placing.close_loops();
    placing.finish(bounds)
}

struct Placing<'a> {
    graph: &'a Graph,
    schedule: &'a Schedule,
    nodes: Vec<Node>,
    /// The signal that has a value at the value's own stage; none of values that are still to come.
    signals: Vec<Option<NodeId>>,
    /// The delay register behind a signal, in its unit.
    delays: HashMap<NodeId, NodeId>,
    names: FxHashSet<(ScopeId, String)>,
    multipliers: Vec<MultiplierBlock>,
    /// Signals that give the value of an input of their unit as an output, by that input.
    passed_through: HashMap<NodeId, NodeId>,
    /// The register of validity behind a bit of validity.
    valid_later: HashMap<NodeId, NodeId>,
    /// The port by which a unit sees whether a pixel is at a stage.
    valid_ports: HashMap<(ScopeId, u32), NodeId>,
}

impl<'a> Placing<'a> {
    fn new(graph: &'a Graph, schedule: &'a Schedule) -> Placing<'a> {
        let of_values = graph.values.iter().map(|value| (value.scope, value.name.clone()));
        let instances =
            graph.units.iter().filter_map(|unit| Some((unit.parent?, unit.instance.clone())));
        let scopes = (0..graph.units.len() as u32).map(ScopeId);
        let control = scopes.flat_map(|scope| CONTROL.map(|name| (scope, name.to_owned())));
        let own = (ScopeId::TOP, graph.unit(ScopeId::TOP).instance.clone());
        Placing {
            graph,
            schedule,
            nodes: vec![],
            signals: vec![None; graph.values.len()],
            delays: HashMap::new(),
            multipliers: vec![],
            names: of_values.chain(instances).chain(control).chain([own]).collect(),
            passed_through: HashMap::new(),
            valid_later: HashMap::new(),
            valid_ports: HashMap::new(),
        }
    }

    /// Places a value with the delays that its operands need.
    fn place(&mut self, id: NodeId, value: &Value) {
        let taken = self.schedule.operands_at(id);
        if let (Op::Copy(operand), Pace::Meet) = (value.op, value.pace) {
            self.signals[id.0 as usize] = Some(self.aligned(self.signal(operand), taken));
            return;
        }
        let mut value = value.clone();
        if !matches!(value.pace, Pace::Feedback | Pace::Cleared | Pace::Slots) {
            let leaves = self.graph.left_unit(&value).is_some();
            let op = value.op.map(|operand| match self.signals[operand.0 as usize] {
                Some(signal) if leaves => {
                    self.output_of_unit(signal, taken, &mut value.name, value.named)
                }
                Some(signal) => self.aligned(signal, taken),
                // A register that holds its own value.
                None => operand,
            });
            value.op = op;
        }
        let node = self.operator(id, &value, taken);
        let signal = match value.op {
            Op::Mul(a, b) if self.schedule.in_block(id) => {
                self.multiplied(node, [a, b], self.schedule.registers(id))
            }
            _ => self.push(node),
        };
        self.signals[id.0 as usize] = Some(self.delayed(signal, self.schedule.stage(id)));
    }

    /// The signal of a value with the register behind its operator; that of a product in a block is
    /// at the stage of its factors.
    fn operator(&self, id: NodeId, value: &Value, taken: u32) -> Node {
        let registers = self.schedule.registers(id);
        let stage = if self.schedule.in_block(id) {
            taken
        } else {
            self.schedule.stage(id) - registers.saturating_sub(1)
        };
        Node {
            op: value.op,
            register: if registers > 0 { Register::Data } else { Register::None },
            range: value.range,
            fraction_bits: value.fraction_bits,
            still: value.still,
            stage,
            scope: value.scope,
            name: value.name.clone(),
            named: value.named,
        }
    }

    /// A signal of a unit as it leaves the unit: it is not itself an input, and if it is delayed on
    /// its way, the last delay is called after it. `outer` is the name outside, which follows unless
    /// it was given.
    fn output_of_unit(
        &mut self,
        signal: NodeId,
        exit: u32,
        outer: &mut String,
        given: bool,
    ) -> NodeId {
        let last = self.aligned(signal, exit);
        let node = self.node(last).clone();
        if node.op.constant().is_some() {
            return last;
        }
        let inner = self.node(signal).name.clone();
        let output = if last != signal {
            if !node.named {
                let name = self.unique(node.scope, &format!("{inner}_out"));
                let delayed = &mut self.nodes[last.0 as usize];
                (delayed.name, delayed.named) = (name, true);
            }
            last
        } else if self.is_input_of_unit(last) {
            self.passed_on(last)
        } else {
            return last;
        };
        let unit = self.graph.unit(node.scope);
        if !given && *outer == format!("{}_{inner}", unit.instance) {
            let name = format!("{}_{}", unit.instance, self.node(output).name);
            *outer = self.unique(unit.parent.unwrap_or(ScopeId::TOP), &name);
        }
        output
    }

    /// A copy of an input of a unit, for an output.
    fn passed_on(&mut self, input: NodeId) -> NodeId {
        if let Some(&copy) = self.passed_through.get(&input) {
            return copy;
        }
        let node = self.node(input).clone();
        let name = self.unique(node.scope, &format!("{}_out", node.name));
        let copy = self.push(Node { op: Op::Copy(input), name, named: true, ..node });
        self.passed_through.insert(input, copy);
        copy
    }

    fn is_input_of_unit(&self, id: NodeId) -> bool {
        let node = self.node(id);
        let Op::Copy(from) = node.op else { return false };
        let outside = self.graph.unit(node.scope).parent;
        !node.registered() && outside == Some(self.node(from).scope)
    }

    /// The signal as it is at a later `stage`: what is still is the same at any.
    fn aligned(&mut self, signal: NodeId, stage: u32) -> NodeId {
        if self.node(signal).still { signal } else { self.delayed(signal, stage) }
    }

    /// The signal behind registers that delay it to `stage`.
    fn delayed(&mut self, signal: NodeId, stage: u32) -> NodeId {
        let mut at = signal;
        while self.node(at).stage < stage {
            at = match self.delays.get(&at) {
                Some(&delayed) => delayed,
                None => self.delay(at),
            };
        }
        at
    }

    fn delay(&mut self, id: NodeId) -> NodeId {
        let node = self.node(id).clone();
        let name = self.unique(node.scope, &delayed_name(&node.name));
        let (op, register, stage) = (Op::Copy(id), Register::Data, node.stage + 1);
        let delayed = self.push(Node { op, register, stage, name, named: false, ..node });
        self.delays.insert(id, delayed);
        delayed
    }

    /// Registers that keep a value read what was placed after them.
    fn close_loops(&mut self) {
        for (index, value) in self.graph.values.iter().enumerate() {
            let Some(own) = self.signals[index].filter(|_| self.graph.is_state(value)) else {
                continue;
            };
            let taken = self.schedule.operands_at(NodeId(index as u32));
            self.nodes[own.0 as usize].op = match value.op {
                Op::Select(first, zero, next) if value.pace == Pace::Cleared => {
                    let [zero, next] = [zero, next].map(|id| self.aligned(self.signal(id), taken));
                    let first = self.aligned(self.signal(first), taken - 1);
                    self.cleared_before(own, first, zero, next)
                }
                op => {
                    let op = op.map(|operand| self.aligned(self.signal(operand), taken));
                    let valid = match value.pace {
                        Pace::Slots => self.valid_at(self.signal(self.graph.valid), taken),
                        _ => self.valid_in(value.scope, taken),
                    };
                    self.with_valid_pixel(own, op, valid)
                }
            };
        }
    }

    fn finish(mut self, bounds: &Bounds) -> Design {
        let graph = self.graph;
        let leaving: Vec<(&str, NodeId)> = graph.leaving().collect();
        let last = self.schedule.last();
        let valid_out = self.valid_out(last);
        let outputs = leaving.into_iter().map(|(name, id)| self.output(id, last, name)).collect();
        let scopes = graph.units.iter().enumerate().map(|(index, unit)| {
            let (entry, exit) = match index {
                0 => (0, last),
                _ => [unit.inputs, unit.outputs].map(|group| self.schedule.of_group(group)).into(),
            };
            Scope {
                unit: unit.name.clone(),
                formula: unit.formula.clone(),
                instance: unit.instance.clone(),
                parent: unit.parent,
                entry,
                exit: exit.max(entry),
            }
        });
        let assumptions = graph.assumptions.iter().map(|assumption| {
            let node = self.signal(assumption.node);
            crate::design::Assumption { node, ..assumption.clone() }
        });
        Design {
            scopes: scopes.collect(),
            assumptions: assumptions.collect(),
            inputs: graph.inputs.iter().map(|input| input.map(|id| self.signal(id))).collect(),
            valid: self.signal(graph.valid),
            start: self.signal(graph.start),
            nodes: self.nodes,
            tables: graph.tables.clone(),
            interval: graph.interval,
            last_slot_only: graph.last_slot_only,
            valid_out,
            outputs,
            primitives: Primitives::default(),
            multipliers: self.multipliers,
            output_errors: graph.measured().map(|id| bounds.of(id).error).collect(),
            left_out: graph.left_out.clone(),
        }
    }

    /// A value that leaves the design as `name` at `stage`.
    fn output(&mut self, id: NodeId, stage: u32, name: &str) -> NodeId {
        let signal = self.aligned(self.signal(id), stage);
        let node = self.node(signal).clone();
        let name = self.unique(ScopeId::TOP, name);
        let (op, register, scope) = (Op::Copy(signal), Register::None, ScopeId::TOP);
        self.push(Node { op, register, scope, name, named: true, ..node })
    }

    /// `name`, or with a number behind it where the unit has it already.
    fn unique(&mut self, scope: ScopeId, name: &str) -> String {
        unique(&mut self.names, scope, name)
    }

    fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }

    /// The signal of a value that has been placed.
    fn signal(&self, id: NodeId) -> NodeId {
        self.signals[id.0 as usize].unwrap_or(id)
    }

    fn push(&mut self, node: Node) -> NodeId {
        self.nodes.push(node);
        NodeId(self.nodes.len() as u32 - 1)
    }
}

/// `n_x` becomes `n_x_d1`, and that `n_x_d2`.
fn delayed_name(name: &str) -> String {
    let counted =
        name.rsplit_once("_d").and_then(|(base, digits)| Some((base, digits.parse::<u32>().ok()?)));
    match counted {
        Some((base, clocks)) => format!("{base}_d{}", clocks + 1),
        None => format!("{name}_d1"),
    }
}
