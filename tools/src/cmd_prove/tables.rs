//! What came of the questions, as tables.
use std::collections::BTreeMap;

use specula_datapath::bound::Interval;
use specula_proof::{About, Outcome, Question, Standing};

use super::proven::Proven;
use crate::table;

/// Titles of [`methods`].
pub const METHODS: [&str; 7] =
    ["method", "values", "goals", "proven", "but for f64", "by facts", "not proven"];

/// Titles of [`bounds`].
pub const BOUNDS: [&str; 8] =
    ["method", "unit", "signal", "of", "Specula's", "Gappa's", "verdict", "rests on"];

/// Titles of [`facts`].
pub const FACTS: [&str; 4] = ["fact", "about", "values", "where it is derived"];

/// All tables, for a terminal.
pub fn text(proven: &[Proven]) -> String {
    format!(
        "{}\n{}\n{}",
        table::shown(&titled(METHODS, methods(proven))),
        table::shown(&titled(BOUNDS, bounds(proven))),
        table::shown(&titled(FACTS, facts(proven))),
    )
}

fn titled<const N: usize>(titles: [&str; N], rows: Vec<[String; N]>) -> Vec<[String; N]> {
    [vec![titles.map(str::to_owned)], rows].concat()
}

/// A row for each method: how many values and goals there are, and how they stand.
pub fn methods(proven: &[Proven]) -> Vec<[String; 7]> {
    let row = |core: &Proven| {
        let standing = |of: &[Standing]| {
            core.outcomes().filter(|(_, outcome)| of.contains(&outcome.standing)).count()
        };
        let numbers = [
            core.answers.len(),
            core.outcomes().count(),
            standing(&[Standing::Proven]),
            standing(&[Standing::ProvenWhenRounded]),
            standing(&[Standing::Fact]),
            standing(&[Standing::TimedOut, Standing::Unproven]),
        ];
        let [a, b, c, d, e, f] = numbers.map(|number| number.to_string());
        [core.method.name().to_owned(), a, b, c, d, e, f]
    };
    proven.iter().map(row).collect()
}

/// A row for each bound on an error, and for whatever else is not proven.
pub fn bounds(proven: &[Proven]) -> Vec<[String; 8]> {
    let row = |core: &Proven, (question, outcome): (&Question, &Outcome)| {
        [
            core.method.name().to_owned(),
            place(question),
            question.signal.clone(),
            outcome.about.word().to_owned(),
            figure(outcome, outcome.stated),
            outcome.found.map_or("-".to_owned(), |found| figure(outcome, found)),
            in_words(outcome.standing).to_owned(),
            rests_on(outcome),
        ]
    };
    let is_shown =
        |outcome: &Outcome| outcome.about == About::Error || outcome.standing > Standing::Fact;
    let shown = |core: &'_ Proven| {
        core.outcomes()
            .filter(|(_, outcome)| is_shown(outcome))
            .map(|of| row(core, of))
            .collect::<Vec<_>>()
    };
    proven.iter().flat_map(shown).collect()
}

/// The unit's path below the core.
fn place(question: &Question) -> String {
    question.path.split_once('.').map_or(&*question.path, |(_, below)| below).to_owned()
}

/// An error's magnitude, or an interval.
fn figure(outcome: &Outcome, of: Interval) -> String {
    match outcome.about {
        About::Error => format!("{:.4e}", of.magnitude()),
        About::Range | About::Real => format!("{:.6} to {:.6}", of.low, of.high),
    }
}

fn in_words(standing: Standing) -> &'static str {
    match standing {
        Standing::Proven => "proven",
        Standing::ProvenWhenRounded => "proven but for f64",
        Standing::Fact => "by the fact",
        Standing::TimedOut => "TOOK TOO LONG",
        Standing::Unproven => "TOO SMALL",
    }
}

fn rests_on(outcome: &Outcome) -> String {
    let names: Vec<&str> = outcome.premises.iter().map(String::as_str).collect();
    if names.is_empty() { "propagation".to_owned() } else { names.join("; ") }
}

/// A row for each fact that states something: what about, of how many values, and where it is derived.
pub fn facts(proven: &[Proven]) -> Vec<[String; 4]> {
    let mut counts: BTreeMap<(String, About), usize> = BTreeMap::new();
    for (question, outcome) in proven.iter().flat_map(Proven::outcomes) {
        let own = question.fact.as_ref().filter(|fact| fact.about == outcome.about);
        match own {
            Some(fact) if outcome.standing == Standing::Fact => {
                *counts.entry((fact.name.clone(), fact.about)).or_default() += 1;
            }
            _ => {}
        }
    }
    let row = |((name, about), count): ((String, About), usize)| {
        let place = derivation(&name, about);
        [name, about.word().to_owned(), count.to_string(), place]
    };
    counts.into_iter().map(row).collect()
}

/// Where a fact is derived.
fn derivation(name: &str, about: About) -> String {
    let file = name.strip_prefix("error::").and_then(|rest| rest.split("::").next());
    match (file, about) {
        (Some(file), _) => format!("hdl/src/error/{file}.rs"),
        (None, About::Range) => "checked in every clock of a simulation".to_owned(),
        (None, About::Real) => "a property of the scene, by its needs".to_owned(),
        (None, About::Error) => "prose: docs/proofs.md".to_owned(),
    }
}
