//! The clock that a target's delays predict for a design, and the path that limits it.
use crate::design::{Design, Node, NodeId, Op};
use crate::target::{Fabric, Shape, Target};

/// The paths of a design between registers.
#[derive(Clone, Debug, PartialEq)]
pub struct Timing {
    /// Nanoseconds from clock to clock: those of the slowest path.
    pub period: f64,
    /// The signals on the slowest path, from the register where it begins; the last is a register
    /// too, or leaves the design.
    pub path: Vec<NodeId>,
    /// Nanoseconds after the clock at which each signal is there; of a register, at which what it
    /// takes over is. 0 of constants, of inputs, and inside multiplier blocks.
    pub arrivals: Vec<f64>,
    /// The operand of each signal that comes last.
    last_operands: Vec<Option<NodeId>>,
}

impl Timing {
    /// The analysis of a design; none where no delays of the target are known.
    pub fn of(design: &Design, target: &Target) -> Option<Timing> {
        let fabric = target.fabric.as_ref()?;
        Some(Analysis::new(design, target, fabric).slowest())
    }

    /// Nanoseconds after the clock at which a signal is there; of a register, at which what it takes
    /// over is.
    pub fn arrival(&self, id: NodeId) -> f64 {
        self.arrivals[id.0 as usize]
    }

    /// The signals on the slowest path to a signal of the design, from the register or input where
    /// it begins.
    pub fn path_to(&self, design: &Design, end: NodeId) -> Vec<NodeId> {
        path(design, &self.last_operands, end)
    }

    /// The clock in MHz.
    pub fn mhz(&self) -> f64 {
        1000.0 / self.period
    }
}

/// When signals are there, in nanoseconds after the clock.
struct Analysis<'a> {
    design: &'a Design,
    target: &'a Target,
    fabric: &'a Fabric,
    /// What a multiplier block is of a signal, if it belongs to one.
    parts: Vec<Option<Part>>,
    /// Whether a signal is a choice that a sum makes itself.
    gates: Vec<bool>,
    arrivals: Vec<f64>,
    /// The operand that comes last.
    before: Vec<Option<NodeId>>,
}

/// What a signal is to the multiplier block that it belongs to.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    /// The register of a factor, of so many that the block has in a row.
    Taken(u32),
    /// A register between factors and product.
    Pipelined,
    /// The product, behind so many registers of the block.
    Product(u32),
}

impl<'a> Analysis<'a> {
    fn new(design: &'a Design, target: &'a Target, fabric: &'a Fabric) -> Analysis<'a> {
        let mut parts = vec![None; design.nodes.len()];
        for block in &design.multipliers {
            let mut part = |id: NodeId, part| parts[id.0 as usize] = Some(part);
            let taken = Part::Taken(block.registers);
            block.taken.into_iter().flatten().for_each(|id| part(id, taken));
            block.pipelined.into_iter().for_each(|id| part(id, Part::Pipelined));
            part(block.product, Part::Product(block.registers));
        }
        let count = design.nodes.len();
        let (arrivals, before) = (vec![0.0; count], vec![None; count]);
        let gates = gates(design);
        Analysis { design, target, fabric, parts, gates, arrivals, before }
    }

    fn slowest(mut self) -> Timing {
        // Registers first: what reads them may come before them.
        let starts: Vec<NodeId> =
            self.design.iter().filter(|(_, node)| starts_path(node)).map(|(id, _)| id).collect();
        for id in starts {
            self.arrivals[id.0 as usize] = self.clock_to_output(id);
        }
        let computed: Vec<NodeId> = self.computed(|node| !node.registered());
        for id in computed {
            let (arrival, last) = self.through(id, self.design.node(id));
            (self.arrivals[id.0 as usize], self.before[id.0 as usize]) = (arrival, last);
        }
        let mut slowest = (self.fabric.register, None);
        let mut arrivals = self.arrivals.clone();
        for &id in &self.design.outputs {
            if self.arrival(id) > slowest.0 {
                slowest = (self.arrival(id), Some(id));
            }
        }
        for id in self.computed(Node::registered) {
            let (arrival, last) = self.through(id, self.design.node(id));
            arrivals[id.0 as usize] = arrival;
            self.before[id.0 as usize] = last;
            if arrival > slowest.0 {
                slowest = (arrival, Some(id));
            }
        }
        let last_operands = self.before;
        let path = slowest.1.map(|end| path(self.design, &last_operands, end));
        Timing { period: slowest.0, path: path.unwrap_or_default(), arrivals, last_operands }
    }

    /// From the clock to what a register gives.
    fn clock_to_output(&self, id: NodeId) -> f64 {
        match self.parts[id.0 as usize] {
            Some(Part::Product(registers)) if registers > 0 => self.pipeline(registers).1,
            _ => self.fabric.register,
        }
    }

    /// Nanoseconds into a block with so many registers, and out of it.
    fn pipeline(&self, registers: u32) -> (f64, f64) {
        let pipelines = self.target.multiplier.iter().flat_map(|block| &block.pipeline);
        let matching = pipelines.rev().find(|pipeline| pipeline.clocks <= registers);
        matching.map_or((0.0, 0.0), |pipeline| (pipeline.into, pipeline.out))
    }

    /// When the operator's result is there, and the operand that comes last.
    fn through(&self, id: NodeId, node: &Node) -> (f64, Option<NodeId>) {
        let part = self.parts[id.0 as usize];
        if part == Some(Part::Pipelined) || matches!(part, Some(Part::Product(2..))) {
            return (0.0, None);
        }
        let enabled = node.clock_enable(id);
        let operands: Vec<NodeId> = match enabled {
            Some((enable, next)) => vec![enable, next],
            None => node.op.operands().collect(),
        };
        let last = operands
            .into_iter()
            .filter(|&operand| operand != id && self.design.node(operand).op.constant().is_none())
            .max_by(|a, b| self.arrival(*a).total_cmp(&self.arrival(*b)));
        let arrival = last.map_or(0.0, |last| self.arrival(last));
        let delay = match (part, enabled) {
            (Some(Part::Taken(registers)), _) => self.fabric.net + self.pipeline(registers).0,
            (_, Some(_)) => 0.0,
            // The register of an accumulator is not beside the adder: another has the sum too.
            _ if self.is_control(id, node) && node.registered() => self.fabric.net,
            _ if self.is_control(id, node) || self.gates[id.0 as usize] => 0.0,
            _ => self.operator(node),
        };
        (arrival + delay, last)
    }

    /// Whether a choice is made by a flip-flop's own pins: its synchronous reset, or the enable
    /// behind that.
    fn is_control(&self, id: NodeId, node: &Node) -> bool {
        let Op::Select(_, taken, kept) = node.op else { return false };
        let is_zero = self.design.node(taken).op == Op::Constant(0);
        let own = self.design.node(kept);
        let resets = |own: &Node| matches!(own.op, Op::Select(_, _, next) if next == id);
        node.registered() && is_zero || own.registered() && resets(own)
    }

    fn arrival(&self, id: NodeId) -> f64 {
        self.arrivals[id.0 as usize]
    }

    /// The signal that a delay, or a port, has the value of.
    fn undelayed(&self, id: NodeId) -> NodeId {
        std::iter::successors(Some(id), |&at| match self.design.node(at).op {
            Op::Copy(from) if from != at => Some(from),
            _ => None,
        })
        .last()
        .unwrap_or(id)
    }

    /// Nanoseconds through an operator in the fabric, or through a block without registers before
    /// the product.
    fn operator(&self, node: &Node) -> f64 {
        let operation = |id: NodeId| {
            let node = self.design.node(self.undelayed(id));
            (node.op, node.range)
        };
        if node.op.is_join(operation) {
            return 0.0;
        }
        let width = |id: NodeId| match self.design.node(id).op {
            Op::Constant(0) => 0,
            _ => self.design.node(id).width(),
        };
        match Shape::of(&node.op, node.width(), width) {
            Shape::Product => self.fabric.net + self.pipeline(0).0,
            shape => self.fabric.delay(shape),
        }
    }

    /// The signals that operators compute, of those that are asked for, in order.
    fn computed(&self, wanted: impl Fn(&Node) -> bool) -> Vec<NodeId> {
        let computed = |node: &Node| node.op.constant().is_none() && node.op != Op::Input;
        let all = self.design.iter().filter(|(_, node)| computed(node) && wanted(node));
        all.map(|(id, _)| id).collect()
    }
}

/// Which signals are choices that the sums which read them make themselves: what they choose
/// from is 0, and they are the first summand.
fn gates(design: &Design) -> Vec<bool> {
    let mut gates = vec![false; design.nodes.len()];
    if design.primitives.gated_sum.is_none() {
        return gates;
    }
    for (id, node) in design.iter().filter(|(_, node)| !node.registered()) {
        if let Op::Select(_, zero, kept) = node.op {
            let kept = design.node(kept);
            let same = (kept.width(), kept.range.signed()) == (node.width(), node.range.signed());
            gates[id.0 as usize] = same && design.node(zero).op == Op::Constant(0);
        }
    }
    for (_, node) in design.iter() {
        let first = match node.op {
            Op::Add(first, second) if !node.registered() && first != second => Some(first),
            _ => None,
        };
        let others = node.op.operands().filter(|&operand| Some(operand) != first);
        others.for_each(|operand| gates[operand.0 as usize] = false);
    }
    gates
}

/// The signals from where a path begins to its end, by the operand of each that comes last.
fn path(design: &Design, last_operands: &[Option<NodeId>], end: NodeId) -> Vec<NodeId> {
    let mut path = vec![end];
    let mut at = last_operands[end.0 as usize];
    while let Some(id) = at {
        path.push(id);
        at = last_operands[id.0 as usize].filter(|_| !starts_path(design.node(id)));
    }
    path.reverse();
    path
}

fn starts_path(node: &Node) -> bool {
    node.registered() || node.op == Op::Input
}
