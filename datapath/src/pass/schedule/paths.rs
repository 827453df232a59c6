//! Paths between registers: which values cannot be computed of each other within one clock.
use crate::design::{NodeId, Op};
use crate::graph::{Graph, Pace, Value};
use crate::target::{Fabric, Shape, Target};

/// A path through operators that takes longer than a clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TooLong {
    /// The value that the path begins at: a register, or an operator that reads registers.
    pub from: NodeId,
    /// The value whose operator or register is the first that the path does not reach in time.
    pub to: NodeId,
    /// Clocks that the path takes already where no register is on it, in stages.
    pub clocks: u32,
    /// Nanoseconds.
    pub delay: f64,
}

/// What the way through a value is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// Through logic without registers, in so many nanoseconds.
    Through(f64),
    /// Into a register in so many nanoseconds, and out of it later.
    Into(f64),
}

/// Delays of a graph's values.
pub struct Paths<'a> {
    graph: &'a Graph,
    target: &'a Target,
    fabric: &'a Fabric,
    period: f64,
    readers: Vec<Vec<NodeId>>,
}

impl<'a> Paths<'a> {
    /// Those of a graph at a clock of `period`.
    pub fn new(graph: &'a Graph, target: &'a Target, fabric: &'a Fabric, period: f64) -> Paths<'a> {
        let mut readers = vec![vec![]; graph.values.len()];
        for (index, value) in graph.values.iter().enumerate() {
            for operand in value.op.operands() {
                readers[operand.0 as usize].push(NodeId(index as u32));
            }
        }
        Paths { graph, target, fabric, period, readers }
    }

    /// The values that read a value.
    pub fn readers(&self, id: NodeId) -> &[NodeId] {
        &self.readers[id.0 as usize]
    }

    /// Whether a value is a product in a block of the target.
    pub fn in_block(&self, value: &Value) -> bool {
        matches!(value.op, Op::Mul(..)) && self.target.multiplier.is_some()
    }

    /// Registers in the block that computes a product; none in a loop.
    pub fn block_registers(&self, value: &Value) -> u32 {
        match value.pace {
            Pace::Target if self.in_block(value) => {
                self.target.block_pipeline(self.period).map_or(0, |pipeline| pipeline.clocks)
            }
            _ => 0,
        }
    }

    /// Every pair of values that need a register between them, with the shortest such paths only, the
    /// longest of those that lead from one to the other. A path goes on where none can be, since
    /// both are `tied` to the one clock of a loop.
    pub fn too_long(&self, tied: &dyn Fn(NodeId, NodeId) -> bool) -> Vec<TooLong> {
        let mut found = vec![];
        let mut arrival: Vec<Option<(f64, u32)>> = vec![None; self.graph.values.len()];
        for index in 0..self.graph.values.len() {
            let from = NodeId(index as u32);
            // What is still begins no path but its own, of one operator.
            if !self.graph.is_still(from) {
                self.paths_from(from, tied, &mut arrival, &mut found);
            }
        }
        found
    }

    /// The slowest operator, with the nanoseconds from register to register through it; none if
    /// all values are constants.
    pub fn longest_operator(&self) -> Option<(NodeId, f64)> {
        let values = self.graph.values.iter().zip(0..).map(|(value, id)| (NodeId(id), value));
        let variable = values.filter(|(_, value)| value.op.constant().is_none());
        let through = variable.map(|(id, value)| {
            let into = match self.way(value) {
                Way::Through(_) => 0.0,
                Way::Into(delay) => self.fabric.register + delay,
            };
            (id, into.max(self.start(value)))
        });
        through.max_by(|(_, one), (_, other)| one.total_cmp(other))
    }

    /// Nanoseconds after the clock at which a value is there whose operands come from registers.
    fn start(&self, value: &Value) -> f64 {
        match self.way(value) {
            Way::Through(delay) => self.fabric.register + delay,
            Way::Into(_) => match self.block_registers(value) {
                0 => self.fabric.register,
                _ => self.target.block_pipeline(self.period).map_or(0.0, |block| block.out),
            },
        }
    }

    /// The way through a value.
    fn way(&self, value: &Value) -> Way {
        match value.pace {
            // What is added up goes to two registers, of which one is not beside the adder.
            Pace::Cleared => return Way::Into(self.fabric.net),
            Pace::Feedback | Pace::Held | Pace::Slots | Pace::After | Pace::Waiting => {
                return Way::Into(0.0);
            }
            Pace::Gate => return Way::Through(0.0),
            _ => {}
        }
        let width = |id: NodeId| match self.graph.value(id).op {
            Op::Constant(0) => 0,
            _ => self.graph.value(id).range.width(),
        };
        let operation = |id: NodeId| (self.graph.value(id).op, self.graph.value(id).range);
        if value.op.is_join(operation) {
            return Way::Through(0.0);
        }
        let shape = Shape::of(&value.op, value.range.width(), width);
        let (Shape::Product, Some(block)) = (shape, self.target.block_pipeline(self.period)) else {
            return Way::Through(self.fabric.delay(shape));
        };
        match self.block_registers(value) {
            0 => Way::Through(self.fabric.net + block.into + block.out),
            _ => Way::Into(self.fabric.net + block.into),
        }
    }

    /// Follows the paths from one value to the first operator on each that is not reached in time.
    /// Operators come behind their operands, so each is seen when all paths to it are known.
    fn paths_from(
        &self,
        from: NodeId,
        tied: &dyn Fn(NodeId, NodeId) -> bool,
        arrival: &mut [Option<(f64, u32)>],
        found: &mut Vec<TooLong>,
    ) {
        let mut open = std::collections::BTreeSet::new();
        let mut seen = vec![from];
        arrival[from.0 as usize] = Some((self.start(self.graph.value(from)), 0));
        open.insert(from);
        while let Some(id) = open.pop_first() {
            let Some((at, clocks)) = arrival[id.0 as usize] else { continue };
            for &reader in self.readers(id) {
                let value = self.graph.value(reader);
                let (delay, ends) = match self.way(value) {
                    Way::Through(delay) => (at + delay, false),
                    Way::Into(delay) => (at + delay, true),
                };
                let too_long = delay > self.period;
                if too_long {
                    found.push(TooLong { from, to: reader, clocks, delay });
                }
                if !ends && (!too_long || tied(from, reader)) {
                    let stages = clocks + u32::from(value.pace == Pace::Ahead);
                    let slot = &mut arrival[reader.0 as usize];
                    let later = slot.is_none_or(|(before, _)| before < delay);
                    if slot.is_none() {
                        seen.push(reader);
                    }
                    if later {
                        *slot = Some((delay, stages));
                    }
                    open.insert(reader);
                }
            }
        }
        seen.into_iter().for_each(|id| arrival[id.0 as usize] = None);
    }
}
