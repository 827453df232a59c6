//! Several threads on one run.
//!
//! In a pipeline without other feedback than accumulators that every span loads, the values of some clocks depend on the inputs of a
//! bounded number of clocks before them, from the beginning of a span on. So the run is cut into pieces of clocks, each evaluated by
//! itself from far enough back, and handed over in order: the same values whatever the number of threads.
use std::ops::Range;

use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use specula_hdl::Design;
use specula_hdl::design::NodeId;

use super::Settings;
use super::plan::Plan;
use super::run::Run;
use crate::{Batch, Columns, Flow, Stimulus};

/// Values that a piece may hold: 8 MiB. A piece is copied before it is handed over, so where many signals are watched one thread, which
/// shows its columns in place, is faster, and its memory does not grow with the piece.
const MOST_VALUES: usize = 1 << 20;

/// Threads for a plan, if more than one is wanted, it can be cut into pieces, and pieces of so many clocks are small.
pub fn pool(settings: Settings, plan: &Plan) -> Option<ThreadPool> {
    let values = plan.watched.len().saturating_mul(settings.piece);
    if settings.threads < 2 || !plan.restarts_with_spans || values > MOST_VALUES {
        return None;
    }
    // Where no threads are to be had, the run goes on without.
    ThreadPoolBuilder::new().num_threads(settings.threads).build().ok()
}

/// A run that is cut into pieces.
pub struct Pieces<'a> {
    pub plan: &'a Plan,
    pub design: &'a Design,
    pub stimulus: &'a Stimulus<'a>,
    pub settings: Settings,
    /// The signals that the plan was made for.
    pub watched: &'a [NodeId],
}

impl Pieces<'_> {
    /// Evaluates as many pieces at once as the pool has threads and hands their clocks over in order.
    pub fn run(&self, pool: &ThreadPool, sink: &mut dyn FnMut(&Batch) -> Flow) {
        let pieces: Vec<Range<u64>> = self.pieces().collect();
        for group in pieces.chunks(2 * pool.current_num_threads()) {
            let results: Vec<Columns> = pool.install(|| group.par_iter().map(|piece| self.evaluate(piece)).collect());
            if results.iter().any(|columns| sink(&columns.batch()) == Flow::Stop) {
                return;
            }
        }
    }

    fn pieces(&self) -> impl Iterator<Item = Range<u64>> {
        let (clocks, piece) = (self.stimulus.clocks(), self.settings.piece as u64);
        let end = clocks.end;
        clocks.step_by(self.settings.piece).map(move |first| first..(first + piece).min(end))
    }

    fn evaluate(&self, piece: &Range<u64>) -> Columns {
        let part = self.stimulus.reaching_back(piece, self.plan.reach);
        let mut columns = Columns::new(self.watched);
        Run::new(self.plan.clone(), self.design, &part, self.settings.batch).finish(self.watched, &mut |shown| {
            let shown = shown.within(piece);
            if shown.clocks() > 0 {
                columns.extend(&shown);
            }
            Flow::Continue
        });
        columns
    }
}
