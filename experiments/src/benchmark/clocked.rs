//! Running an engine and timing it.
use std::time::Instant;

use specula_hdl::Design;
use specula_hdl::design::NodeId;
use specula_sim::{Engine, Flow, Stimulus};

use super::contestant::Timed;
use super::keeper::Keeper;
use super::sums::Summing;
use super::{Entry, MeasureError};

/// Times `engine` on all of `stimulus`; `keeper` is given every batch, and its end counts.
///
/// # Errors
/// [`MeasureError`] if the engine or the keeper fails.
pub(crate) fn timed(
    entry: Entry,
    design: &Design,
    engine: &mut dyn Engine,
    stimulus: &Stimulus,
    watched: &[NodeId],
    mut keeper: Box<dyn Keeper>,
) -> Result<Timed, MeasureError> {
    let mut summing = Summing::new(design, watched, stimulus);
    let mut kept = Ok(());
    let begin = Instant::now();
    engine.run(stimulus, watched, &mut |batch| {
        summing.take(batch);
        kept = keeper.take(batch);
        if kept.is_ok() { Flow::Continue } else { Flow::Stop }
    })?;
    let ended = kept.and_then(|()| keeper.end());
    let seconds = begin.elapsed().as_secs_f64();
    ended.map_err(|reason| MeasureError::Waveform { entry: entry.describe(), reason })?;
    let clocks = stimulus.clocks();
    Ok(Timed { seconds, clocks: clocks.end - clocks.start, sums: summing.sums() })
}
