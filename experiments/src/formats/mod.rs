//! Formats by proof: the cheapest ones found for which the proven bound of a core's quantisation
//! error stays below a goal. No pixel is shaded: a trial elaborates the core, which takes about a
//! millisecond, and asks the bounds pass.
//!
//! What decides the cost is how many multiplier blocks a product takes, which jumps where an operand
//! becomes wider than a block. So the search begins with formats that are all coarser than they may
//! be together and widens the one that lowers the bound most for what it costs, until the goal is
//! met: formats that would cross such a width are widened last. Then each is narrowed, the one first
//! that saves most for what it adds to the bound. It does that from several beginnings and takes the
//! cheapest end. The result meets the goal, and no format of it could be narrower by a bit and save
//! anything; it need not be the cheapest core there is.
mod climb;
mod obstacle;
mod trials;

use rayon::prelude::*;
use specula_scene::Frame;
use specula_spec::CoreSpec;
use specula_testbench::BenchError;

use crate::cost::Cost;
use trials::{Formats, State, Trials};

/// The goal of a faithful core: the proven bound of its quantisation error is below 1 LSB, so each
/// code is one of the two next to the exact value.
pub const FAITHFUL: f64 = 1.0;

/// Bounds come at least so far below the goal, in LSBs, so that one which is printed with three digits
/// is below it too.
pub const MARGIN: f64 = 0.0005;

/// Bits by which the beginnings are finer than the coarsest formats that meet the goal together.
const BEGINNINGS: [i32; 4] = [-3, -2, -1, 0];
/// How many of those that meet the goal are narrowed.
const NARROWED: usize = 2;
/// Bits by which formats are finer than the start's at most, all together.
const MOST_ADDED: i32 = 12;
/// How often the goal of the search is lowered where ranges of inputs that were set up give a larger
/// bound than converted ones.
const MOST_CORRECTIONS: u32 = 6;
/// Bounds with converted ranges of inputs are closer than this to those with ranges that were set
/// up, in LSBs; measured on the built-in scenes, 0.0001.
const CLOSE_BOUND: f64 = 0.001;
/// So are sizes, in cells; measured, 6.
const CLOSE_CELLS: u64 = 32;

/// What formats are asked for.
#[derive(Clone, Debug)]
pub struct Wanted<'a> {
    /// What the proven bound is to be below, in LSBs of the 8-bit output.
    pub below: f64,
    /// Widths of the signed operands of a multiplier block, the wider one first.
    pub block: [u32; 2],
    /// Narrowing points whose formats stay.
    pub kept: &'a [String],
}

/// A core in formats that meet a goal.
#[derive(Clone, Debug)]
pub struct Proven {
    /// The core, for what the start was for.
    pub spec: CoreSpec,
    /// The proven bound of its quantisation error, in LSBs.
    pub bound: f64,
    /// The resources that it takes.
    pub cost: Cost,
    /// Number of cores that were elaborated to find it.
    pub tried: usize,
}

/// The reason why no formats meet a goal.
#[derive(Clone, Debug, PartialEq, thiserror::Error, miette::Diagnostic)]
#[error(
    "no formats that were tried prove `{method}` to quantise by less than {below} LSB; the smallest bound is {reached:.3} LSB, and {obstacle}"
)]
#[diagnostic(
    code(specula::formats),
    help(
        "ask for a larger bound, for other options or for another method; rounding to 8 bits alone takes 0.5 LSB"
    )
)]
pub struct NotProven {
    /// The method.
    pub method: &'static str,
    /// What the bound was to be below, in LSBs.
    pub below: f64,
    /// The smallest bound found, in LSBs.
    pub reached: f64,
    /// What keeps it from being smaller.
    pub obstacle: String,
}

/// `start` in the cheapest formats found whose proven bound is below the goal; a core that is
/// specialised for `frame` stays so.
///
/// # Errors
/// [`NotProven`] with the smallest bound of those tried; [`BenchError`] if a core cannot be built.
pub fn cheapest_formats(
    start: &CoreSpec,
    frame: &Frame,
    wanted: &Wanted,
) -> Result<Result<Proven, NotProven>, BenchError> {
    let search = Search { trials: Trials::new(start, wanted), start, frame, wanted };
    let goal = wanted.below - MARGIN;
    let mut below = goal;
    for _ in 0..=MOST_CORRECTIONS {
        let Some(near) = search.cheapest(below) else { break };
        let exact = search.exactly(&near.formats, start)?;
        if exact.bound < goal {
            return search.trimmed(exact, goal).map(Ok);
        }
        below = below.min(near.tried.bound) - (exact.bound - goal) - 0.001;
    }
    Ok(Err(search.not_proven()))
}

struct Search<'a> {
    trials: Trials<'a>,
    start: &'a CoreSpec,
    frame: &'a Frame,
    wanted: &'a Wanted<'a>,
}

impl Search<'_> {
    /// The cheapest formats found whose bound is below the goal; none if there are none.
    fn cheapest(&self, below: f64) -> Option<State> {
        let level = self.coarsest_together(below);
        let beginnings: Vec<Formats> = match level {
            Some(level) => {
                BEGINNINGS.iter().filter_map(|added| self.trials.finer(level + added)).collect()
            }
            None => self.finest().map(|state| state.formats).into_iter().collect(),
        };
        let widened = beginnings.into_par_iter().filter_map(|formats| {
            let met = self.trials.widened(self.trials.state(formats)?, below);
            (met.tried.bound < below).then_some(met)
        });
        let mut met: Vec<State> = widened.collect();
        let rank = |state: &State| (state.tried.cells, state.formats.clone());
        met.sort_by_key(rank);
        met.dedup();
        met.truncate(NARROWED);
        let ends = met.into_par_iter().map(|state| self.trials.narrowed(state, below));
        ends.min_by_key(rank)
    }

    /// Bits by which all formats are finer than the start's, or coarser if negative, where they are
    /// the coarsest that meet the goal.
    fn coarsest_together(&self, below: f64) -> Option<i32> {
        let meets = |added: &i32| {
            let state = self.trials.finer(*added).and_then(|formats| self.trials.state(formats));
            state.is_some_and(|state| state.tried.bound < below)
        };
        let first = (0..=MOST_ADDED).find(meets)?;
        let coarser = (1 - MOST_ADDED..first).rev().take_while(meets).last();
        Some(coarser.unwrap_or(first))
    }

    /// The smallest bound that finer formats together have.
    fn finest(&self) -> Option<State> {
        let states = (0..=MOST_ADDED)
            .filter_map(|added| self.trials.finer(added).and_then(|f| self.trials.state(f)));
        states.reduce(|best, state| if state.tried.bound < best.tried.bound { state } else { best })
    }

    /// The smallest bound that is found, and what keeps it from being smaller.
    fn not_proven(&self) -> NotProven {
        let finest = self.finest().map(|state| self.trials.widened(state, 0.0));
        NotProven {
            method: self.start.method().name(),
            below: self.wanted.below,
            reached: finest.as_ref().map_or(f64::INFINITY, |state| state.tried.bound),
            obstacle: obstacle::in_words(&self.trials, finest.as_ref()),
        }
    }

    /// A core in these formats, whose inputs are given what they are for the frame; `near` is one
    /// whose spans were set up.
    fn exactly(&self, formats: &[u32], near: &CoreSpec) -> Result<Proven, BenchError> {
        // Formats of a trial can be described.
        let general = self.start.with_fraction_bits(formats).unwrap_or(self.start.general());
        let is_general = self.start.specialisation.is_general();
        let spec = if is_general { general } else { general.specialised_as(near, self.frame) };
        let design = specula_hdl::elaborate(&spec, "core")?;
        let cost = Cost::of(&design, Some(self.wanted.block));
        Ok(Proven { spec, bound: design.error_bound(), cost, tried: self.trials.count() })
    }

    /// Narrows formats as long as that saves anything, with what inputs are given for the frame.
    fn trimmed(&self, mut found: Proven, below: f64) -> Result<Proven, BenchError> {
        while let Some(better) = self.narrower(&found, below)? {
            found = better;
        }
        Ok(Proven { tried: self.trials.count(), ..found })
    }

    /// The core with one format narrower by a bit, where that meets the goal and saves something.
    fn narrower(&self, found: &Proven, below: f64) -> Result<Option<Proven>, BenchError> {
        let neighbours = self.trials.neighbours(&trials::formats_of(&found.spec), -1);
        let may_be_better = |near: &State| {
            near.tried.bound < below + CLOSE_BOUND
                && near.tried.cells < found.cost.cells() + CLOSE_CELLS
        };
        let near = neighbours.into_iter().filter_map(|formats| self.trials.state(formats?));
        for near in near.filter(may_be_better) {
            let exact = self.exactly(&near.formats, &found.spec)?;
            if exact.bound < below && exact.cost.cells() < found.cost.cells() {
                return Ok(Some(exact));
            }
        }
        Ok(None)
    }
}
