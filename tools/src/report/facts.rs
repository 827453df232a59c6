//! The facts that a core rests on: the limits within which its signals must lie, and the values
//! seen.
use serde::Serialize;
use specula_datapath::Design;
use specula_datapath::design::{Assumption, Range};
use specula_spec::Format;
use specula_testbench::Outcome;

/// A fact in all units of one kind.
#[derive(Serialize)]
pub struct Fact {
    /// The fact, as the units state it.
    fact: String,
    /// Full name of the first signal.
    signal: String,
    /// Number of signals for which it was checked.
    signals: usize,
    /// The limits within which they must lie.
    limits: [f64; 2],
    /// The smallest and the largest value that any of them had; `None` if no pixel came.
    seen: Option<[f64; 2]>,
}

/// Groups the same fact in units of the same kind; it may concern several signals.
struct Kind<'a> {
    first: &'a Assumption,
    signals: usize,
    seen: Option<Range>,
}

/// Every fact, with equal facts in units of the same kind grouped.
pub fn facts(design: &Design, outcome: &Outcome) -> Vec<Fact> {
    let mut kinds: Vec<Kind> = vec![];
    for (assumption, &seen) in design.assumptions.iter().zip(&outcome.facts_seen) {
        match kinds.iter_mut().find(|kind| is_same(design, kind.first, assumption)) {
            Some(kind) => {
                kind.signals += 1;
                kind.seen = [kind.seen, seen].into_iter().flatten().reduce(Range::hull);
            }
            None => kinds.push(Kind { first: assumption, signals: 1, seen }),
        }
    }
    kinds.into_iter().map(|kind| fact(design, &kind)).collect()
}

fn is_same(design: &Design, one: &Assumption, other: &Assumption) -> bool {
    let unit = |assumption: &Assumption| &design.scope(design.node(assumption.node).scope).unit;
    let format = |assumption: &Assumption| design.node(assumption.node).fraction_bits;
    one.fact == other.fact
        && one.range == other.range
        && unit(one) == unit(other)
        && format(one) == format(other)
}

fn fact(design: &Design, kind: &Kind) -> Fact {
    let values =
        |range: Range, format: Format| [range.low, range.high].map(|raw| format.value(raw));
    let format = design.node(kind.first.node).format();
    Fact {
        fact: kind.first.fact.clone(),
        signal: design.full_name(kind.first.node),
        signals: kind.signals,
        limits: values(kind.first.range, format),
        seen: kind.seen.map(|seen| values(seen, format)),
    }
}

impl Fact {
    /// The row of a table: the fact, its signals, their limits, and the values seen.
    pub fn row(&self) -> [String; 4] {
        let others = if self.signals == 1 {
            String::new()
        } else {
            format!(" and {} more", self.signals - 1)
        };
        let between = |[low, high]: [f64; 2]| format!("{low:.6} to {high:.6}");
        let seen = self.seen.map_or("no pixel".to_owned(), between);
        [self.fact.clone(), format!("`{}`{others}", self.signal), between(self.limits), seen]
    }
}
