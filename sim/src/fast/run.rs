//! A run of a plan over a stimulus.
use std::ops::Range;

use specula_hdl::Design;
use specula_hdl::design::NodeId;

use super::input::InputFeed;
use super::plan::{Plan, Watched};
use crate::{Batch, Flow, Lanes, Stimulus};

/// Clocks of reset before the first clock of a run, with all inputs 0: registers that hold data take one step in it.
const RESET_CLOCKS: u64 = 1;

/// A run under way. Lanes and clocks count from the clock of reset, in which every register is 0.
pub struct Run<'a> {
    plan: Plan,
    feed: InputFeed<'a>,
    batch: usize,
    first_clock: u64,
    clocks: u64,
    /// The clock that the next batch's first lane stands for in a column that is not ahead; negative at first, so that columns that
    /// are ahead begin with their clock 0.
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

    /// Runs to the end, or until `sink` stops it. `watched` are the signals that the plan was made for.
    pub fn finish(mut self, watched: &[NodeId], sink: &mut dyn FnMut(&Batch) -> Flow) {
        while let Some(rows) = self.evaluate() {
            if !rows.is_empty() && sink(&self.show(rows, watched)) == Flow::Stop {
                break;
            }
            self.advance();
        }
    }

    /// Evaluates a batch and says which clocks every watched column has reached with it; `None` when all clocks are done.
    fn evaluate(&mut self) -> Option<Range<u64>> {
        let end = self.clocks as i64;
        if self.reported == self.clocks || self.position >= end {
            return None;
        }
        self.lanes = self.batch.min((end - self.position) as usize);
        self.feed.fill(&mut self.plan.memory, self.position - RESET_CLOCKS as i64, self.lanes);
        for step in &mut self.plan.steps {
            // Lanes of clocks before reset.
            let before = step.skew.map_or(0, |skew| (-(skew as i64) - self.position).clamp(0, self.lanes as i64) as usize);
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

    /// These clocks of the watched signals.
    fn show<'b>(&'b self, rows: Range<u64>, nodes: &'b [NodeId]) -> Batch<'b> {
        let clocks = (rows.end - rows.start) as usize;
        let lanes = |watched: &Watched| match *watched {
            Watched::Constant(value) => Lanes::Constant(value, clocks),
            Watched::Column { place, shift } => {
                let first = (rows.start as i64 - shift as i64 - self.position) as isize;
                self.plan.memory.lanes(place, first, clocks)
            }
        };
        let lanes = self.plan.watched.iter().map(lanes).collect();
        Batch::new(self.first_clock + rows.start - RESET_CLOCKS, clocks, nodes, lanes)
    }

    /// Goes on to the next batch.
    fn advance(&mut self) {
        self.plan.memory.advance(self.lanes);
        self.position += self.lanes as i64;
    }
}
