//! The cheapest formats that a model knows of.
use rayon::prelude::*;

use super::model::{Model, Near};

/// Bits by which the beginnings are finer than the center.
const BEGINNINGS: [i32; 7] = [-3, -2, -1, 0, 1, 2, 3];
/// The most bits by which a format is narrowed at once: a block's width may be as far away.
const MOST_NARROWED: i32 = 3;
/// The most bits by which another one is widened meanwhile.
const MOST_WIDENED: i32 = 2;

impl Model<'_> {
    /// Formats whose bound is expected to be below the goal, the cheapest found from each beginning,
    /// the cheapest of all first; the one with the smallest bound where none is expected to meet the
    /// goal.
    pub fn cheapest(&self, below: f64) -> Vec<Near> {
        let center = self.center();
        let end = |bits| self.descended(self.with_all(&center, bits), below);
        let ends: Vec<Near> = BEGINNINGS.into_par_iter().map(end).collect();
        let mut met: Vec<Near> = ends.iter().filter(|end| end.bound < below).cloned().collect();
        met.sort_by(|a, b| (a.cells, &a.added).cmp(&(b.cells, &b.added)));
        met.dedup_by(|a, b| a.added == b.added);
        if met.is_empty() {
            met.extend(ends.into_iter().min_by(|a, b| a.bound.total_cmp(&b.bound)));
        }
        met
    }

    /// What is widened until it meets the goal, and then made cheaper while it does.
    fn descended(&self, from: Near, below: f64) -> Near {
        let mut near = self.widened(from, below);
        while near.bound < below {
            let change = self.narrowing(&near, below).or_else(|| self.exchange(&near, below));
            let Some(change) = change else { break };
            change.into_iter().for_each(|(point, bits)| self.add(&mut near, point, bits));
        }
        near
    }

    /// The format is widened that lowers the bound most for the cells it takes, bit by bit, until the
    /// bound is below the goal or nothing makes it smaller.
    fn widened(&self, mut near: Near, below: f64) -> Near {
        while near.bound >= below {
            let needed = near.bound - below + 0.001;
            let worth = |point: usize| {
                let change = -self.bound_change(&near, point, 1)?;
                let cells = self.cell_change(&near, point, 1).max(1);
                let worth = change.min(needed) / cells as f64;
                (worth > 0.0).then_some((point, worth))
            };
            let worths = (0..self.points()).filter_map(worth);
            // Of equal ones the first.
            let best = worths.reduce(|best, next| if next.1 > best.1 { next } else { best });
            let Some((point, _)) = best else { break };
            self.add(&mut near, point, 1);
        }
        near
    }

    /// The format to narrow that saves most cells for what it adds to the bound, which stays below
    /// the goal.
    fn narrowing(&self, near: &Near, below: f64) -> Option<Vec<(usize, i32)>> {
        let worth = |(point, bits): (usize, i32)| {
            let bound = self.bound_change(near, point, bits)?;
            let saved = -self.cell_change(near, point, bits);
            let stays = near.bound + bound < below && saved > 0;
            stays.then(|| ((point, bits), saved as f64 / bound.max(1e-9)))
        };
        let worths = self.narrower().filter_map(worth);
        let best = worths.reduce(|best, next| if next.1 > best.1 { next } else { best });
        best.map(|(change, _)| vec![change])
    }

    /// A format to narrow and another one to widen, after which the bound is below the goal, that
    /// save most cells together.
    fn exchange(&self, near: &Near, below: f64) -> Option<Vec<(usize, i32)>> {
        let mut best = (0, None);
        for (narrowed, bits) in self.narrower() {
            if self.bound_change(near, narrowed, bits).is_none() {
                continue;
            }
            let mut next = near.clone();
            self.add(&mut next, narrowed, bits);
            for (widened, more) in (1..=MOST_WIDENED).flat_map(|more| self.each(more)) {
                let stays = self.bound_change(&next, widened, more);
                if widened == narrowed || stays.is_none_or(|change| next.bound + change >= below) {
                    continue;
                }
                let cells = next.cells + self.cell_change(&next, widened, more) - near.cells;
                if cells < best.0 {
                    best = (cells, Some(vec![(narrowed, bits), (widened, more)]));
                }
            }
        }
        best.1
    }

    /// Each point with each number of bits by which it may be narrowed at once.
    fn narrower(&self) -> impl Iterator<Item = (usize, i32)> {
        (1..=MOST_NARROWED).flat_map(|bits| self.each(-bits))
    }

    fn each(&self, bits: i32) -> impl Iterator<Item = (usize, i32)> {
        (0..self.points()).map(move |point| (point, bits))
    }
}
