//! What came of the questions, as JSON.
use serde::Serialize;
use specula_datapath::bound::Interval;
use specula_proof::{Outcome, Question, Standing};

use super::proven::Proven;
use crate::output::PROGRAM;

#[derive(Serialize)]
struct Report<'a> {
    /// Always `specula`: by it a later run recognises that the listed files are its own.
    program: &'static str,
    version: &'static str,
    scene: &'a str,
    methods: Vec<Core<'a>>,
    files: &'a [String],
}

#[derive(Serialize)]
struct Core<'a> {
    method: &'static str,
    holds: bool,
    goals: Vec<Goal<'a>>,
}

#[derive(Serialize)]
struct Goal<'a> {
    unit: &'a str,
    signal: &'a str,
    about: &'static str,
    /// Where Specula says that it lies.
    stated: [f64; 2],
    /// Where Gappa says by itself that it lies.
    found: Option<[f64; 2]>,
    standing: &'static str,
    premises: Vec<&'a str>,
}

/// The report.
pub fn text(scene: &str, proven: &[Proven], files: &[String]) -> serde_json::Result<String> {
    let report = Report {
        program: PROGRAM,
        version: env!("CARGO_PKG_VERSION"),
        scene,
        methods: proven.iter().map(core).collect(),
        files,
    };
    Ok(serde_json::to_string_pretty(&report)? + "\n")
}

fn core(core: &Proven) -> Core<'_> {
    Core {
        method: core.method.name(),
        holds: core.holds(),
        goals: core.outcomes().map(|(question, outcome)| goal(question, outcome)).collect(),
    }
}

fn goal<'a>(question: &'a Question, outcome: &'a Outcome) -> Goal<'a> {
    let ends = |of: Interval| [of.low, of.high];
    Goal {
        unit: &question.path,
        signal: &question.signal,
        about: outcome.about.word(),
        stated: ends(outcome.stated),
        found: outcome.found.map(ends),
        standing: match outcome.standing {
            Standing::Proven => "proven",
            Standing::ProvenWhenRounded => "proven_but_for_f64",
            Standing::Fact => "fact",
            Standing::TimedOut => "timed_out",
            Standing::Unproven => "unproven",
        },
        premises: outcome.premises.iter().map(String::as_str).collect(),
    }
}
