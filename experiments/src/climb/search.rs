//! The search: climbers with every method.
use rayon::prelude::*;
use specula_spec::Method;

use super::ascent::{Ascent, Found};
use super::genome::Genome;
use super::measure::{Bound, Measure, Unmeasured, measure, proven, simulate};
use super::report::{MethodReport, Peak};
use super::shrink::shrink;
use crate::stress::draw::Draw;

/// Number of scenes that a climber tries.
const SCENES_PER_CLIMBER: u64 = 500;
/// Largest number of broken bounds of a method that are minimised and reported.
pub const MAX_REPORTED: usize = 4;

/// The extent of a search.
#[derive(Clone, Debug)]
pub struct Search {
    /// Seed of the random numbers; the same seed finds the same scenes.
    pub seed: u64,
    /// Number of scenes that are tried, divided among the methods.
    pub scenes: u64,
    /// The methods.
    pub methods: Vec<Method>,
}

/// Climbs with the bounds that designs prove; `count` is called for each scene that was tried. The
/// result does not depend on the number of threads.
pub fn climb(search: &Search, count: &(dyn Fn() + Sync)) -> Vec<MethodReport> {
    climb_against(search, &proven, count)
}

/// Climbs with other bounds, to test whether broken ones are found.
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
        let of = move |number| {
            (method, number, SCENES_PER_CLIMBER.min(scenes - number * SCENES_PER_CLIMBER))
        };
        (0..scenes.div_ceil(SCENES_PER_CLIMBER)).map(of)
    }
}

fn report(method: Method, ascents: &[&Ascent], bound: &Bound) -> MethodReport {
    let mut highest: Vec<&Found> =
        ascents.iter().filter_map(|ascent| ascent.largest.as_ref()).collect();
    // The sort is stable, so that the first of several equal ones counts.
    highest.sort_by(|a, b| b.measure.ratio().total_cmp(&a.measure.ratio()));
    let broken: Vec<&Found> =
        highest.iter().copied().filter(|found| found.measure.ratio() > 1.0).collect();
    let told = broken.par_iter().take(MAX_REPORTED).map(|found| made_small(found, bound));
    let intact = highest.par_iter().filter(|found| found.measure.ratio() <= 1.0);
    let simulated: Vec<Option<Peak>> = intact.map(|found| differing(found)).collect();
    let faults = ascents.iter().filter_map(|ascent| ascent.fault.as_ref());
    let faults = faults.map(|(genome, what)| faulty(genome, what.clone()));
    let others = simulated.into_iter().flatten().chain(faults).take(MAX_REPORTED);
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

/// Number of scenes until the first bound was broken, as if one climber climbed after the other.
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
    let (genome, measure) = shrink(&found.genome, found.measure, &broken);
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

/// Simulates the scene at which a climber ended; the result is a fault of the hardware.
fn differing(found: &Found) -> Option<Peak> {
    let differs = |genome: &Genome| fault_of(simulate(genome.text()));
    let what = differs(&found.genome)?;
    let (genome, what) = shrink(&found.genome, what, &differs);
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

    /// A bound from which 2 percent of the error is missing, unless it consists mostly of the
    /// rounding to 8 bits or is as large as the range of codes: there random scenes come close as
    /// well.
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
        // The reported scene is smaller than the one that was found, and its bound is still broken.
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
