//! The fast engine: every clock of every signal, a batch of clocks at a time.
//!
//! Pipelines are almost all feed-forward. So a signal is a column of values, an operator one loop
//! over columns, and a register no work at all: it is its operand's column, read a clock later.
//! Columns run ahead by their depth in the pipeline, so that operands stand in the lane of their
//! reader. Accumulators have a serial kernel; other feedback is evaluated clock by clock. Signals
//! that nobody watches and only one operator reads are fused into it.
mod flow;
mod fuse;
mod idle;
mod input;
mod kept;
mod memory;
mod parallel;
mod plan;
mod read;
mod run;
mod schedule;
mod serial;
mod settings;
mod step;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
pub use specula_kernels::InstructionSet;

use crate::{Batch, Engine, Flow, SimError, Stimulus};
use parallel::Pieces;
use plan::plan;
use run::Run;

pub use settings::Settings;

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
        let Settings { batch, threads, piece, .. } = settings;
        Fast {
            design,
            settings: Settings {
                batch: batch.max(1),
                threads: threads.max(1),
                piece: piece.max(1),
                ..settings
            },
        }
    }
}

impl Engine for Fast<'_> {
    fn name(&self) -> &'static str {
        "fast"
    }

    fn run(
        &mut self,
        stimulus: &Stimulus,
        watched: &[NodeId],
        sink: &mut dyn FnMut(&Batch) -> Flow,
    ) -> Result<(), SimError> {
        let plan = plan(self.design, watched, stimulus.has_frames(), self.settings);
        if parallel::pays(self.settings, &plan) {
            Pieces { plan: &plan, design: self.design, stimulus, settings: self.settings, watched }
                .run(sink);
        } else {
            Run::new(plan, self.design, stimulus, self.settings.batch).finish(watched, sink);
        }
        Ok(())
    }
}
