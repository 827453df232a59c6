//! A run of a plan over a stimulus.
use std::ops::Range;

use specula_datapath::Design;
use specula_datapath::design::NodeId;

use super::input::InputFeed;
use super::memory::Memory;
use super::plan::{Plan, Watched};
use crate::columns::Show;
use crate::{Batch, Flow, Lanes, Stimulus};

/// Clocks of reset before the first clock of a run, with all inputs 0: registers that hold data
/// take one step in it.
const RESET_CLOCKS: u64 = 1;

/// A run under way. Lanes and clocks count from the clock of reset, in which every register is 0.
pub struct Run<'a> {
    plan: Plan,
    feed: InputFeed<'a>,
    batch: usize,
    first_clock: u64,
    clocks: u64,
    /// The clock that the next batch's first lane stands for in a column that is not ahead;
    /// negative at first, so that columns that are ahead begin with their clock 0.
    position: i64,
    /// Clocks of this batch.
    lanes: usize,
    /// Clocks handed over so far.
    reported: u64,
}

impl<'a> Run<'a> {
    /// A run of `plan`, which was made for `design` and batches of `batch` clocks.
    pub fn new(plan: Plan, design: &Design, stimulus: &'a Stimulus<'a>, batch: usize) -> Run<'a> {
        let clocks = stimulus.clocks();
        Run {
            feed: InputFeed::new(design, stimulus, &plan.inputs),
            batch,
            first_clock: clocks.start,
            clocks: clocks.end - clocks.start + RESET_CLOCKS,
            position: -(plan.lead as i64),
            lanes: 0,
            reported: RESET_CLOCKS,
            plan,
        }
    }

    /// Runs to the end, or until `sink` stops it. `watched` are the signals that the plan was made
    /// for.
    pub fn finish(mut self, watched: &[NodeId], sink: &mut dyn FnMut(&Batch) -> Flow) {
        while let Some(rows) = self.evaluate() {
            let (first, shown) = (self.first_clock + rows.start - RESET_CLOCKS, self.shown(&rows));
            if !rows.is_empty()
                && sink(&Batch::new(first, shown.clocks, watched, &shown)) == Flow::Stop
            {
                break;
            }
            self.advance();
        }
    }

    /// Evaluates a batch and says which clocks every watched column has reached with it; `None`
    /// when all clocks are done.
    fn evaluate(&mut self) -> Option<Range<u64>> {
        let end = self.clocks as i64;
        if self.reported == self.clocks || self.position >= end {
            return None;
        }
        self.lanes = self.batch.min((end - self.position) as usize);
        self.feed.fill(&mut self.plan.memory, self.position - RESET_CLOCKS as i64, self.lanes);
        for step in &mut self.plan.steps {
            // Lanes of clocks before reset.
            let before = step.skew.map_or(0, |skew| {
                (-(skew as i64) - self.position).clamp(0, self.lanes as i64) as usize
            });
            step.run(&mut self.plan.memory, before, self.lanes);
        }
        let reached = match self.plan.least_shift {
            Some(shift) => self.position + self.lanes as i64 + shift as i64,
            // Constants are known at every clock, and nothing is never shown.
            None if self.plan.watched.is_empty() => 0,
            None => end,
        };
        let end = reached.clamp(0, end) as u64;
        // At first, columns that are ahead have nothing to show.
        let rows = self.reported..end.max(self.reported);
        self.reported = rows.end;
        Some(rows)
    }

    /// The watched signals at these clocks of the run.
    fn shown(&self, rows: &Range<u64>) -> Shown<'_> {
        let Plan { memory, watched, .. } = &self.plan;
        Shown {
            memory,
            watched,
            lane: rows.start as isize - self.position as isize,
            clocks: (rows.end - rows.start) as usize,
        }
    }

    /// Goes on to the next batch.
    fn advance(&mut self) {
        self.plan.memory.advance(self.lanes);
        self.position += self.lanes as i64;
    }
}

/// Some clocks of the watched signals.
struct Shown<'a> {
    memory: &'a Memory,
    watched: &'a [Watched],
    /// The lane of the first of them in a column that is not ahead.
    lane: isize,
    clocks: usize,
}

impl Show for Shown<'_> {
    fn lanes(&self, column: usize) -> Lanes<'_> {
        match self.watched[column] {
            Watched::Constant(value) => Lanes::Constant(value, self.clocks),
            Watched::Column { place, shift } => {
                self.memory.lanes(place, self.lane - shift as isize, self.clocks)
            }
        }
    }
}
