//! One climber: it starts from random scenes again and again until it has tried as many scenes as
//! it may.
use specula_spec::Method;

use super::genome::Genome;
use super::measure::{Bound, Measure, Unmeasured, measure};
use super::mutation::Mutation;
use super::random::{self, Formats};
use crate::stress::draw::Draw;

/// A bound of full scale, in LSBs, which says nothing.
pub const NO_BOUND: f64 = 255.0;
/// Number of random scenes, from the best of which an ascent begins.
const BEGINNINGS: u64 = 6;
/// Number of consecutive scenes without improvement after which an ascent ends.
const PATIENCE: u64 = 60;
/// Smallest rise that counts as an improvement.
const RISE: f64 = 1e-4;
/// Largest error in LSBs of the rounding to 8 bits alone.
const ROUNDING_ERROR: f64 = 0.5;
/// Slacks, which are added to bounds, in LSBs; an ascent uses one of them. With a small slack,
/// errors of fine formats count as much as those of coarse ones, and roundings of colours to 2^-7
/// LSB lead to a ratio of 1; with a large one, only large errors count.
const SLACKS: [f64; 3] = [0.002, 0.03, 0.3];
/// Limits in LSBs; an ascent uses one of them and avoids scenes with larger bounds: where formats
/// are so coarse that the bound is all that a code can be off, the bound is reached easily.
const MAX_BOUNDS: [f64; 3] = [2.0, 16.0, NO_BOUND];
/// The ratio of a sum's error to its proven bound counts only up to this limit: where the bound
/// rests on the possible codes, the ratio may exceed 1.
const HIGHEST: f64 = 1.5;
/// Number of ambient lights that are tried to make an error visible in codes.
const AMBIENTS: u64 = 24;

/// A scene and its measurement.
#[derive(Clone, Debug)]
pub struct Found {
    /// The scene and its core.
    pub genome: Genome,
    /// The measurement.
    pub measure: Measure,
}

/// What a climber found.
#[derive(Clone, Debug, Default)]
pub struct Ascent {
    /// Number of scenes tried.
    pub scenes: u64,
    /// Number of these for which there is no core.
    pub refused: u64,
    /// Number of these whose bound is full scale or more.
    pub without_bound: u64,
    /// The scene with the largest ratio of measured error to bound.
    pub largest: Option<Found>,
    /// Number of the first scene with a ratio above 1.
    pub first_broken: Option<u64>,
    /// The first scene in which something else is wrong, and what is wrong.
    pub fault: Option<(Genome, String)>,
}

impl Ascent {
    /// Climbs with `method` until `scenes` scenes have been tried; `count` is called for each.
    pub fn new(
        draw: &mut Draw,
        method: Method,
        scenes: u64,
        bound: &Bound,
        count: &(dyn Fn() + Sync),
    ) -> Ascent {
        let mut climber =
            Climber { draw, method, most: scenes, bound, count, ascent: Ascent::default() };
        while !climber.is_tired() {
            climber.climb();
        }
        climber.ascent
    }
}

struct Climber<'a> {
    draw: &'a mut Draw,
    method: Method,
    most: u64,
    bound: &'a Bound,
    count: &'a (dyn Fn() + Sync),
    ascent: Ascent,
}

impl Climber<'_> {
    fn is_tired(&self) -> bool {
        self.ascent.scenes >= self.most
    }

    /// Climbs from the best of some random scenes until nothing improves.
    fn climb(&mut self) {
        let taste = RankCriterion {
            slack: self.draw.one_of(&SLACKS),
            most_bound: self.draw.one_of(&MAX_BOUNDS),
        };
        let height = |measure: &Measure| taste.height(measure);
        let formats = Formats::draw(self.draw);
        let Some((mut genome, mut measure)) = self.beginning(&height, formats) else { return };
        let mutation = match formats {
            Formats::Any => Mutation::new(self.draw),
            Formats::OneCoarse(_) => Mutation::without_formats(self.draw),
        };
        let mut idle = 0;
        while idle < PATIENCE && !self.is_tired() {
            idle += 1;
            let changed = mutation.apply(&genome, self.draw);
            let Some((next, of_next)) = self.tried(changed) else { continue };
            if height(&of_next) > height(&measure) * (1.0 + RISE) {
                idle = 0;
            }
            if height(&of_next) >= height(&measure) {
                (genome, measure) = (next, of_next);
            }
        }
        if measure.ratio() <= 1.0
            && measure.unrounded > measure.bound - ROUNDING_ERROR
            && measure.bound < NO_BOUND
        {
            self.show(&genome);
        }
    }

    fn beginning(
        &mut self,
        height: &dyn Fn(&Measure) -> f64,
        formats: Formats,
    ) -> Option<(Genome, Measure)> {
        let mut best: Option<(Genome, Measure)> = None;
        for _ in 0..BEGINNINGS {
            if self.is_tired() {
                break;
            }
            let drawn = random::genome(self.draw, self.method, formats);
            let Some(next) = self.tried(drawn) else { continue };
            if best.as_ref().is_none_or(|(_, measure)| height(&next.1) > height(measure)) {
                best = Some(next);
            }
        }
        best
    }

    /// If the error of a sum exceeds its proven bound, tries ambient lights that carry it across
    /// the middle between two codes.
    fn show(&mut self, genome: &Genome) {
        for _ in 0..AMBIENTS {
            if self.is_tired() {
                break;
            }
            let mut lit = genome.clone();
            lit.scene.ambient = [self.draw.unit(); 3];
            lit.scene.spans.iter_mut().for_each(|span| span.material.ambient = [1.0; 3]);
            self.tried(lit.repaired());
        }
    }

    /// Measures a scene and records the result; `None` if there is no core.
    fn tried(&mut self, genome: Option<Genome>) -> Option<(Genome, Measure)> {
        self.ascent.scenes += 1;
        (self.count)();
        let measured = genome.map(|genome| (measure(genome.text(), self.bound), genome));
        match measured {
            Some((Ok(measure), genome)) => {
                self.note(&genome, measure);
                Some((genome, measure))
            }
            Some((Err(Unmeasured::Fault(what)), genome)) => {
                self.ascent.fault.get_or_insert((genome, what));
                None
            }
            Some((Err(Unmeasured::Refused), _)) | None => {
                self.ascent.refused += 1;
                None
            }
        }
    }

    fn note(&mut self, genome: &Genome, measure: Measure) {
        if measure.bound >= NO_BOUND {
            self.ascent.without_bound += 1;
            return;
        }
        if measure.ratio() > 1.0 {
            self.ascent.first_broken.get_or_insert(self.ascent.scenes);
        }
        if self
            .ascent
            .largest
            .as_ref()
            .is_none_or(|largest| measure.ratio() > largest.measure.ratio())
        {
            self.ascent.largest = Some(Found { genome: genome.clone(), measure });
        }
    }
}

/// The criterion by which an ascent ranks scenes.
#[derive(Clone, Copy, Debug)]
struct RankCriterion {
    /// The slack that is added to bounds, in LSBs.
    slack: f64,
    /// Bounds from here on count for nothing, in LSBs.
    most_bound: f64,
}

impl RankCriterion {
    /// The rank of a scene: the ratio of a sum's error, before it is rounded to a code, to the
    /// proven bound of that error. The codes' own ratio is near 1 wherever the rounding to 8 bits
    /// dominates, and small changes do not move it. It counts where a bound is broken, or where
    /// codes are constant, so that their bound may be below the rounding error.
    fn height(self, measure: &Measure) -> f64 {
        let ratio = measure.ratio();
        if measure.bound >= self.most_bound {
            0.0
        } else if ratio > 1.0 {
            HIGHEST + ratio
        } else if measure.bound <= ROUNDING_ERROR {
            ratio / 2.0
        } else {
            (measure.unrounded / (measure.bound - ROUNDING_ERROR + self.slack)).min(HIGHEST)
        }
    }
}
