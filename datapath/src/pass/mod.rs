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
pub use lower::{Lowered, lowered};
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
            let design = placed(&lowered(graph, target, *mhz).graph)?;
            Ok(Design { primitives: target.primitives(), ..design })
        }
    }
}

/// The highest clock, in MHz, at which every operator and every loop of a graph meets the target's
/// delays and sums are not cut more often than its placement bears; 1 GHz if nothing limits it.
pub fn highest_clock(graph: &Graph, target: &Target) -> f64 {
    let (mut low, mut high) = (1u32, 1000u32);
    while low < high {
        let middle = (low + high).div_ceil(2);
        if limit_at(graph, target, f64::from(middle)).is_none() {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    f64::from(low)
}

/// What keeps the clock of a graph from being higher than so many MHz: what is in the way 1 MHz
/// above, whatever the schedule; none if nothing is.
pub fn clock_limit(graph: &Graph, target: &Target, mhz: f64) -> Option<ClockLimit> {
    limit_at(graph, target, mhz + 1.0)
}

/// What keeps the clock of a graph from being higher.
#[derive(Clone, Debug, PartialEq)]
pub enum ClockLimit {
    /// A path that no register cuts.
    Path {
        /// Full name of the value at which the path begins.
        from: String,
        /// Full name of the value at which it ends; the same where it is a single operator.
        to: String,
        /// Whether the path is part of a loop.
        in_loop: bool,
        /// Nanoseconds from register to register.
        delay: f64,
    },
    /// Sums in so many pieces that their carries are more than placement keeps short.
    Carries {
        /// Carries from a piece to the next one.
        needed: u32,
        /// How many of them placement keeps short.
        most: u32,
    },
}

/// What is in the way of a clock of so many MHz, if anything is.
fn limit_at(graph: &Graph, target: &Target, mhz: f64) -> Option<ClockLimit> {
    let Lowered { graph, carries: needed } = lowered(graph, target, mhz);
    let path = schedule::longest(&graph, target, mhz)?;
    if path.delay > 1000.0 / mhz {
        let name = |id| {
            let value = graph.value(id);
            format!("{}.{}", graph.path(value.scope).join("."), value.name)
        };
        let (from, to) = (name(path.from), name(path.to));
        return Some(ClockLimit::Path { from, to, in_loop: path.in_loop, delay: path.delay });
    }
    let most = target.fabric.as_ref()?.carries?;
    (needed > most).then_some(ClockLimit::Carries { needed, most })
}
