//! Formats by proof: the cheapest ones found for which the proven bound of a core's quantisation
//! error stays below a goal. No pixel is shaded: a trial describes the core, which takes some
//! hundred microseconds, asks the bounds pass, and counts what the core would be made of.
//!
//! What decides the cost is how many multiplier blocks a product takes, which jumps where an operand
//! becomes wider than a block. Trying formats one after the other finds such jumps late and takes
//! hundreds of trials. So each point is tried once, a bit finer; what that changes is a *model* of
//! the bound and of each operand's width nearby; and the search goes through thousands of formats by
//! the model. Where it leads to is tried, a model is made there, and so on until nothing better is
//! found. The result meets the goal, and no format of it could be narrower by a bit and save
//! anything; it need not be the cheapest core there is.
mod default_core;
mod descent;
mod model;
mod obstacle;
mod of_sequence;
mod products;
mod trials;

use rayon::prelude::*;
use specula_spec::{CoreSpec, Frames};
use specula_testbench::BenchError;

pub use default_core::{DefaultCore, NotFaithful, default_core};
use model::Model;
pub use of_sequence::{SequenceError, core_of_sequence};
pub use products::Products;
use trials::{State, Trials, Tried};

/// The goal of a faithful core: the proven bound of its quantisation error is below 1 LSB, so each
/// code is one of the two next to the exact value.
pub const FAITHFUL: f64 = 1.0;

/// Bounds come at least so far below the goal, in LSBs, so that one which is printed with three digits
/// is below it too.
pub const MARGIN: f64 = 0.0005;

/// How often a model is made anew around the best formats found.
const MOST_MODELS: usize = 8;
/// How often a model is asked again for a closer goal, where what it expected to meet the goal does
/// not.
const MOST_MODEL_GOALS: usize = 3;
/// How many of the formats that a model leads to are tried.
const MOST_ENDS: usize = 4;
/// A bound that is smaller by less is no gain, in LSBs.
const LEAST_GAIN: f64 = 0.0005;
/// Bits by which formats are finer than the start's at most, all together.
const MOST_ADDED: i32 = 12;
/// How often the goal of the search is lowered where ranges of inputs that were set up give a larger
/// bound than converted ones.
const MOST_CORRECTIONS: u32 = 6;
/// Bounds with converted ranges of inputs are closer than this to those with ranges that were set
/// up, in LSBs; measured on the built-in scenes, 0.0001.
const CLOSE_BOUND: f64 = 0.001;
/// So are sizes, in cells; measured, 6.
const CLOSE_CELLS: i64 = 32;

/// What formats are asked for.
#[derive(Clone, Debug)]
pub struct Wanted<'a> {
    /// What the proven bound is to be below, in LSBs of the 8-bit output.
    pub below: f64,
    /// How its products are made.
    pub products: Products,
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
    /// The resources that it takes, as one number.
    pub cells: i64,
    /// Number of cores that were tried to find it.
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
/// specialised for a frame or several stays so.
///
/// # Errors
/// [`NotProven`] with the smallest bound of those tried; [`BenchError`] if a core cannot be built.
pub fn cheapest_formats<'a>(
    start: &CoreSpec,
    frames: impl Into<Frames<'a>>,
    wanted: &Wanted,
) -> Result<Result<Proven, NotProven>, BenchError> {
    let start = &start.in_search_formats(wanted.kept);
    let search =
        Search { trials: Trials::new(start, wanted), start, frames: frames.into(), wanted };
    let goal = wanted.below - MARGIN;
    let mut below = goal;
    let mut at = search.beginning();
    for _ in 0..=MOST_CORRECTIONS {
        let near = at.take().and_then(|from| search.meeting(from, below));
        let Some(near) = near else { break };
        let exact = search.exactly(&near.formats, start)?;
        if exact.tried.bound < goal {
            let Exact { spec, tried } = search.trimmed(exact, goal)?;
            return Ok(Ok(Proven {
                spec,
                bound: tried.bound,
                cells: tried.cells,
                tried: search.trials.count(),
            }));
        }
        below = below.min(near.tried.bound) - (exact.tried.bound - goal) - 0.001;
        at = Some(near);
    }
    Ok(Err(search.not_proven()))
}

struct Search<'a> {
    trials: Trials<'a>,
    start: &'a CoreSpec,
    frames: Frames<'a>,
    wanted: &'a Wanted<'a>,
}

/// A core whose inputs are given what they are for the frame.
struct Exact {
    spec: CoreSpec,
    tried: Tried,
}

impl Search<'_> {
    /// The cheapest formats found whose bound is below the goal; none if there are none. Where
    /// models lead to none, all formats are made finer together until the goal is met.
    fn meeting(&self, from: State, below: f64) -> Option<State> {
        let meets = |state: &State| state.tried.bound < below;
        let near = self.cheapest(from, below);
        if meets(&near) {
            return Some(near);
        }
        let mut finer =
            (1..=MOST_ADDED).filter_map(|added| self.trials.state(self.trials.finer(added)?));
        Some(self.cheapest(finer.find(meets)?, below))
    }

    /// The cheapest formats found whose bound is below the goal; else those with the smallest bound
    /// that is found.
    fn cheapest(&self, from: State, below: f64) -> State {
        let mut center = from;
        for _ in 0..MOST_MODELS {
            let model = Model::around(&self.trials, center.clone());
            let next = self.near(&model, below);
            match next {
                Some(next) if is_better(&next, &center, below) => center = next,
                _ => break,
            }
        }
        center
    }

    /// The best formats that a model leads to.
    fn near(&self, model: &Model, below: f64) -> Option<State> {
        let mut expected_below = below;
        let mut found: Option<State> = None;
        for _ in 0..MOST_MODEL_GOALS {
            let ends = model.cheapest(expected_below);
            let states = ends
                .par_iter()
                .take(MOST_ENDS)
                .filter_map(|near| self.trials.state(self.trials.allowed(model.formats(near))?));
            let best = states
                .collect::<Vec<State>>()
                .into_iter()
                .reduce(|best, next| if is_better(&next, &best, below) { next } else { best })?;
            if found.as_ref().is_none_or(|found| is_better(&best, found, below)) {
                found = Some(best.clone());
            }
            if best.tried.bound < below {
                break;
            }
            expected_below -= best.tried.bound - below + 0.001;
        }
        found
    }

    /// A core to begin with: the start, or the one nearest to it that can be built.
    fn beginning(&self) -> Option<State> {
        let levels = (0..=MOST_ADDED).flat_map(|added| [added, -added]);
        levels.filter_map(|added| self.trials.state(self.trials.finer(added)?)).next()
    }

    /// The smallest bound that is found, and what keeps it from being smaller.
    fn not_proven(&self) -> NotProven {
        let states =
            (0..=MOST_ADDED).filter_map(|added| self.trials.state(self.trials.finer(added)?));
        let finest =
            states.reduce(|best, next| if is_better(&next, &best, 0.0) { next } else { best });
        let finest = finest.map(|state| self.cheapest(state, 0.0));
        NotProven {
            method: self.start.method().name(),
            below: self.wanted.below,
            reached: finest.as_ref().map_or(f64::INFINITY, |state| state.tried.bound),
            obstacle: obstacle::in_words(self.start, self.wanted, finest),
        }
    }

    /// A core in these formats; `near` is one whose spans were set up.
    fn exactly(&self, formats: &[u32], near: &CoreSpec) -> Result<Exact, BenchError> {
        // Formats of a trial can be described.
        let general = self.start.with_fraction_bits(formats).unwrap_or(self.start.general());
        let is_general = self.start.specialisation.is_general();
        let spec = if is_general { general } else { general.specialised_as(near, self.frames) };
        Ok(Exact { tried: self.trials.appraised(&spec)?, spec })
    }

    /// Narrows formats as long as that saves anything, with what inputs are given for the frame.
    fn trimmed(&self, mut found: Exact, below: f64) -> Result<Exact, BenchError> {
        while let Some(better) = self.narrower(&found, below)? {
            found = better;
        }
        Ok(found)
    }

    /// The core with one format narrower by a bit, where that meets the goal and saves something.
    fn narrower(&self, found: &Exact, below: f64) -> Result<Option<Exact>, BenchError> {
        let formats = trials::formats_of(&found.spec);
        let here = self.trials.state(formats.clone()).map(|here| here.tried);
        let narrower = (0..formats.len())
            .into_par_iter()
            .filter_map(|point| self.trials.state(self.trials.neighbour(&formats, point, -1)?));
        // Spans are set up for those alone that may be better; where nothing changes, none is.
        let may_be_better = |near: &State| {
            near.tried.bound < below + CLOSE_BOUND
                && near.tried.cells < found.tried.cells + CLOSE_CELLS
                && here.as_ref() != Some(&near.tried)
        };
        let mut near: Vec<State> = narrower.filter(may_be_better).collect();
        near.sort_by_key(|near| near.tried.cells);
        for near in near {
            let exact = self.exactly(&near.formats, &found.spec)?;
            if exact.tried.bound < below && exact.tried.cells < found.tried.cells {
                return Ok(Some(exact));
            }
        }
        Ok(None)
    }
}

/// Whether a core is better than another: one that meets the goal is better than one that does not,
/// and else the cheaper one is, or, where none meets it, the one with the smaller bound.
fn is_better(next: &State, than: &State, below: f64) -> bool {
    match (next.tried.bound < below, than.tried.bound < below) {
        (true, true) => next.tried.cells < than.tried.cells,
        (false, false) => next.tried.bound < than.tried.bound - LEAST_GAIN,
        (meets, _) => meets,
    }
}
