//! Makes a failing run small: tries to take away a piece, and keeps what still fails.
mod rebuild;
mod reduce;

pub use rebuild::without_unused;

use std::time::{Duration, Instant};

use crate::netlists::case::Case;
use crate::netlists::check::{self, Failure};

/// How long it is worth trying.
const PATIENCE: Duration = Duration::from_secs(20);

/// A smaller run that fails as well.
pub fn minimised(case: Case) -> Case {
    let begin = Instant::now();
    let Some(kind) = kind(&case) else { return case };
    let mut best = case;
    loop {
        let before = size(&best);
        for reduction in reduce::ALL {
            best = pass(best, reduction, &kind, begin);
        }
        if size(&best) >= before || begin.elapsed() > PATIENCE {
            return best;
        }
    }
}

/// What is wrong with a run, numbers aside: a run that fails in another way is another failure.
fn kind(case: &Case) -> Option<String> {
    Some(match check::failure(case)? {
        Failure::Panic(message) => message.chars().filter(|c| !c.is_ascii_digit()).collect(),
        Failure::Error(message) => message,
        Failure::Clocks { .. } => "clocks".to_owned(),
        Failure::Value { .. } => "value".to_owned(),
    })
}

/// Applies a reduction at each place, from the last to the first, as long as the run still fails.
fn pass(mut best: Case, reduction: &reduce::Reduction, wanted: &str, begin: Instant) -> Case {
    let mut place = (reduction.places)(&best);
    while place > 0 && begin.elapsed() <= PATIENCE {
        place -= 1;
        let Some(candidate) = (reduction.at)(&best, place) else { continue };
        if kind(&candidate).is_some_and(|kind| kind == wanted) {
            best = candidate;
            place = place.min((reduction.places)(&best));
        }
    }
    best
}

/// What is to become small: signals first, then operators, then the stimulus.
fn size(case: &Case) -> (usize, usize, usize, u64) {
    let design = &case.design;
    let operators = design
        .nodes
        .iter()
        .map(|n| 1 + n.op.operands().count() + usize::from(n.registered()))
        .sum();
    let values: u64 = case
        .packets
        .iter()
        .map(|p| u64::from(p.length) + p.inputs.iter().filter(|&&v| v != 0).count() as u64)
        .sum();
    (
        design.nodes.len() + case.watched.len() + design.scopes.len(),
        operators,
        case.packets.len(),
        values,
    )
}
