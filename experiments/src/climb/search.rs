//! Climbers by every method.
use rayon::prelude::*;
use specula_spec::Method;

use super::ascent::{Ascent, Found};
use super::genome::Genome;
use super::measure::{Bound, Measure, Unmeasured, measure, proven, simulate};
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

/// Climbs with what designs prove; `count` is told of each scene that was tried. What is found does
/// not depend on the number of threads.
pub fn climb(search: &Search, count: &(dyn Fn() + Sync)) -> Vec<MethodReport> {
    climb_against(search, &proven, count)
}

/// Climbs with other bounds, to see whether broken ones are found.
fn climb_against(search: &Search, bound: &Bound, count: &(dyn Fn() + Sync)) -> Vec<MethodReport> {
    let climbers: Vec<(Method, u64, u64)> =
        search.methods.iter().flat_map(|&method| search.climbers(method)).collect();
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
    let mut highest: Vec<&Found> =
        ascents.iter().filter_map(|ascent| ascent.largest.as_ref()).collect();
    // The sort is stable, so that of equal ones the first counts.
    highest.sort_by(|a, b| b.measure.ratio().total_cmp(&a.measure.ratio()));
    let broken: Vec<&Found> =
        highest.iter().copied().filter(|found| found.measure.ratio() > 1.0).collect();
    let told = broken.par_iter().take(MOST_TOLD).map(|found| made_small(found, bound));
    let intact = highest.par_iter().filter(|found| found.measure.ratio() <= 1.0);
    let simulated: Vec<Option<Peak>> = intact.map(|found| differing(found)).collect();
    let faults = ascents.iter().filter_map(|ascent| ascent.fault.as_ref());
    let faults = faults.map(|(genome, what)| faulty(genome, what.clone()));
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
    let broken = |genome: &Genome| {
        measure(genome.text(), bound).ok().filter(|measure| measure.ratio() > 1.0)
    };
    let (genome, measure) = shrunk(&found.genome, found.measure, &broken);
    peak(&genome, &measure)
}

fn peak(genome: &Genome, measure: &Measure) -> Peak {
    Peak {
        ratio: measure.ratio(),
        quantisation_lsb: measure.largest,
        bound_lsb: measure.bound,
        fault: None,
        scene: genome.text(),
    }
}

/// What is wrong with the hardware where a climber ended.
fn differing(found: &Found) -> Option<Peak> {
    let differs = |genome: &Genome| fault_of(simulate(genome.text()));
    let what = differs(&found.genome)?;
    let (genome, what) = shrunk(&found.genome, what, &differs);
    Some(faulty(&genome, what))
}

fn faulty(genome: &Genome, what: String) -> Peak {
    Peak {
        ratio: 0.0,
        quantisation_lsb: 0.0,
        bound_lsb: 0.0,
        fault: Some(what),
        scene: genome.text(),
    }
}

fn fault_of<T>(result: Result<T, Unmeasured>) -> Option<String> {
    match result {
        Err(Unmeasured::Fault(what)) => Some(what),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use specula_datapath::Design;

    use super::super::ascent::NO_BOUND;
    use super::super::random::{self, Formats};
    use super::*;

    const SCENES: u64 = 2000;

    /// A bound with 2 percent of the error forgotten, where it is neither most of all the rounding
    /// to 8 bits nor so large that it is the range of codes: there random scenes come near as well.
    fn planted(design: &Design) -> f64 {
        let proven = proven(design);
        if (1.0..32.0).contains(&proven) { 0.98 * proven } else { NO_BOUND }
    }

    /// The largest ratio of as many random scenes.
    fn drawn(method: Method) -> f64 {
        let mut draw = Draw::new(1, 0);
        let one =
            |_| measure(random::genome(&mut draw, method, Formats::Any)?.text(), &planted).ok();
        let measured = (0..SCENES).filter_map(one).filter(|measure| measure.bound < NO_BOUND);
        measured.map(|measure| measure.ratio()).fold(0.0, f64::max)
    }

    #[test]
    fn a_broken_bound_is_found_by_climbing_and_not_by_drawing() {
        let method = Method::Hybrid;
        let search = Search { seed: 1, scenes: SCENES, methods: vec![method] };
        let found = &climb_against(&search, &planted, &|| ())[0];
        let (climbed, drawn) =
            (found.largest.as_ref().map_or(0.0, |peak| peak.ratio), drawn(method));
        println!("{}: climbed {climbed:.4}, drawn {drawn:.4}", method.name());
        assert!(
            drawn <= 1.0 && climbed > 1.0,
            "{}: climbed {climbed}, drawn {drawn}",
            method.name()
        );
        assert!(found.first_broken_after.is_some() && !found.holds());
        // What is told is smaller than where it was found, and broken still.
        let small = &found.wrong[0];
        let of_small = measure(small.scene.clone(), &planted).expect("it has a core");
        assert_eq!((of_small.ratio(), of_small.bound), (small.ratio, small.bound_lsb));
        let largest = &found.largest.as_ref().expect("a bound was broken").scene;
        assert!(
            small.ratio > 1.0 && small.scene.len() < largest.len(),
            "{largest}\n{}",
            small.scene
        );
    }
}
