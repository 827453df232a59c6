//! From a graph to a design, a pass at a time.
//!
//! | pass | takes | gives |
//! |---|---|---|
//! | `fold` | an operator that is about to be added | the value that has its raw values already, if one has |
//! | [`bounds`](bounds()) | a graph | bounds on the errors of what it computes |
//! | [`schedule`] | a graph and a target | the clock in which each value is there |
//! | `registers` | a graph and its schedule | a design, with delays and clock enables of loops |
//! | `dead_code` | a design | the design without what nothing reads |
//!
//! The pass that lowers operators to what a device has (multiplier blocks, pieces of long sums) goes
//! between `fold` and `schedule`.
pub mod bounds;
mod dead_code;
pub(crate) mod fold;
mod registers;
mod schedule;

use crate::design::Design;
use crate::graph::Graph;
use crate::target::Target;

pub use bounds::{Bounds, bounds};
pub use schedule::{LoopTooLate, Schedule, schedule};

/// The design that a graph becomes on a target.
///
/// # Errors
/// [`LoopTooLate`] names a loop that reads a value which is there only after the loop's own clock.
pub fn compile(graph: &Graph, target: &dyn Target) -> Result<Design, LoopTooLate> {
    let schedule = schedule(graph, target)?;
    let bounds = bounds(graph);
    Ok(dead_code::without(registers::placed(graph, &schedule, &bounds)))
}
