//! Facts that intervals cannot see, checked on every clock.
use std::ops::Range as Row;

use specula_datapath::Design;
use specula_datapath::design::{Assumption, NodeId, Range};
use specula_sim::{Batch, Lanes, Stimulus};
use specula_spec::Format;

/// A fact that did not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// The fact, as the unit states it.
    pub fact: String,
    /// Full name of the signal.
    pub signal: String,
    /// The clock.
    pub clock: u64,
    /// The raw value it had.
    pub raw: i64,
    /// Where that must lie.
    pub limits: Range,
    /// Of the signal.
    pub format: Format,
}

impl Violation {
    /// The value it had, as near as an f64 comes.
    pub fn value(&self) -> f64 {
        self.format.value(self.raw)
    }

    /// In words, every digit of the numbers: a value may be past its limit by less than an f64
    /// shows.
    pub fn in_words(&self) -> String {
        let [value, low, high] =
            [self.raw, self.limits.low, self.limits.high].map(|raw| self.format.in_digits(raw));
        format!(
            "`{}` does not hold: signal {} is {value} in cycle {}, and must lie from {low} to {high}",
            self.fact, self.signal, self.clock
        )
    }
}

/// Signals that have to be watched.
pub fn watched(design: &Design) -> impl Iterator<Item = NodeId> + '_ {
    design.assumptions.iter().map(|a| a.node)
}

/// What is seen of facts while a simulation goes on.
pub struct Facts<'a> {
    design: &'a Design,
    /// Smallest and largest raw value of each fact's signal, wherever a pixel is; none where no
    /// pixel has come.
    pub seen: Vec<Option<Range>>,
    /// The first fact that did not hold.
    pub violation: Option<Violation>,
}

impl<'a> Facts<'a> {
    /// Those of a design.
    pub fn of(design: &'a Design) -> Facts<'a> {
        Facts { design, seen: vec![None; design.assumptions.len()], violation: None }
    }

    /// Looks at the next clocks.
    pub fn take(&mut self, stimulus: &Stimulus, batch: &Batch) {
        for (assumption, seen) in self.design.assumptions.iter().zip(&mut self.seen) {
            for (clock, lanes) in of_pixels(self.design, stimulus, batch, assumption.node) {
                let Some((low, high)) = lanes.extremes() else { continue };
                let now = Range::new(low, high);
                *seen = Some(seen.map_or(now, |before| before.hull(now)));
                if self.violation.is_none() && assumption.range.hull(now) != assumption.range {
                    self.violation = violation(self.design, assumption, (clock, lanes));
                }
            }
        }
    }
}

/// The first value outside its limits among those from a clock on.
fn violation(
    design: &Design,
    assumption: &Assumption,
    (clock, lanes): (u64, Lanes),
) -> Option<Violation> {
    let limits = assumption.range;
    let row = lanes.first_outside(limits.low, limits.high)?;
    let row = (row..lanes.clocks()).find(|&row| !limits.contains(lanes.get(row)))?;
    Some(Violation {
        fact: assumption.fact.clone(),
        signal: design.full_name(assumption.node),
        clock: clock + row as u64,
        raw: lanes.get(row),
        limits,
        format: design.node(assumption.node).format(),
    })
}

/// A signal's values wherever it belongs to a pixel, row after row of consecutive clocks, each with
/// its first clock.
fn of_pixels<'b>(
    design: &Design,
    stimulus: &Stimulus,
    batch: &Batch<'b>,
    node: NodeId,
) -> impl Iterator<Item = (u64, Lanes<'b>)> {
    let stage = u64::from(design.node(node).stage);
    let (first, end) = (batch.first_clock(), batch.first_clock() + batch.clocks() as u64);
    let clocks = first.saturating_sub(stage)..end.saturating_sub(stage);
    let fed = stimulus.fed_rows(clocks).flat_map(|row| entries(design, stimulus, row));
    let lanes = batch.of(node);
    fed.filter_map(move |entries| {
        let (begin, end) = (entries.start + stage, entries.end + stage);
        let rows = (begin.max(first) - first) as usize..(end - first) as usize;
        Some((begin.max(first), lanes?.rows(rows)))
    })
}

/// The rows of a row of entries of which values belong to pixels.
fn entries(design: &Design, stimulus: &Stimulus, row: Row<u64>) -> Vec<Row<u64>> {
    if !design.last_slot_only {
        return vec![row];
    }
    row.filter(|&clock| stimulus.completes(clock)).map(|clock| clock..clock + 1).collect()
}

/// Clocks of pixels that went in for which a fact did not hold, of these clocks, in no order.
pub fn entries_that_violate(design: &Design, stimulus: &Stimulus, batch: &Batch) -> Vec<u64> {
    let facts = design.assumptions.iter().map(|assumption| (assumption.node, assumption.range));
    facts.flat_map(|(node, range)| entries_outside(design, stimulus, batch, node, range)).collect()
}

/// Signals outside their proven ranges, and clocks of the pixels that went in to which that
/// belongs, of these clocks.
pub fn signals_out_of_range(
    design: &Design,
    stimulus: &Stimulus,
    batch: &Batch,
) -> Vec<(NodeId, u64)> {
    let of = |&node: &NodeId| {
        let entries = entries_outside(design, stimulus, batch, node, design.node(node).range);
        entries.into_iter().map(move |entry| (node, entry)).collect::<Vec<_>>()
    };
    batch.nodes().iter().flat_map(of).collect()
}

/// Clocks of pixels that went in for which a signal was outside a range, of these clocks.
fn entries_outside(
    design: &Design,
    stimulus: &Stimulus,
    batch: &Batch,
    node: NodeId,
    range: Range,
) -> Vec<u64> {
    let stage = u64::from(design.node(node).stage);
    let Some(lanes) = batch.of(node) else { return Vec::new() };
    let Some(first) = lanes.first_outside(range.low, range.high) else { return Vec::new() };
    let entry = |row: usize| (batch.first_clock() + row as u64).checked_sub(stage);
    let outside = (first..lanes.clocks()).filter(|&row| !range.contains(lanes.get(row)));
    let belongs_to_a_pixel = |&entry: &u64| {
        if design.last_slot_only { stimulus.completes(entry) } else { stimulus.feeds(entry) }
    };
    outside.filter_map(entry).filter(belongs_to_a_pixel).collect()
}
