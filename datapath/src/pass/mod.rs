//! From a graph to a design, a pass at a time.
//!
//! | pass | takes | gives |
//! |---|---|---|
//! | `fold` | an operator that is about to be added | the value that has its raw values already, if one has |
//! | [`bounds`](bounds()) | a graph | bounds on the errors of what it computes |
//! | [`schedule`] | a graph and a target | the clock in which each value is there |
//! | `registers` | a graph and its schedule | a design, with delays and clock enables of loops |
//! | `dead_code` | a design | the design without what nothing reads |
//! | [`extent`](extent()) | a graph | what the design is made of, which is not made |
//!
//! The pass that lowers operators to what a device has (multiplier blocks, pieces of long sums) goes
//! between `fold` and `schedule`.
pub mod bounds;
mod dead_code;
mod extent;
pub(crate) mod fold;
mod loops;
mod lower;
mod registers;
mod schedule;

use crate::design::Design;
use crate::graph::Graph;
use crate::target::Target;

pub use bounds::{Bounds, bounds};
pub use extent::extent;
pub use lower::lowered;
pub use schedule::{LoopTooLate, Schedule, schedule};

/// What a graph is put into clocks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pipelining<'a> {
    /// Any device: a register behind each multiplier, adder and multiplexer.
    EachOperator,
    /// A clock on a target whose delays are known, with the fewest register bits.
    ForClock {
        /// The target.
        target: &'a Target,
        /// The clock, in MHz.
        mhz: f64,
    },
}

/// The design that a graph becomes.
///
/// # Errors
/// [`LoopTooLate`] names a loop that reads a value which is there only after the loop's own clock.
pub fn compile(graph: &Graph, pipelining: &Pipelining) -> Result<Design, LoopTooLate> {
    let bounds = bounds(graph);
    let placed = |graph: &Graph| {
        let schedule = schedule(graph, pipelining)?;
        Ok(dead_code::without(registers::placed(graph, &schedule, &bounds)))
    };
    match pipelining {
        Pipelining::EachOperator => placed(graph),
        Pipelining::ForClock { target, mhz } => {
            let design = placed(&lowered(graph, target, *mhz))?;
            Ok(Design { primitives: target.primitives(), ..design })
        }
    }
}

/// The highest clock, in MHz, at which every operator and every loop of a graph meets the target's
/// delays; 1 GHz if nothing limits it.
pub fn highest_clock(graph: &Graph, target: &Target) -> f64 {
    let allows = |mhz: f64| {
        let graph = lowered(graph, target, mhz);
        schedule::longest(&graph, target, mhz).is_none_or(|path| path.delay <= 1000.0 / mhz)
    };
    let (mut low, mut high) = (1u32, 1000u32);
    while low < high {
        let middle = (low + high).div_ceil(2);
        if allows(f64::from(middle)) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    f64::from(low)
}

/// What keeps the clock of a graph from being higher than so many MHz.
#[derive(Clone, Debug, PartialEq)]
pub struct ClockLimit {
    /// Full name of the value at which the path begins.
    pub from: String,
    /// Full name of the value at which it ends; the same where a single operator limits the clock.
    pub to: String,
    /// Whether the path is part of a loop.
    pub in_loop: bool,
    /// Nanoseconds from register to register.
    pub delay: f64,
}

/// The path that does not meet a clock 1 MHz above `mhz`, whatever the schedule; none if there is
/// no such path.
pub fn clock_limit(graph: &Graph, target: &Target, mhz: f64) -> Option<ClockLimit> {
    let above = mhz + 1.0;
    let graph = lowered(graph, target, above);
    let path = schedule::longest(&graph, target, above)?;
    let name = |id| {
        let value = graph.value(id);
        format!("{}.{}", graph.path(value.scope).join("."), value.name)
    };
    let (from, to) = (name(path.from), name(path.to));
    let (in_loop, delay) = (path.in_loop, path.delay);
    (delay > 1000.0 / above).then_some(ClockLimit { from, to, in_loop, delay })
}
