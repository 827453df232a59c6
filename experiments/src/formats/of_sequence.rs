//! The core that a sequence is given.
//!
//! A search asks again and again what a core's inputs are given, and setting up all spans of all
//! frames each time would take minutes. A few spans decide it, the sequence's witnesses
//! ([`specula_spec::Survey`]), so the search looks at those, and the core that it finds is made for
//! all frames. In other formats other spans might decide; where that makes the bound larger than the
//! goal, they are added and the search begins again.
use specula_scene::{Frame, SceneError, Sequence};
use specula_spec::{CoreSpec, Survey};
use specula_testbench::BenchError;

use super::DefaultCore;

/// How often the search begins again.
const MOST_ROUNDS: usize = 4;

/// Why a sequence has no core.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum SequenceError {
    /// A frame cannot be drawn.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scene(#[from] SceneError),
    /// A core cannot be built.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Bench(#[from] BenchError),
}

/// The core that `search` finds for a sequence: `search` is given a core for some frames alone, those
/// frames, and finds one whose proven bound is below `below` LSB, or one that is not faithful.
///
/// # Errors
/// Those of `search`, and [`SequenceError`] if a frame cannot be drawn or a core cannot be built.
pub fn core_of_sequence<E: From<SequenceError>>(
    recommended: &CoreSpec,
    sequence: &Sequence,
    below: f64,
    search: impl Fn(CoreSpec, &[Frame]) -> Result<DefaultCore, E>,
) -> Result<DefaultCore, E> {
    let Survey { mut witnesses, .. } = surveyed(recommended, sequence)?;
    let mut found = search(recommended.specialised(&witnesses[..]), &witnesses)?;
    for _ in 0..MOST_ROUNDS {
        let Survey { core, witnesses: more } = surveyed(&found.spec, sequence)?;
        if core == found.spec || found.not_faithful.is_some() || bound(&core)? < below {
            found.spec = core;
            return Ok(found);
        }
        witnesses.extend(more);
        found = search(recommended.specialised(&witnesses[..]), &witnesses)?;
    }
    Ok(DefaultCore { spec: surveyed(&found.spec, sequence)?.core, ..found })
}

fn surveyed(core: &CoreSpec, sequence: &Sequence) -> Result<Survey, SequenceError> {
    Ok(core.survey(sequence)?)
}

/// The proven bound of a core's quantisation error, in LSBs.
fn bound(core: &CoreSpec) -> Result<f64, SequenceError> {
    let design = specula_hdl::elaborate(core, "core").map_err(BenchError::from)?;
    Ok(design.error_bound())
}
