//! What the design that a graph becomes is made of, without making it: a search through many graphs
//! asks for no more.
use crate::design::{Extent, Factors, NodeId, Op, Operand, Size};
use crate::graph::{Graph, Pace, Value};

use super::{LoopTooLate, Pipelining, Schedule, schedule};

/// What the design with a register behind each operator is made of: what
/// [`Design::extent`](crate::Design::extent) says of it.
///
/// # Errors
/// [`LoopTooLate`], as where the design is made.
pub fn extent(graph: &Graph) -> Result<Extent, LoopTooLate> {
    let schedule = schedule(graph, &Pipelining::EachOperator)?;
    let mut reads = Reads {
        graph,
        schedule: &schedule,
        latest: vec![None; graph.values.len()],
        valid: 0,
        open: vec![],
    };
    reads.follow();
    Ok(reads.counted())
}

/// Who reads values, and when.
struct Reads<'a> {
    graph: &'a Graph,
    schedule: &'a Schedule,
    /// The last stage at which each value is read; none of those that no output needs.
    latest: Vec<Option<u32>>,
    /// The last stage at which a loop reads validity.
    valid: u32,
    /// Values whose operands are still to be followed.
    open: Vec<NodeId>,
}

impl Reads<'_> {
    /// Finds what the outputs need, from them backwards.
    fn follow(&mut self) {
        let graph = self.graph;
        for (_, id) in graph.leaving() {
            self.read(id, self.schedule.last());
        }
        self.read(graph.leaves, 0);
        while let Some(id) = self.open.pop() {
            let value = graph.value(id);
            let taken = self.schedule.operands_at(id);
            match (value.op, value.pace) {
                (Op::Select(first, zero, next), Pace::Cleared) => {
                    self.valid = self.valid.max(taken);
                    self.read(first, taken.saturating_sub(1));
                    for operand in [zero, next] {
                        self.read(operand, taken);
                    }
                }
                (op, Pace::Feedback | Pace::Held | Pace::Slots) => {
                    self.valid = self.valid.max(taken);
                    // A choice is one between what comes and what is held.
                    let taken_over = if matches!(op, Op::Select(..)) { 2 } else { 1 };
                    for operand in op.operands().take(taken_over) {
                        self.read(operand, taken);
                    }
                }
                (op, _) => op.operands().for_each(|operand| self.read(operand, taken)),
            }
        }
    }

    /// Notes that a value is read at a stage.
    fn read(&mut self, id: NodeId, at: u32) {
        let id = met(self.graph, id);
        let stage = self.schedule.stage(id);
        let latest = &mut self.latest[id.0 as usize];
        if latest.is_none() {
            self.open.push(id);
        }
        let at = if self.graph.is_still(id) { stage } else { at.max(stage) };
        *latest = Some(latest.unwrap_or(at).max(at));
    }

    fn counted(&self) -> Extent {
        let mut extent = Extent { size: Size::default(), factors: vec![] };
        for (index, (value, latest)) in self.graph.values.iter().zip(&self.latest).enumerate() {
            let Some(latest) = latest else { continue };
            let id = NodeId(index as u32);
            self.count(value, &mut extent);
            let own = self.schedule.registers(id).min(1);
            let registers = own + latest - self.schedule.stage(id);
            extent.size.register_bits += u64::from(value.range.width() * registers);
        }
        extent.size.register_bits += u64::from(self.validity());
        extent
    }

    /// Counts the operator of a value.
    fn count(&self, value: &Value, extent: &mut Extent) {
        match value.pace {
            Pace::Feedback | Pace::Held | Pace::Slots => return,
            // One clears the register, and one lets it hold its value.
            Pace::Cleared => extent.size.multiplexers += 2,
            _ => extent.size.count(value.op, value.range.width(), &self.graph.tables, |id| {
                Operand { range: self.graph.value(id).range, constant: self.graph.is_constant(id) }
            }),
        }
        if let Op::Mul(a, b) = value.op
            && !self.graph.is_constant(a)
            && !self.graph.is_constant(b)
        {
            let factor = |id| (met(self.graph, id), self.graph.value(id).range);
            extent.factors.push(Factors::of([a, b].map(factor)));
        }
    }

    /// Registers of validity.
    fn validity(&self) -> u32 {
        let [valid, leaves] = [self.graph.steps, self.graph.leaves].map(|id| met(self.graph, id));
        let clocks = |id, to: u32| to.saturating_sub(self.schedule.stage(id));
        let last = self.schedule.last();
        if valid == leaves {
            clocks(valid, last.max(self.valid))
        } else {
            clocks(valid, self.valid) + clocks(leaves, last)
        }
    }
}

/// The value that is delayed where `id` is only taken together with others.
fn met(graph: &Graph, id: NodeId) -> NodeId {
    let mut at = id;
    while let Value { op: Op::Copy(from), pace: Pace::Meet, .. } = graph.value(at) {
        at = *from;
    }
    at
}
