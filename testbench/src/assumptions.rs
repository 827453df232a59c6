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
            clock.checked_sub(node.stage.into()).is_some_and(|entry| stimulus.feeds(entry))
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

/// Clocks of pixels that went in for which a fact did not hold, of these clocks, in no order.
pub(crate) fn entries_that_violate(design: &Design, stimulus: &Stimulus, batch: &Batch) -> Vec<u64> {
    let of = |assumption: &specula_hdl::design::Assumption| {
        let stage = u64::from(design.node(assumption.node).stage);
        let range = assumption.range;
        batch.of(assumption.node).into_iter().flat_map(move |lanes| {
            let outside = move |&row: &usize| !range.contains(lanes.get(row));
            let entry = move |row: usize| (batch.first_clock() + row as u64).checked_sub(stage);
            (0..lanes.clocks()).filter(outside).filter_map(entry).filter(|&entry| stimulus.feeds(entry))
        })
    };
    design.assumptions.iter().flat_map(of).collect()
}
