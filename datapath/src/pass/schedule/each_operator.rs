//! Each value as soon as its operands are there, with one register behind each multiplier, adder
//! and multiplexer. Comparators and gates feed the multiplexer they belong to within the same
//! clock; shifts and ports are wires.
use super::Schedule;
use crate::design::{NodeId, Op};
use crate::graph::{Graph, Pace, Value};

/// The schedule.
pub fn schedule(graph: &Graph) -> Schedule {
    let mut schedule = Schedule::default();
    for value in &graph.values {
        let taken = operands_at(graph, value, &schedule);
        let (clocks, registers) = match value.pace {
            Pace::Target => {
                let registers = registers_after(&value.op);
                (registers, registers)
            }
            Pace::Wire | Pace::Gate | Pace::Meet => (0, 0),
            Pace::Register | Pace::Held => (1, 1),
            Pace::Feedback | Pace::Cleared | Pace::Slots | Pace::Waiting => (0, 1),
            Pace::Ahead | Pace::After => (1, 0),
        };
        schedule.taken.push(taken);
        schedule.stages.push(taken + clocks);
        schedule.registers.push(registers);
        schedule.in_block.push(false);
    }
    schedule.groups =
        graph.groups.iter().map(|members| latest(graph, members, &schedule)).collect();
    let leaving: Vec<NodeId> = graph.leaving().map(|(_, id)| id).collect();
    // Validity has a register of its own also where every output is still.
    let still = leaving.iter().any(|&id| graph.is_still(id));
    schedule.last = latest(graph, &leaving, &schedule).max(u32::from(still));
    schedule
}

fn operands_at(graph: &Graph, value: &Value, schedule: &Schedule) -> u32 {
    match value.together {
        _ if value.still => schedule.settled(value),
        Some(group) => latest(graph, graph.group(group), schedule),
        None => latest(graph, &value.op.operands().collect::<Vec<_>>(), schedule),
    }
}

/// The stage of the latest value; what is still is there at any time.
fn latest(graph: &Graph, values: &[NodeId], schedule: &Schedule) -> u32 {
    let moving = values.iter().filter(|&&id| !graph.is_still(id));
    moving.map(|&id| schedule.stage(id)).max().unwrap_or(0)
}

/// Registers behind an operator.
pub(super) fn registers_after(op: &Op) -> u32 {
    match op {
        Op::Add(..) | Op::Sub(..) | Op::Mul(..) | Op::Select(..) => 1,
        Op::Input
        | Op::Constant(_)
        | Op::Copy(_)
        | Op::ShiftLeft(..)
        | Op::ShiftRight(..)
        | Op::Wrap(_)
        | Op::LessThan(..)
        | Op::And(..)
        | Op::Or(..)
        | Op::LookUp(..)
        | Op::Not(_) => 0,
    }
}
