//! A run: what waveform, pictures and reports are made from.
use std::ops::Range;

use specula_experiments::tradeoff::FrameCycles;
use specula_experiments::{BoundShare, Savings};
use specula_testbench::trace::Choice;
use specula_testbench::{Bench, EngineKind, Outcome};

use crate::clock::Clock;
use crate::device::Fitted;
use crate::disagreement::Disagreement;
use crate::error::ToolError;
use crate::job::Job;
use crate::progress;
use crate::sequence::ShadedSequence;
use crate::stream_top::StreamOutcome;
use crate::trace_file::TraceFormat;

/// The engine that simulates unless another one is chosen.
pub const DEFAULT_ENGINE: EngineKind = EngineKind::Fast;

/// Simulates a frame and compares every pixel, with a progress bar.
///
/// # Errors
/// [`ToolError::Bench`] if the engine fails.
pub fn simulate(bench: &Bench, engine: EngineKind) -> Result<Outcome, ToolError> {
    let clocks = bench.clocks() + 1;
    let bar = progress::bar("simulating", clocks);
    let outcome = bench.run(engine, &mut |done, _| bar.set_position(done));
    bar.finish_and_clear();
    Ok(outcome?)
}

/// A run that has been simulated and compared.
pub struct Run<'a> {
    /// The scene, and the origin of the core.
    pub job: &'a Job,
    /// The name of the core's module.
    pub module: String,
    /// The core and the frame.
    pub bench: &'a Bench<'a>,
    /// The engine that simulated it.
    pub engine: EngineKind,
    /// The kind of file for its waveform.
    pub trace_format: TraceFormat,
    /// What is traced.
    pub trace: Choice,
    /// The clocks in the waveform; `None` without a waveform.
    pub window: Option<Range<u64>>,
    /// The clock for which times are computed.
    pub clock: Clock,
    /// The share of the device that the core takes, if the user named a device.
    pub fitted: Option<Fitted>,
    /// The outcome of the simulation.
    pub outcome: &'a Outcome,
    /// The seed of random pauses, if there are any.
    pub stalls: Option<u32>,
    /// All frames, if the scene moves; then the run is that of one of them.
    pub sequence: Option<ShadedSequence>,
    /// The outcome of its streams, if they were simulated.
    pub stream: Option<StreamOutcome>,
    /// What disagrees, if anything does.
    pub disagreement: Option<Disagreement>,
    /// The contribution of each narrowing point to the bound.
    pub bound_shares: Vec<BoundShare>,
    /// What the scene's needs save; `None` for a general core, or if a core without one of the
    /// needs cannot be built.
    pub savings: Option<Savings>,
}

impl Run<'_> {
    /// The scene's name.
    pub fn name(&self) -> &str {
        &self.job.scene.name
    }

    /// The clock that a reader wants to see: that of the first disagreement, of an error above its
    /// bound, or the one in which the worst pixel leaves.
    pub fn clock_to_look_at(&self) -> Option<u64> {
        self.disagreement.as_ref().map(Disagreement::first_clock).or(self.outcome.worst_cycle)
    }

    /// The bound divided by the largest measured quantisation error; `None` if the bound is not
    /// finite or there is no error.
    pub fn bound_ratio(&self) -> Option<f64> {
        let ratio =
            self.bench.design.error_bound() / self.outcome.comparison.errors.quantisation.max_lsb;
        ratio.is_finite().then_some(ratio)
    }

    /// Frames per second at the clock, including set-up.
    pub fn frames_per_second(&self) -> f64 {
        self.clock.frames_per_second(&FrameCycles::new(&self.bench.design, self.bench.frame))
    }

    /// Frames per second as text.
    pub fn frames_per_second_in_words(&self) -> String {
        let paused = self.stalls.is_some() || self.stream.is_some();
        format!(
            "{:.1} at {} that is not proven, set-up counted{}",
            self.frames_per_second(),
            self.clock.in_words(),
            if paused { ", of the core alone and without pauses" } else { "" }
        )
    }

    /// Clocks for each pixel, including the latency of the core.
    pub fn cycles_per_pixel(&self) -> f64 {
        self.outcome.cycles as f64 / self.outcome.pixels.max(1) as f64
    }
}
