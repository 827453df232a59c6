//! Facts that intervals cannot see, checked on every clock.
use specula_hdl::Design;
use specula_hdl::design::NodeId;
use specula_sim::{Batch, Stimulus};

/// A fact that did not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// The fact, as the unit states it.
    pub fact: String,
    /// Full name of the signal.
    pub signal: String,
    /// The clock.
    pub clock: u64,
    /// The value it had.
    pub value: f64,
}

/// Signals that have to be watched.
pub(crate) fn watched(design: &Design) -> impl Iterator<Item = NodeId> + '_ {
    design.assumptions.iter().map(|a| a.node)
}

/// The first violation in these clocks, if there is one.
pub(crate) fn first_violation(design: &Design, stimulus: &Stimulus, batch: &Batch) -> Option<Violation> {
    design.assumptions.iter().find_map(|assumption| {
        let node = design.node(assumption.node);
        let lanes = batch.of(assumption.node)?;
        let belongs_to_a_pixel = |row: usize| {
            let clock = batch.first_clock() + row as u64;
            clock.checked_sub(node.stage.into()).is_some_and(|entry| stimulus.enters(entry))
        };
        let first = lanes.first_outside(assumption.range.low, assumption.range.high)?;
        let outside = |&row: &usize| !assumption.range.contains(lanes.get(row));
        let row = (first..lanes.clocks()).filter(outside).find(|&row| belongs_to_a_pixel(row))?;
        Some(Violation {
            fact: assumption.fact.clone(),
            signal: design.full_name(assumption.node),
            clock: batch.first_clock() + row as u64,
            value: node.format().value(lanes.get(row)),
        })
    })
}
