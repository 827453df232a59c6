//! Facts that intervals cannot see, checked on every clock.
use specula_hdl::Design;
use specula_hdl::design::{NodeId, Range};
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
    let facts = design.assumptions.iter().map(|assumption| (assumption.node, assumption.range));
    facts.flat_map(|(node, range)| entries_outside(design, stimulus, batch, node, range)).collect()
}

/// Signals outside their proven ranges, and clocks of the pixels that went in to which that belongs, of these clocks.
pub(crate) fn signals_out_of_range(design: &Design, stimulus: &Stimulus, batch: &Batch) -> Vec<(NodeId, u64)> {
    let of = |&node: &NodeId| {
        let entries = entries_outside(design, stimulus, batch, node, design.node(node).range);
        entries.into_iter().map(move |entry| (node, entry)).collect::<Vec<_>>()
    };
    batch.nodes().iter().flat_map(of).collect()
}

/// Clocks of pixels that went in for which a signal was outside a range, of these clocks.
fn entries_outside(design: &Design, stimulus: &Stimulus, batch: &Batch, node: NodeId, range: Range) -> Vec<u64> {
    let stage = u64::from(design.node(node).stage);
    let Some(lanes) = batch.of(node) else { return Vec::new() };
    let Some(first) = lanes.first_outside(range.low, range.high) else { return Vec::new() };
    let entry = |row: usize| (batch.first_clock() + row as u64).checked_sub(stage);
    let outside = (first..lanes.clocks()).filter(|&row| !range.contains(lanes.get(row)));
    outside.filter_map(entry).filter(|&entry| stimulus.feeds(entry)).collect()
}
