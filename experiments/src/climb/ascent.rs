//! One climber: it starts anew from random scenes until it has tried as many as it may.
use specula_spec::Method;

use super::genome::Genome;
use super::measure::{Bound, Measure, Unmeasured, measure};
use super::mutation::Mutation;
use super::random::{self, Formats};
use crate::stress::draw::Draw;

/// A bound of full scale, in LSBs, says nothing.
pub const NO_BOUND: f64 = 255.0;
/// Random scenes from the best of which an ascent begins.
const BEGINNINGS: u64 = 6;
/// Scenes in a row that are no better, after which an ascent ends.
const PATIENCE: u64 = 60;
/// By how much an ascent must rise to be counted as better.
const RISE: f64 = 1e-4;
/// What the rounding to 8 bits alone is off by at most, in LSBs.
const OF_ROUNDING: f64 = 0.5;
/// What is added to bounds, in LSBs, one of these in an ascent: with little, errors of fine formats
/// count as much as those of coarse ones, and roundings of colours to 2^-7 LSB lead to a ratio of
/// 1; with much, only large errors count.
const SLACKS: [f64; 3] = [0.002, 0.03, 0.3];
/// Bounds above which an ascent does not go, one of these in LSBs: where formats are so coarse that
/// the bound is all that a code can be off, it is reached easily.
const MOST_BOUNDS: [f64; 3] = [2.0, 16.0, NO_BOUND];
/// The highest that the error of a sum counts, of what is proven of it: where the bound rests on
/// what codes there can be, it may be above 1.
const HIGHEST: f64 = 1.5;
/// Ambient lights that are tried to make an error show in codes.
const AMBIENTS: u64 = 24;

/// A scene and what came of it.
#[derive(Clone, Debug)]
pub struct Found {
    /// The scene and its core.
    pub genome: Genome,
    /// What was measured.
    pub measure: Measure,
}

/// What a climber found.
#[derive(Clone, Debug, Default)]
pub struct Ascent {
    /// Scenes that it tried.
    pub scenes: u64,
    /// Those of them for which there is no core.
    pub refused: u64,
    /// Those of which the bound is full scale or more.
    pub without_bound: u64,
    /// That with the largest ratio of measured to bound.
    pub largest: Option<Found>,
    /// The first with a ratio above 1.
    pub first_broken: Option<u64>,
    /// The first in which something else is wrong, and what.
    pub fault: Option<(Genome, String)>,
}

impl Ascent {
    /// Climbs by `method` until `scenes` are tried; `count` is told of each.
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

    /// From the best of some random scenes on, until nothing gets better.
    fn climb(&mut self) {
        let taste =
            Taste { slack: self.draw.one_of(&SLACKS), most_bound: self.draw.one_of(&MOST_BOUNDS) };
        let height = |measure: &Measure| taste.height(measure);
        let formats = Formats::draw(self.draw);
        let Some((mut genome, mut measure)) = self.beginning(&height, formats) else { return };
        let mutation = match formats {
            Formats::Any => Mutation::new(self.draw),
            Formats::OneCoarse(_) => Mutation::of_no_formats(self.draw),
        };
        let mut idle = 0;
        while idle < PATIENCE && !self.is_tired() {
            idle += 1;
            let changed = mutation.of(&genome, self.draw);
            let Some((next, of_next)) = self.tried(changed) else { continue };
            if height(&of_next) > height(&measure) * (1.0 + RISE) {
                idle = 0;
            }
            if height(&of_next) >= height(&measure) {
                (genome, measure) = (next, of_next);
            }
        }
        if measure.ratio() <= 1.0
            && measure.unrounded > measure.bound - OF_ROUNDING
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

    /// Where the error of a sum is beyond what is proven of it, some ambient light carries that
    /// over the middle between two codes.
    fn show(&mut self, genome: &Genome) {
        for _ in 0..AMBIENTS {
            if self.is_tired() {
                break;
            }
            let mut lit = genome.clone();
            lit.scene.ambient = [self.draw.unit(); 3];
            lit.scene.spans.iter_mut().for_each(|span| span.material.ambient = [1.0; 3]);
            self.tried(lit.settled());
        }
    }

    /// Measures a scene and notes what came of it; none if there is no core.
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

/// What an ascent is after.
#[derive(Clone, Copy, Debug)]
struct Taste {
    /// What is added to bounds, in LSBs.
    slack: f64,
    /// Bounds from here on count for nothing, in LSBs.
    most_bound: f64,
}

impl Taste {
    /// How high a scene stands: the error of a sum before it is rounded to a code, by what is
    /// proven of that. The codes' own ratio is near 1 wherever the rounding to 8 bits is most of
    /// it, and does not move with small changes; it counts where a bound is broken, or where codes
    /// are always the same, whose bound may be below what rounding takes.
    fn height(self, measure: &Measure) -> f64 {
        let ratio = measure.ratio();
        if measure.bound >= self.most_bound {
            0.0
        } else if ratio > 1.0 {
            HIGHEST + ratio
        } else if measure.bound <= OF_ROUNDING {
            ratio / 2.0
        } else {
            (measure.unrounded / (measure.bound - OF_ROUNDING + self.slack)).min(HIGHEST)
        }
    }
}
