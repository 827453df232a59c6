//! A script: names, definitions, hypotheses and goals.
use std::collections::{BTreeSet, HashMap};
use std::fmt::Write;

use specula_datapath::bound::Interval;
use specula_datapath::design::{NodeId, ScopeId};
use specula_datapath::graph::{Graph, RealId};
use specula_datapath::pass::Bounds;

use super::{About, Detail, Goal, number};

/// What Gappa is given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Script {
    /// What it is about, as comments.
    pub comments: Vec<String>,
    definitions: Vec<String>,
    hypotheses: Vec<String>,
    hints: Vec<String>,
    /// What is to be proven.
    pub goals: Vec<Goal>,
}

impl Script {
    /// The script in which these goals are to be proven as they are stated.
    pub fn stated(&self, goals: &[Goal]) -> String {
        let goal = |goal: &Goal| format!("{} in {}", goal.expression, interval(goal.stated));
        self.with_goals(goals.iter().map(goal))
    }

    /// The script in which Gappa says by itself where the expressions of these goals lie.
    pub fn open(&self, goals: &[Goal]) -> String {
        self.with_goals(goals.iter().map(|goal| format!("{} in ?", goal.expression)))
    }

    /// Whether anything is supposed in it.
    pub fn has_hypotheses(&self) -> bool {
        !self.hypotheses.is_empty()
    }

    fn with_goals(&self, goals: impl Iterator<Item = String>) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        for comment in &self.comments {
            let _ = writeln!(text, "# {comment}");
        }
        for definition in &self.definitions {
            let _ = writeln!(text, "{definition};");
        }
        let goals = goals.collect::<Vec<_>>().join(" /\\\n    ");
        match self.hypotheses.join(" /\\\n  ") {
            none if none.is_empty() => {
                let _ = writeln!(text, "{{ {goals} }}");
            }
            hypotheses => {
                let _ = writeln!(text, "{{ {hypotheses}\n  -> {goals} }}");
            }
        }
        for hint in &self.hints {
            let _ = writeln!(text, "{hint};");
        }
        text
    }
}

/// An interval as Gappa reads it.
pub fn interval(of: Interval) -> String {
    format!("[{}, {}]", number::of(of.low), number::of(of.high))
}

/// A script that is being written, for a question about a unit.
pub struct Writer<'a> {
    pub graph: &'a Graph,
    pub bounds: &'a Bounds,
    pub detail: Detail,
    /// The unit.
    pub scope: ScopeId,
    /// The real value that the question is about.
    pub goal: RealId,
    /// Names of facts that are hypotheses.
    pub premises: BTreeSet<String>,
    pub fixed: HashMap<NodeId, String>,
    pub reals: HashMap<RealId, String>,
    names: BTreeSet<String>,
    script: Script,
}

impl<'a> Writer<'a> {
    pub fn new(graph: &'a Graph, bounds: &'a Bounds, goal: RealId, detail: Detail) -> Writer<'a> {
        Writer {
            graph,
            bounds,
            detail,
            scope: graph.value(graph.real(goal).value).scope,
            goal,
            premises: BTreeSet::new(),
            fixed: HashMap::new(),
            reals: HashMap::new(),
            names: BTreeSet::new(),
            script: Script::default(),
        }
    }

    /// A name for a number of one kind, unique in the script.
    pub fn name(&mut self, kind: char, name: &str) -> String {
        let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let name = format!("{kind}_{}", name.chars().map(plain).collect::<String>());
        let mut unique = name.clone();
        let mut number = 2;
        while !self.names.insert(unique.clone()) {
            unique = format!("{name}_{number}");
            number += 1;
        }
        unique
    }

    /// Gives an expression a name; what is a name or a number already keeps it.
    pub fn define(&mut self, kind: char, name: &str, expression: String) -> String {
        if is_atom(&expression) {
            return expression;
        }
        let name = self.name(kind, name);
        self.script.definitions.push(format!("{name} = {expression}"));
        name
    }

    /// The goal with a name for its expression, under which Gappa prints what it finds.
    pub fn named_goal(&mut self, goal: Goal) -> Goal {
        if is_atom(&goal.expression) && !is_literal(&goal.expression) {
            return goal;
        }
        let name = self.name('G', goal.about.word());
        self.script.definitions.push(format!("{name} = {}", goal.expression));
        Goal { expression: name, ..goal }
    }

    /// Whether an expression is one that the script computes, and not one that it is given.
    pub fn is_defined(&self, expression: &str) -> bool {
        let begins = format!("{expression} = ");
        let is_given = self.names.contains(expression)
            && !self.script.definitions.iter().any(|line| line.starts_with(&begins));
        !is_given
    }

    pub fn suppose(&mut self, hypothesis: String) {
        if !self.script.hypotheses.contains(&hypothesis) {
            self.script.hypotheses.push(hypothesis);
        }
    }

    /// A way to write an expression that Gappa is to try.
    pub fn hint(&mut self, from: &str, to: &str) {
        self.script.hints.push(format!("{from} -> {to}"));
    }

    /// The script with these goals; one about the real value is a script of its own, with the others as
    /// hypotheses.
    pub fn finish(self, goals: Vec<Goal>) -> Vec<Script> {
        let (real, others): (Vec<Goal>, Vec<Goal>) =
            goals.into_iter().partition(|goal| goal.about == About::Real);
        let mut scripts = vec![];
        if !real.is_empty() {
            let mut script = Script { goals: real, ..self.script.clone() };
            let stated = |goal: &Goal| format!("{} in {}", goal.expression, interval(goal.stated));
            script.hypotheses.extend(others.iter().map(stated));
            scripts.push(script);
        }
        if !others.is_empty() {
            scripts.push(Script { goals: others, ..self.script });
        }
        scripts
    }
}

/// Whether an expression is a name or a number: operators have blanks around them.
fn is_atom(expression: &str) -> bool {
    !expression.contains([' ', '<'])
}

/// Whether an expression is a number.
pub fn is_literal(expression: &str) -> bool {
    is_atom(expression) && !expression.starts_with(|c: char| c.is_ascii_alphabetic())
}

/// A number as a part of an expression.
pub fn literal(number: String) -> String {
    if number.starts_with('-') { format!("({number})") } else { number }
}
