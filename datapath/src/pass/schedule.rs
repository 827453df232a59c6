//! The clock in which each value is there: as soon as its operands are, with the registers that the
//! target wants behind each operator.
//!
//! Stages are counted from the clock in which a pixel enters. With s(v) the stage of value v,
//!
//! ```text
//! s(v) = a(v) + clocks(v)
//! a(v) = max s(operand)        of operators
//! a(v) = max s(member)         of values that are taken together with a group
//! ```
//! Of operands and members those count that are not still: what is still is there at any time, waits
//! for nothing and moves no other value. Its own stage counts the registers from the inputs to it.
use crate::design::NodeId;
use crate::graph::{Graph, GroupId, Pace, Value};
use crate::target::Target;

/// The stages of a graph's values.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// The stage at which each value is there.
    stages: Vec<u32>,
    /// Registers behind each value's operator.
    registers: Vec<u32>,
}

/// A loop that cannot run in one clock.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the loop through `{signal}` reads a value that is there {clocks} clocks after its own")]
pub struct LoopTooLate {
    /// Full name of the register that closes the loop.
    pub signal: String,
    /// Clocks by which what it reads is late.
    pub clocks: u32,
}

impl Schedule {
    /// The stage at which a value is there.
    pub fn stage(&self, id: NodeId) -> u32 {
        self.stages[id.0 as usize]
    }

    /// Registers behind a value's operator.
    pub fn registers(&self, id: NodeId) -> u32 {
        self.registers[id.0 as usize]
    }

    /// The stage of a group: that of its latest member; what is still is there at any time.
    pub fn of_group(&self, graph: &Graph, group: GroupId) -> u32 {
        let moving = graph.group(group).iter().filter(|&&id| !graph.is_still(id));
        moving.map(|&id| self.stage(id)).max().unwrap_or(0)
    }

    /// The stage at which a value takes its operands.
    pub fn operands_at(&self, graph: &Graph, value: &Value) -> u32 {
        match value.together {
            Some(group) if !value.still => self.of_group(graph, group),
            _ => {
                let counts = |id: &NodeId| value.still || !graph.is_still(*id);
                let counting = value.op.operands().filter(counts);
                counting.map(|id| self.stage(id)).max().unwrap_or(0)
            }
        }
    }
}

/// Schedules each value as soon as its operands are there.
///
/// # Errors
/// [`LoopTooLate`] names the first loop whose next value is not there in the loop's own clock.
pub fn schedule(graph: &Graph, target: &dyn Target) -> Result<Schedule, LoopTooLate> {
    let mut schedule = Schedule { stages: vec![], registers: vec![] };
    for value in &graph.values {
        let taken = schedule.operands_at(graph, value);
        let (clocks, registers) = match value.pace {
            Pace::Target => {
                let registers = target.registers_after(&value.op);
                (registers, registers)
            }
            Pace::Wire | Pace::Meet => (0, 0),
            Pace::Register | Pace::Held => (1, 1),
            Pace::Feedback => (0, 1),
            Pace::Ahead => (1, 0),
        };
        schedule.stages.push(taken + clocks);
        schedule.registers.push(registers);
    }
    check_loops(graph, &schedule)?;
    Ok(schedule)
}

/// What goes round a loop has to be there in the clock in which the loop reads it.
fn check_loops(graph: &Graph, schedule: &Schedule) -> Result<(), LoopTooLate> {
    for (index, value) in graph.values.iter().enumerate() {
        if value.pace != Pace::Feedback {
            continue;
        }
        let own = schedule.stage(NodeId(index as u32));
        let moving = value.op.operands().filter(|&id| !graph.is_still(id));
        let late = moving.map(|id| schedule.stage(id).saturating_sub(own)).max();
        if let Some(clocks) = late.filter(|&clocks| clocks > 0) {
            let path = graph.path(value.scope).join(".");
            return Err(LoopTooLate { signal: format!("{path}.{}", value.name), clocks });
        }
    }
    Ok(())
}
