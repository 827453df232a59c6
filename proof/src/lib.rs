//! What another program is to prove: questions about a graph's bounds, as Gappa reads them.
//!
//! The [pass](fn@specula_datapath::pass::bounds) bounds errors by rules of its own. Here the same is asked of a
//! program that knows neither the pass nor its rules: [Gappa, Daumas and Melquiond, ACM TOMS 37(1),
//! 2010]. A question is about one real value of one unit and has scripts:
//!
//! - F, the fixed-point value, is what the *operators* of the graph compute: products and sums, and
//!   for a narrowing `fixed<-k,nu>` (nearest, ties up) or `fixed<-k,dn>` (down).
//! - R, the real value, is what the *formula* says: products and sums of real values.
//! - Hypotheses are the ranges of what enters the unit and |F - R| of it, and *facts* by their names.
//! - Goals are the range of F, the bound on |F - R| and the interval of R that the pass states.
//!
//! What is stated of a value inside a unit is a hypothesis only where a choice, a loop or a table
//! parts the unit; it is then the goal of a question of its own.
//! Clamps and choices are cases, a script for each.
mod answer;
mod cases;
mod error;
mod fixed;
pub mod gappa;
mod number;
mod real;
mod script;
mod select;

use std::collections::BTreeSet;
use std::time::Duration;

use rayon::prelude::*;

use specula_datapath::bound::{Bound, Interval};
use specula_datapath::graph::{Graph, RealId};
use specula_datapath::pass::{Bounds, bounds};

pub use answer::{Outcome, ROUNDING, Standing, answered};
pub use error::ProofError;
pub use script::Script;

use cases::alternatives;

/// Where a question's derivation is parted besides what has to part it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Detail {
    /// Nowhere: a narrowing is derived from what enters the unit.
    Unit,
    /// At each narrowing, which is the goal of a question of its own.
    Narrowings,
}

/// What is asked of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum About {
    /// Where the fixed-point value lies.
    Range,
    /// |fixed - real|.
    Error,
    /// Where the real value lies.
    Real,
}

impl About {
    /// A word for it.
    pub fn word(self) -> &'static str {
        match self {
            About::Range => "range",
            About::Error => "error",
            About::Real => "real",
        }
    }
}

/// An expression of a script, and where the pass says that it lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Goal {
    /// What it is about.
    pub about: About,
    /// The expression.
    pub expression: String,
    /// Where it lies.
    pub stated: Interval,
}

/// A fact that is stated of the very value that a question is about.
#[derive(Clone, Debug, PartialEq)]
pub struct Fact {
    /// Its name, or where its proof stands.
    pub name: String,
    /// What it is about.
    pub about: About,
}

/// Scripts that together answer a question.
#[derive(Clone, Debug, PartialEq)]
pub struct Alternative {
    /// Names of the facts that are hypotheses of a script.
    pub premises: BTreeSet<String>,
    /// One for each case; all of them have to be proven.
    pub cases: Vec<Script>,
}

/// A value of which the pass states something.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// The value.
    pub real: RealId,
    /// The unit that computes it, from the design down.
    pub path: String,
    /// The kind of that unit.
    pub unit: String,
    /// The value's name.
    pub signal: String,
    /// What the pass states.
    pub stated: Bound,
    /// The fact that is stated of it, if one is.
    pub fact: Option<Fact>,
    /// Ways to prove it, of which one is enough; none where there is nothing for Gappa to see.
    pub alternatives: Vec<Alternative>,
}

/// Asks Gappa everything that there is to ask about a graph, at most so long for a goal.
///
/// # Errors
/// [`ProofError`] if Gappa cannot be run.
pub fn prove(graph: &Graph, limit: Duration) -> Result<Vec<(Question, Vec<Outcome>)>, ProofError> {
    let [whole, finer] = [Detail::Unit, Detail::Narrowings].map(|detail| questions(graph, detail));
    let pairs: Vec<(Question, Question)> = whole.into_iter().zip(finer).collect();
    let ask = |(question, finer): (Question, Question)| {
        let outcomes = answered(&question, &finer, limit)?;
        Ok((question, outcomes))
    };
    pairs.into_par_iter().map(ask).collect()
}

/// The questions about a graph, in the order of its real values.
pub fn questions(graph: &Graph, detail: Detail) -> Vec<Question> {
    let bounds = bounds(graph);
    let asked = select::asked(graph).into_iter();
    let all = asked.map(|(real, is_used)| {
        let question = question(graph, &bounds, real, detail);
        if is_used { question } else { question.about_range() }
    });
    all.filter(|question| question.fact.is_some() || !question.alternatives.is_empty()).collect()
}

impl Question {
    /// The part of it that is about the range.
    fn about_range(self) -> Question {
        let is_range = |about: About| about == About::Range;
        let alternatives = self.alternatives.into_iter().filter_map(Alternative::about_range);
        let fact = self.fact.filter(|fact| is_range(fact.about));
        Question { alternatives: alternatives.collect(), fact, ..self }
    }
}

impl Alternative {
    fn about_range(mut self) -> Option<Alternative> {
        for script in &mut self.cases {
            script.goals.retain(|goal| goal.about == About::Range);
        }
        self.cases.retain(|script| !script.goals.is_empty());
        (!self.cases.is_empty()).then_some(self)
    }
}

fn question(graph: &Graph, bounds: &Bounds, id: RealId, detail: Detail) -> Question {
    let value = graph.value(graph.real(id).value);
    let signal = match value.op.constant() {
        Some(constant) => format!("constant {constant}"),
        None => value.name.clone(),
    };
    Question {
        real: id,
        path: graph.path(value.scope).join("."),
        unit: graph.unit(value.scope).name.clone(),
        signal,
        stated: bounds.of(id),
        fact: select::fact(graph, id),
        alternatives: alternatives(graph, bounds, id, detail),
    }
}
