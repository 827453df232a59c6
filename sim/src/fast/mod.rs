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

use specula_hdl::Design;
use specula_hdl::design::NodeId;
pub use specula_kernels::Level;

use crate::{Columns, Engine, Flow, SimError, Stimulus};
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

    fn run(&mut self, stimulus: &Stimulus, watched: &[NodeId], sink: &mut dyn FnMut(&Columns) -> Flow) -> Result<(), SimError> {
        let mut run = Run::new(self.design, stimulus, watched, self.settings);
        while run.batch() {
            if run.columns.clocks() > 0 && sink(&run.columns) == Flow::Stop {
                break;
            }
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
    /// Clocks handed over so far.
    reported: u64,
    columns: Columns,
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
            reported: RESET_CLOCKS,
            columns: Columns::new(watched),
            plan,
        }
    }

    /// Evaluates a batch and collects the watched signals; false when there is none left.
    fn batch(&mut self) -> bool {
        let end = self.clocks as i64;
        if self.position >= end {
            return false;
        }
        let lanes = self.batch.min((end - self.position) as usize);
        self.feed.fill(&mut self.plan.memory, self.position - RESET_CLOCKS as i64, lanes);
        for step in &mut self.plan.steps {
            // Lanes of clocks before reset.
            let before = step.skew.map_or(0, |skew| (-(skew as i64) - self.position).clamp(0, lanes as i64) as usize);
            step.run(&mut self.plan.memory, before, lanes);
        }
        self.report(lanes);
        self.plan.memory.advance(lanes);
        self.position += lanes as i64;
        self.position < end || self.columns.clocks() > 0
    }

    /// Collects the clocks that every watched column has reached.
    fn report(&mut self, lanes: usize) {
        let reached = |watched: &Watched| match *watched {
            Watched::Column { shift, .. } => self.position + lanes as i64 + shift as i64,
            Watched::Constant(_) => i64::MAX,
        };
        let end = self.plan.watched.iter().map(reached).min().unwrap_or(0).clamp(0, self.clocks as i64) as u64;
        self.columns.restart(self.first_clock + self.reported - RESET_CLOCKS);
        // At first, columns that are ahead have nothing to show.
        if end <= self.reported {
            return;
        }
        for (column, watched) in self.columns.values.iter_mut().zip(&self.plan.watched) {
            match *watched {
                Watched::Constant(value) => column.resize((end - self.reported) as usize, value),
                Watched::Column { place, shift } => {
                    let lane = |clock: u64| (clock as i64 - shift as i64 - self.position) as isize;
                    self.plan.memory.append(place, lane(self.reported), lane(end), column);
                }
            }
        }
        self.reported = end;
    }
}
