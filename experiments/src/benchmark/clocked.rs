//! Timed runs of an engine.
use std::time::Instant;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_sim::{Engine, Flow, Stimulus};

use super::batch_sink::BatchSink;
use super::checksum::Accumulator;
use super::runner::Timed;
use super::{Config, MeasureError};

/// Times `engine` on all of `stimulus`; `sink` receives every batch, and finishing it is part of
/// the time.
///
/// # Errors
/// [`MeasureError`] if the engine or the sink fails.
pub(crate) fn timed(
    config: Config,
    design: &Design,
    engine: &mut dyn Engine,
    stimulus: &Stimulus,
    watched: &[NodeId],
    mut sink: Box<dyn BatchSink>,
) -> Result<Timed, MeasureError> {
    let mut accumulator = Accumulator::new(design, watched, stimulus);
    let mut kept = Ok(());
    let begin = Instant::now();
    engine.run(stimulus, watched, &mut |batch| {
        accumulator.take(batch);
        kept = sink.take(batch);
        if kept.is_ok() { Flow::Continue } else { Flow::Stop }
    })?;
    let ended = kept.and_then(|()| sink.end());
    let seconds = begin.elapsed().as_secs_f64();
    ended.map_err(|reason| MeasureError::Waveform { config: config.describe(), reason })?;
    let clocks = stimulus.clocks();
    Ok(Timed { seconds, clocks: clocks.end - clocks.start, checksum: accumulator.checksum() })
}
