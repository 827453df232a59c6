//! Formats that are changed bit by bit, the most worthwhile change first.
//!
//! A change that was tried is expected to be worth about the same after others, so only the one that
//! seems best is tried again before it is made.
use rayon::prelude::*;

use super::trials::{Formats, State, Trials};

/// What a bit more or less at a narrowing point changes.
#[derive(Clone, Copy, Debug)]
struct Change {
    /// The change of the bound, in LSBs.
    bound: f64,
    /// The change of the size, in cells.
    cells: f64,
}

impl Change {
    fn between(before: &State, after: &State) -> Change {
        Change {
            bound: after.tried.bound - before.tried.bound,
            // Cells are far below 2^53.
            cells: after.tried.cells as f64 - before.tried.cells as f64,
        }
    }
}

/// The expected change of each narrowing point; none where there is none to expect.
type Expected = Vec<Option<Change>>;

impl Trials<'_> {
    /// The formats made finer until the bound is below the goal, or nothing makes it smaller.
    pub fn widened(&self, from: State, below: f64) -> State {
        let worth = |state: &State, change: Change| {
            let needed = state.tried.bound - below + 0.001;
            (-change.bound).min(needed) / change.cells.max(1.0)
        };
        let mut state = from;
        let mut expected = self.expected(&state, 1);
        while state.tried.bound >= below {
            let Some((point, next)) = self.best(&state, 1, &mut expected, &worth) else { break };
            state = next;
            // An error halves with each bit.
            if let Some(change) = &mut expected[point] {
                change.bound /= 2.0;
            }
        }
        state
    }

    /// The formats made coarser as long as that is expected to save anything and the bound stays
    /// below the goal.
    pub fn narrowed(&self, from: State, below: f64) -> State {
        let worth = |state: &State, change: Change| {
            let stays = state.tried.bound + change.bound < below;
            if stays { -change.cells / change.bound.max(1e-9) } else { 0.0 }
        };
        let mut state = from;
        let mut expected = self.expected(&state, -1);
        while let Some((point, next)) = self.best(&state, -1, &mut expected, &worth) {
            state = next;
            if let Some(change) = &mut expected[point] {
                change.bound *= 2.0;
            }
        }
        state
    }

    fn expected(&self, state: &State, added: i32) -> Expected {
        let change = |formats: Option<Formats>| {
            let after = self.state(formats?)?;
            Some(Change::between(state, &after))
        };
        self.neighbours(&state.formats, added).into_par_iter().map(change).collect()
    }

    /// The change that is worth most, if one is worth anything.
    fn best(
        &self,
        state: &State,
        added: i32,
        expected: &mut Expected,
        worth: &impl Fn(&State, Change) -> f64,
    ) -> Option<(usize, State)> {
        let mut sure = vec![false; expected.len()];
        loop {
            let worths = expected.iter().enumerate().filter_map(|(point, change)| {
                let worth = worth(state, (*change)?);
                (worth > 0.0).then_some((point, worth))
            });
            // Of equal ones the first.
            let (point, _) =
                worths.reduce(|best, next| if next.1 > best.1 { next } else { best })?;
            let formats = self.neighbour(&state.formats, point, added);
            let after = formats.and_then(|formats| self.state(formats));
            match after {
                Some(after) if sure[point] => return Some((point, after)),
                Some(after) => expected[point] = Some(Change::between(state, &after)),
                None => expected[point] = None,
            }
            sure[point] = true;
        }
    }
}
