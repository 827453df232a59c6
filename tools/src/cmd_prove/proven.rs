//! A core of which Gappa was asked.
use specula_proof::{About, Outcome, Question, Standing};
use specula_spec::Method;

/// A core of which Gappa was asked.
pub struct Proven {
    /// Its method.
    pub method: Method,
    /// Every question, and what came of its goals.
    pub answers: Vec<(Question, Vec<Outcome>)>,
}

impl Proven {
    /// Whether every goal is proven, or stated by a fact that is named.
    pub fn holds(&self) -> bool {
        self.outcomes().all(|(_, outcome)| outcome.standing <= Standing::Fact)
    }

    /// Every goal with its question.
    pub fn outcomes(&self) -> impl Iterator<Item = (&Question, &Outcome)> {
        self.answers.iter().flat_map(|(question, outcomes)| {
            outcomes.iter().map(move |outcome| (question, outcome))
        })
    }

    /// Names of files and the scripts that go into them.
    pub fn scripts(&self) -> Vec<(String, String)> {
        let mut scripts = vec![];
        for (number, (question, outcomes)) in self.answers.iter().enumerate() {
            let stated = |about: About| {
                outcomes
                    .iter()
                    .any(|outcome| outcome.about == about && outcome.standing == Standing::Proven)
            };
            let cases = question.alternatives.iter().flat_map(|alternative| &alternative.cases);
            for (case, script) in cases.enumerate() {
                let goals: Vec<_> =
                    script.goals.iter().filter(|goal| stated(goal.about)).cloned().collect();
                if !goals.is_empty() {
                    let signal: String = question.signal.chars().map(plain).collect();
                    let name = format!("{}_{number:03}_{signal}_{case}.g", self.method.name());
                    let title = format!("# {}: {}\n", question.path, question.signal);
                    scripts.push((name, title + &script.stated(&goals)));
                }
            }
        }
        scripts
    }
}

fn plain(c: char) -> char {
    if c.is_ascii_alphanumeric() { c } else { '_' }
}
