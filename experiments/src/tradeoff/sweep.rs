//! Runs all configurations of a sweep in parallel.
use miette::Diagnostic;
use rayon::prelude::*;
use specula_scene::LoadedScene;
use specula_spec::CoreSpec;
use thiserror::Error;

use super::configuration::default_spec;
use super::{Configuration, Journal, JournalError, Measured};
use specula_testbench::BenchError;

/// A configuration and its core.
#[derive(Clone, Debug)]
pub struct Planned {
    /// The configuration.
    pub configuration: Configuration,
    /// Its core, or the reason why there is none.
    pub spec: Result<CoreSpec, String>,
}

/// A configuration and its result.
#[derive(Clone, Debug)]
pub struct SweepResult {
    /// The configuration.
    pub configuration: Configuration,
    /// Its measurement, or the reason why there is none.
    pub result: Result<Measurement, String>,
}

/// A core that was measured.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// The core.
    pub spec: CoreSpec,
    /// The measured figures.
    pub measured: Measured,
    /// Whether the journal contained it.
    pub known: bool,
}

/// The reason why a sweep was not finished.
#[derive(Debug, Error, Diagnostic)]
pub enum SweepError {
    /// A core cannot be simulated.
    #[error("{configuration}: {source}")]
    #[diagnostic(code(specula::compare::bench))]
    Bench {
        /// The configuration of that core.
        configuration: Configuration,
        /// The reason.
        source: BenchError,
    },
    /// Results cannot be kept.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Journal(#[from] JournalError),
}

/// The cores of configurations for a scene, each as `made` makes it for a target; it says why where
/// it cannot. Configurations of a method that follow each other share the search for its default
/// formats.
pub fn plan(
    scene: &LoadedScene,
    configurations: &[Configuration],
    made: &(dyn Fn(CoreSpec) -> Result<CoreSpec, String> + Sync),
) -> Vec<Planned> {
    let methods: Vec<&[Configuration]> =
        configurations.chunk_by(|a, b| a.method == b.method).collect();
    let planned = |of_method: &[Configuration]| {
        // Chunks are not empty.
        let default = default_spec(of_method[0].method, scene);
        let planned = |&configuration: &Configuration| {
            let default = default.as_ref().map_err(Clone::clone);
            let spec = default.and_then(|of| configuration.spec(of, scene)).and_then(made);
            Planned { spec, configuration }
        };
        of_method.iter().map(planned).collect::<Vec<Planned>>()
    };
    methods.into_par_iter().flat_map_iter(planned).collect()
}

/// Measures every core whose result is not in `journal`. `done` is called for each one as soon as
/// its result exists.
///
/// # Errors
/// [`SweepError`] if a core cannot be simulated or a result cannot be written down.
pub fn sweep(
    scene: &LoadedScene,
    planned: Vec<Planned>,
    journal: &Journal,
    done: &(dyn Fn(&Configuration) + Sync),
) -> Result<Vec<SweepResult>, SweepError> {
    let row = |Planned { configuration, spec }| {
        let result = match spec {
            Ok(spec) => measured(scene, configuration, spec, journal)?,
            Err(refusal) => Err(refusal),
        };
        done(&configuration);
        Ok(SweepResult { configuration, result })
    };
    planned.into_par_iter().map(row).collect()
}

fn measured(
    scene: &LoadedScene,
    configuration: Configuration,
    spec: CoreSpec,
    journal: &Journal,
) -> Result<Result<Measurement, String>, SweepError> {
    if let Some(measured) = journal.find(&spec)? {
        return Ok(Ok(Measurement { spec, measured, known: true }));
    }
    match Measured::new(scene, &spec) {
        Ok(measured) => {
            journal.add(&spec, &measured)?;
            Ok(Ok(Measurement { spec, measured, known: false }))
        }
        Err(BenchError::TooWide(refusal)) => Ok(Err(refusal.to_string())),
        Err(source) => Err(SweepError::Bench { configuration, source }),
    }
}
