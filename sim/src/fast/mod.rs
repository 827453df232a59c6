//! The fast engine: every clock of every signal, a batch of clocks at a time.
//!
//! Pipelines are almost all feed-forward. So a signal is a column of values, an operator one loop over columns, and a register no work
//! at all: it is its operand's column, read a clock later. Columns run ahead by their depth in the pipeline, so that operands stand in
//! the lane of their reader. Accumulators have a serial kernel; other feedback is evaluated clock by clock. Signals that nobody watches
//! and only one operator reads are fused into it.
mod flow;
mod fuse;
mod input;
mod memory;
mod plan;
mod schedule;
mod step;

use std::ops::Range;

use specula_hdl::Design;
use specula_hdl::design::NodeId;
pub use specula_kernels::Level;

use crate::{Batch, Engine, Flow, Lanes, SimError, Stimulus};
use input::InputFeed;
use plan::{Plan, Watched, plan};

/// How the engine works. What it computes does not depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Clocks in a batch, at least 1.
    pub batch: usize,
    /// The instruction set.
    pub level: Level,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { batch: 512, level: Level::best() }
    }
}

/// The columnar engine.
pub struct Fast<'a> {
    design: &'a Design,
    settings: Settings,
}

impl<'a> Fast<'a> {
    /// An engine for `design`.
    pub fn new(design: &'a Design) -> Fast<'a> {
        Fast::with_settings(design, Settings::default())
    }

    /// An engine for `design` that works in a particular way.
    pub fn with_settings(design: &'a Design, settings: Settings) -> Fast<'a> {
        Fast { design, settings: Settings { batch: settings.batch.max(1), ..settings } }
    }
}

impl Engine for Fast<'_> {
    fn name(&self) -> &'static str {
        "fast"
    }

    fn run(&mut self, stimulus: &Stimulus, watched: &[NodeId], sink: &mut dyn FnMut(&Batch) -> Flow) -> Result<(), SimError> {
        let mut run = Run::new(self.design, stimulus, watched, self.settings);
        while let Some(rows) = run.evaluate() {
            if !rows.is_empty() && sink(&run.show(rows, watched)) == Flow::Stop {
                break;
            }
            run.advance();
        }
        Ok(())
    }
}

/// Clocks of reset before the first clock of a run, with all inputs 0: registers that hold data take one step in it.
const RESET_CLOCKS: u64 = 1;

/// A run under way. Lanes and clocks count from the clock of reset, in which every register is 0.
struct Run<'a> {
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
    fn new(design: &Design, stimulus: &'a Stimulus<'a>, watched: &[NodeId], settings: Settings) -> Run<'a> {
        let plan = plan(design, watched, settings.batch, settings.level);
        let clocks = stimulus.clocks();
        Run {
            feed: InputFeed::new(design, stimulus, &plan.inputs),
            batch: settings.batch,
            first_clock: clocks.start,
            clocks: clocks.end - clocks.start + RESET_CLOCKS,
            position: -(plan.lead as i64),
            lanes: 0,
            reported: RESET_CLOCKS,
            plan,
        }
    }

    /// Evaluates a batch and says which clocks every watched column has reached with it; `None` when all clocks are done.
    fn evaluate(&mut self) -> Option<Range<u64>> {
        let end = self.clocks as i64;
        if self.position >= end {
            return None;
        }
        self.lanes = self.batch.min((end - self.position) as usize);
        self.feed.fill(&mut self.plan.memory, self.position - RESET_CLOCKS as i64, self.lanes);
        for step in &mut self.plan.steps {
            // Lanes of clocks before reset.
            let before = step.skew.map_or(0, |skew| (-(skew as i64) - self.position).clamp(0, self.lanes as i64) as usize);
            step.run(&mut self.plan.memory, before, self.lanes);
        }
        let reached = |watched: &Watched| match *watched {
            Watched::Column { shift, .. } => self.position + self.lanes as i64 + shift as i64,
            Watched::Constant(_) => i64::MAX,
        };
        let end = self.plan.watched.iter().map(reached).min().unwrap_or(0).clamp(0, end) as u64;
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
