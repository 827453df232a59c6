//! What Gappa's answers mean for a question.
use std::collections::BTreeSet;
use std::time::Duration;

use specula_datapath::bound::Interval;

use crate::gappa::{Answer, asked};
use crate::{About, Alternative, Goal, ProofError, Question, Script};

/// How a goal stands, from the best to the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// Gappa proves it as it is stated.
    Proven,
    /// Gappa proves it with the share [`ROUNDING`] more, which is what f64 rounds.
    ProvenWhenRounded,
    /// It is stated by a fact, which Gappa does not find.
    Fact,
    /// Gappa took too long.
    TimedOut,
    /// Gappa does not prove it.
    Unproven,
}

/// What the sums and products in which a bound is computed in f64 round, as a share: some thousand
/// times half a unit of 53 bits.
pub const ROUNDING: f64 = 1.0 / (1u64 << 40) as f64;

/// What came of one of a question's goals.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// What it is about.
    pub about: About,
    /// Where Specula says that it lies.
    pub stated: Interval,
    /// Where Gappa says that it lies, by itself.
    pub found: Option<Interval>,
    /// How it stands.
    pub standing: Standing,
    /// Names of what it rests on besides propagation.
    pub premises: BTreeSet<String>,
}

/// Asks a question; `finer` is the same one parted at each narrowing, for what Gappa does not prove
/// of it.
///
/// # Errors
/// [`ProofError`] if Gappa cannot be run.
pub fn answered(
    question: &Question,
    finer: &Question,
    limit: Duration,
) -> Result<Vec<Outcome>, ProofError> {
    let mut outcomes = best_of(question, &question.alternatives, limit)?;
    if outcomes.iter().any(|outcome| outcome.standing >= Standing::TimedOut) {
        for other in best_of(finer, &finer.alternatives, limit)? {
            merge(&mut outcomes, other);
        }
    }
    if let Some(fact) = &question.fact {
        by_fact(question, &fact.name, fact.about, &mut outcomes);
    }
    outcomes.sort_by_key(|outcome| outcome.about);
    Ok(outcomes)
}

fn best_of(
    question: &Question,
    alternatives: &[Alternative],
    limit: Duration,
) -> Result<Vec<Outcome>, ProofError> {
    let mut best = vec![];
    for alternative in alternatives {
        let fact = question.fact.as_ref().map(|fact| fact.about);
        for outcome in of_cases(alternative, fact, limit)? {
            merge(&mut best, outcome);
        }
        if best.iter().all(|outcome| outcome.standing == Standing::Proven) {
            break;
        }
    }
    Ok(best)
}

/// Keeps the better of two outcomes of the same goal.
fn merge(outcomes: &mut Vec<Outcome>, other: Outcome) {
    match outcomes.iter_mut().find(|outcome| outcome.about == other.about) {
        None => outcomes.push(other),
        Some(outcome) => {
            if other.standing < outcome.standing {
                *outcome = other;
            }
        }
    }
}

/// All cases together: the worst of each goal.
fn of_cases(
    alternative: &Alternative,
    fact: Option<About>,
    limit: Duration,
) -> Result<Vec<Outcome>, ProofError> {
    let mut worst: Vec<Outcome> = vec![];
    for script in &alternative.cases {
        for goal in &script.goals {
            let (standing, found) = of_goal(script, goal, fact == Some(goal.about), limit)?;
            match worst.iter_mut().find(|outcome| outcome.about == goal.about) {
                None => worst.push(Outcome {
                    about: goal.about,
                    stated: goal.stated,
                    found,
                    standing,
                    premises: alternative.premises.clone(),
                }),
                Some(outcome) => {
                    outcome.standing = outcome.standing.max(standing);
                    outcome.found = match (outcome.found, found) {
                        (Some(a), Some(b)) => Some(a.hull(b)),
                        (a, b) => a.or(b),
                    };
                }
            }
        }
    }
    Ok(worst)
}

/// How a goal stands in one case. Where a fact states it, Gappa's own figure alone is of interest.
fn of_goal(
    script: &Script,
    goal: &Goal,
    by_fact: bool,
    limit: Duration,
) -> Result<(Standing, Option<Interval>), ProofError> {
    let found = match asked(&script.open(std::slice::from_ref(goal)), limit)? {
        Answer::Proven(found) | Answer::Unproven(found) => found.get(&goal.expression).copied(),
        Answer::TimedOut => None,
    };
    let is_within = |found: Interval| goal.stated.hull(found) == goal.stated;
    if by_fact && !found.is_some_and(is_within) {
        return Ok((Standing::Fact, found));
    }
    let rounded = Goal { stated: enlarged(goal.stated), ..goal.clone() };
    let mut standing = Standing::Unproven;
    for (goal, proven) in [(goal, Standing::Proven), (&rounded, Standing::ProvenWhenRounded)] {
        match asked(&script.stated(std::slice::from_ref(goal)), limit)? {
            Answer::Proven(_) => return Ok((proven, found)),
            Answer::TimedOut => standing = Standing::TimedOut,
            Answer::Unproven(_) => standing = Standing::Unproven,
        }
    }
    Ok((standing, found))
}

fn enlarged(of: Interval) -> Interval {
    of.enlarged_by(of.magnitude() * ROUNDING)
}

/// What a fact states is not Gappa's to prove.
fn by_fact(question: &Question, name: &str, about: About, outcomes: &mut Vec<Outcome>) {
    let stated = match about {
        About::Range => question.stated.fixed,
        About::Error => Interval::new(-question.stated.error, question.stated.error),
        About::Real => question.stated.real,
    };
    let premises = BTreeSet::from([name.to_owned()]);
    match outcomes.iter_mut().find(|outcome| outcome.about == about) {
        Some(outcome) if outcome.standing == Standing::Fact => outcome.premises.extend(premises),
        Some(_) => {}
        None => outcomes.push(Outcome {
            about,
            stated,
            found: None,
            standing: Standing::Fact,
            premises,
        }),
    }
}
