//! Climbers by every method.
use rayon::prelude::*;
use specula_scene::Method;

use super::ascent::{Ascent, Found};
use super::genome::Genome;
use super::measure::{Bound, Measure, Unmeasured, proven, simulate};
use super::report::{MethodReport, Peak};
use super::shrink::shrunk;
use crate::stress::draw::Draw;

/// Scenes that a climber tries.
const OF_A_CLIMBER: u64 = 500;
/// The most broken bounds of a method that are made small and told.
pub const MOST_TOLD: usize = 4;

/// What to search.
#[derive(Clone, Debug)]
pub struct Search {
    /// Of the random numbers; the same seed finds the same.
    pub seed: u64,
    /// Scenes that are tried, shared out among the methods.
    pub scenes: u64,
    /// The methods.
    pub methods: Vec<Method>,
}

/// Climbs with what designs prove; `count` is told of each scene that was tried. What is found does not depend on the number of threads.
pub fn climb(search: &Search, count: &(dyn Fn() + Sync)) -> Vec<MethodReport> {
    climb_against(search, &proven, count)
}

/// Climbs with other bounds, to see whether broken ones are found.
fn climb_against(search: &Search, bound: &Bound, count: &(dyn Fn() + Sync)) -> Vec<MethodReport> {
    let climbers: Vec<(Method, u64, u64)> = search.methods.iter().flat_map(|&method| search.climbers(method)).collect();
    let one = |&(method, number, scenes): &(Method, u64, u64)| {
        let mut draw = Draw::new(search.seed, (method as u64) << 32 | number);
        Ascent::new(&mut draw, method, scenes, bound, count)
    };
    let ascents: Vec<Ascent> = climbers.par_iter().map(one).collect();
    let of_method = |&method: &Method| {
        let own = climbers.iter().zip(&ascents).filter(|((of, _, _), _)| *of == method);
        report(method, &own.map(|(_, ascent)| ascent).collect::<Vec<_>>(), bound)
    };
    search.methods.iter().map(of_method).collect()
}

impl Search {
    /// Method, number and scenes of each climber.
    fn climbers(&self, method: Method) -> impl Iterator<Item = (Method, u64, u64)> {
        let scenes = self.scenes.div_ceil(self.methods.len().max(1) as u64);
        let of = move |number| (method, number, OF_A_CLIMBER.min(scenes - number * OF_A_CLIMBER));
        (0..scenes.div_ceil(OF_A_CLIMBER)).map(of)
    }
}

fn report(method: Method, ascents: &[&Ascent], bound: &Bound) -> MethodReport {
    let mut highest: Vec<&Found> = ascents.iter().filter_map(|ascent| ascent.largest.as_ref()).collect();
    // The sort is stable, so that of equal ones the first counts.
    highest.sort_by(|a, b| b.measure.ratio().total_cmp(&a.measure.ratio()));
    let broken: Vec<&Found> = highest.iter().copied().filter(|found| found.measure.ratio() > 1.0).collect();
    let told = broken.par_iter().take(MOST_TOLD).map(|found| made_small(found, bound));
    let simulated: Vec<Option<Peak>> = highest.par_iter().map(|found| differing(found)).collect();
    let faults = ascents.iter().filter_map(|ascent| ascent.fault.as_ref()).map(|(genome, what)| faulty(genome, what.clone()));
    let others = simulated.into_iter().flatten().chain(faults).take(MOST_TOLD);
    MethodReport {
        method: method.name(),
        scenes: ascents.iter().map(|ascent| ascent.scenes).sum(),
        refused: ascents.iter().map(|ascent| ascent.refused).sum(),
        without_bound: ascents.iter().map(|ascent| ascent.without_bound).sum(),
        first_broken_after: first_broken(ascents),
        climbers_that_broke_one: broken.len(),
        largest: highest.first().map(|found| peak(&found.genome, &found.measure)),
        wrong: told.collect::<Vec<_>>().into_iter().chain(others).collect(),
    }
}

/// Scenes until the first bound was broken, as if climbers climbed one after the other.
fn first_broken(ascents: &[&Ascent]) -> Option<u64> {
    let before = ascents.iter().scan(0, |before, ascent| {
        let own = *before;
        *before += ascent.scenes;
        Some((own, ascent))
    });
    before.filter_map(|(before, ascent)| Some(before + ascent.first_broken?)).next()
}

fn made_small(found: &Found, bound: &Bound) -> Peak {
    let (genome, measure) = shrunk(&found.genome, found.measure, bound);
    peak(&genome, &measure)
}

fn peak(genome: &Genome, measure: &Measure) -> Peak {
    Peak { ratio: measure.ratio(), quantisation_lsb: measure.largest, bound_lsb: measure.bound, fault: None, scene: genome.text() }
}

/// What is wrong with the hardware where a climber ended.
fn differing(found: &Found) -> Option<Peak> {
    match simulate(found.genome.text()) {
        Err(Unmeasured::Fault(what)) => Some(Peak { fault: Some(what), ..peak(&found.genome, &found.measure) }),
        _ => None,
    }
}

fn faulty(genome: &Genome, what: String) -> Peak {
    Peak { ratio: 0.0, quantisation_lsb: 0.0, bound_lsb: 0.0, fault: Some(what), scene: genome.text() }
}
