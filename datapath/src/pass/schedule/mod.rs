//! The clock in which each value is there.
//!
//! Stages are counted from the clock in which a pixel enters. With s(v) the stage of value v, and
//! a(v) the stage at which its operands are taken,
//!
//! ```text
//! s(v) = a(v) + clocks(v)
//! a(v) >= s(operand)       of operators
//! a(v) >= s(member)        of values that are taken together with a group, for all of them alike
//! ```
//! Of operands and members those count that are not still: what is still is there at any time, waits
//! for nothing and moves no other value. Its own stage counts the registers from the inputs to it.
mod difference;
mod each_operator;
mod for_clock;
mod paths;

pub(crate) use for_clock::longest;

use crate::design::NodeId;
use crate::graph::{Graph, GroupId, Pace, Value};

use super::Pipelining;

/// The stages of a graph's values.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Schedule {
    /// The stage at which each value's operands are taken.
    taken: Vec<u32>,
    /// The stage at which each value is there.
    stages: Vec<u32>,
    /// Registers behind each value's operator, or in its block.
    registers: Vec<u32>,
    /// Which values are products in multiplier blocks.
    in_block: Vec<bool>,
    /// The stage of each group.
    groups: Vec<u32>,
    /// The stage at which the outputs leave together.
    last: u32,
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

    /// Registers behind a value's operator, or in its block.
    pub fn registers(&self, id: NodeId) -> u32 {
        self.registers[id.0 as usize]
    }

    /// Whether a value is a product in a multiplier block, which has its registers inside.
    pub fn in_block(&self, id: NodeId) -> bool {
        self.in_block[id.0 as usize]
    }

    /// The stage of a group, at which its members are taken.
    pub fn of_group(&self, group: GroupId) -> u32 {
        self.groups[group.0 as usize]
    }

    /// The stage at which a value takes its operands.
    pub fn operands_at(&self, id: NodeId) -> u32 {
        self.taken[id.0 as usize]
    }

    /// The stage at which the operands of a still value, which are still, have all settled.
    fn settled(&self, value: &Value) -> u32 {
        value.op.operands().map(|id| self.stage(id)).max().unwrap_or(0)
    }

    /// The stage at which the outputs leave together.
    pub fn last(&self) -> u32 {
        self.last
    }
}

/// Schedules a graph.
///
/// # Errors
/// [`LoopTooLate`] names the first loop whose next value is not there in the loop's own clock.
pub fn schedule(graph: &Graph, pipelining: &Pipelining) -> Result<Schedule, LoopTooLate> {
    let schedule = match pipelining {
        Pipelining::EachOperator => each_operator::schedule(graph),
        Pipelining::ForClock { target, mhz } => for_clock::schedule(graph, target, *mhz),
    };
    check_loops(graph, &schedule)?;
    Ok(schedule)
}

/// What goes round a loop has to be there in the clock in which the loop reads it.
fn check_loops(graph: &Graph, schedule: &Schedule) -> Result<(), LoopTooLate> {
    for (index, value) in graph.values.iter().enumerate() {
        if !matches!(value.pace, Pace::Feedback | Pace::Slots) {
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
