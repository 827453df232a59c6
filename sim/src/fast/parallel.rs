//! Several threads on one run.
//!
//! In a pipeline without other feedback than accumulators that every span loads, the values of some
//! clocks depend on the inputs of a bounded number of clocks before them, from the beginning of a
//! span on. So the run is cut into pieces of clocks, each evaluated by itself from far enough back,
//! and handed over in order: the same values whatever the number of threads. Threads take pieces in
//! turn and go on to their next while the last one is looked at.
use std::ops::Range;
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread::{self, Scope};

use specula_datapath::Design;
use specula_datapath::design::NodeId;

use super::kept::Kept;
use super::plan::Plan;
use super::run::Run;
use super::settings::Settings;
use crate::{Batch, Flow, Stimulus};

/// Values that a piece may hold: 8 MiB, where they have 32 bits. A piece is copied before it is
/// handed over, so where many signals are watched one thread, which shows its columns in place, is
/// faster, and its memory does not grow with the piece.
const MOST_VALUES: usize = 1 << 21;
/// Pieces of a thread that may wait to be looked at while it works on another.
const WAITING: usize = 1;

/// Whether more than one thread is wanted for a plan, it can be cut into pieces, and pieces of so
/// many clocks are small.
pub fn pays(settings: Settings, plan: &Plan) -> bool {
    let values = plan.watched.len().saturating_mul(settings.piece);
    settings.threads > 1 && plan.restarts_with_spans && values <= MOST_VALUES
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
    /// Evaluates pieces on as many threads as the settings say, and hands their clocks over in
    /// order on this one.
    pub fn run(&self, sink: &mut dyn FnMut(&Batch) -> Flow) {
        let threads = self.settings.threads;
        thread::scope(|scope| {
            let workers: Vec<Option<Receiver<Kept>>> =
                (0..threads).map(|number| self.worker(scope, number)).collect();
            for (number, piece) in self.pieces().enumerate() {
                let kept = match &workers[number % threads] {
                    Some(results) => results.recv().ok(),
                    None => Some(self.evaluate(&piece)),
                };
                // Nothing comes from a thread that has panicked, and the scope passes its panic on.
                // Threads end when nobody receives.
                let Some(kept) = kept else { return };
                if sink(&kept.batch(self.watched)) == Flow::Stop {
                    return;
                }
            }
        });
    }

    /// Has every piece whose turn is that of thread `number` evaluated by a thread; `None` where no
    /// thread is to be had.
    fn worker<'scope>(
        &'scope self,
        scope: &'scope Scope<'scope, '_>,
        number: usize,
    ) -> Option<Receiver<Kept>> {
        let (results, receiver) = sync_channel(WAITING);
        let work = move || {
            for piece in self.pieces().skip(number).step_by(self.settings.threads) {
                if results.send(self.evaluate(&piece)).is_err() {
                    return;
                }
            }
        };
        thread::Builder::new().spawn_scoped(scope, work).ok().map(|_| receiver)
    }

    fn pieces(&self) -> impl Iterator<Item = Range<u64>> {
        let (clocks, piece) = (self.stimulus.clocks(), self.settings.piece as u64);
        let end = clocks.end;
        clocks.step_by(self.settings.piece).map(move |first| first..(first + piece).min(end))
    }

    fn evaluate(&self, piece: &Range<u64>) -> Kept {
        let part = self.stimulus.reaching_back(piece, self.plan.reach);
        let mut kept = Kept::new(piece);
        Run::new(self.plan.clone(), self.design, &part, self.settings.batch).finish(
            self.watched,
            &mut |shown| {
                let shown = shown.within(piece);
                if shown.clocks() > 0 {
                    kept.extend(&shown);
                }
                Flow::Continue
            },
        );
        kept
    }
}
