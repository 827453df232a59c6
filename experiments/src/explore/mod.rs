//! The search over methods, options and formats for the smallest core whose picture is close enough
//! to exact shading.
//!
//! Starting from each method's defaults, one option after the other is changed as long as that
//! helps. For each setting all formats are narrowed together; finally, for the best setting, each
//! one separately. This is a descent: the result keeps the stated error but need not be the
//! smallest core. The search looks at a sample of the spans; what is reported is measured on every
//! pixel.
//!
//! Cores for any device are compared by their size. Those that are made for a target have clocks of
//! their own, so they are compared by cells times the time for a frame. The search itself elaborates
//! them for any device, which takes a thirtieth of the time: it estimates their cells on the target,
//! and takes the highest clock of the first core with the same options for theirs, since loops limit it
//! more than formats do. Those that it finds are then made for the target.
mod device;
mod on_target;
mod options;

use std::cell::RefCell;

use rayon::prelude::*;
use serde::Serialize;
use specula_datapath::Design;
use specula_scene::{Frame, Needs};
use specula_spec::{CoreSpec, Method};

use crate::cost::Cost;
use crate::pareto_front;
use crate::picture::{ExactPicture, sampled};
use crate::search::{Goal, largest_error};
use crate::tradeoff::FrameCycles;
pub use device::{Device, Share};
pub use on_target::{OnTarget, WantedClock};
use options::Options;
use specula_testbench::BenchError;

/// Number of pixels at which the search looks.
const SAMPLE: u64 = 20_000;
/// How many times its effort a core counts that does not fit the device, or does not reach the clock:
/// more than any other.
const UNMET: u64 = 1000;
/// How often the search goes through all options.
const ROUNDS: usize = 3;

/// The goal of a search.
#[derive(Clone, Debug)]
pub struct Wanted<'a> {
    /// Largest total error, against exact shading, in LSBs of the 8-bit output.
    pub most: f64,
    /// Methods that the core may use.
    pub methods: &'a [Method],
    /// The device on which the core is to be built, if it is known.
    pub device: Option<Device>,
    /// The target that cores are made for; without, they are for any device.
    pub target: Option<WantedClock>,
}

/// A core that was tried.
#[derive(Clone, Debug, Serialize)]
pub struct Explored {
    /// The method and options that differ from its defaults.
    pub core: String,
    /// Largest total error over every pixel, in LSBs.
    pub error: f64,
    /// Largest quantisation error over every pixel, in LSBs, of cores on the front.
    pub quantisation: Option<f64>,
    /// The proven bound of that error in LSBs; `None` if there is no finite one.
    pub bound: Option<f64>,
    /// The resources that it takes, as far as they are known whatever the device.
    pub cost: Cost,
    /// The cells of the target that it takes, and its clock.
    pub on_target: Option<OnTarget>,
    /// The clocks that it takes for the frame.
    pub cycles: FrameCycles,
    /// The spec of the core, for this scene alone.
    pub spec: CoreSpec,
}

/// The result of a search.
#[derive(Clone, Debug, Serialize)]
pub struct Exploration {
    /// The cores on the front, the smallest first: no other core that was tried is both smaller and
    /// more exact. They fit the device and reach the clock, unless none does.
    pub front: Vec<Explored>,
    /// Index of the smallest core within the error that fits the device; `None` if there is none.
    pub best: Option<usize>,
    /// Number of cores that were tried.
    pub tried: usize,
    /// Methods that cannot shade the scene, with the reasons.
    pub refused: Vec<String>,
}

/// Searches. `progress` is called for each core that is tried.
///
/// # Errors
/// [`BenchError`] if a core cannot be built.
pub fn explore(
    frame: &Frame,
    wanted: &Wanted,
    progress: &(dyn Fn() + Sync),
) -> Result<Exploration, BenchError> {
    let needs = Needs::of(frame);
    let sample = ExactPicture::new(sampled(frame, SAMPLE));
    let search = Search { frame, needs: &needs, sample: &sample, wanted, progress };
    let searched: Vec<Searched> =
        wanted.methods.par_iter().map(|&method| search.method(method)).collect::<Result<_, _>>()?;
    let refused = searched.iter().filter_map(|searched| searched.refused.clone()).collect();
    let tried: Vec<Explored> = searched.into_iter().flat_map(|searched| searched.tried).collect();
    let number = tried.len();
    let front = measured(candidates(tried, wanted), frame, wanted)?;
    let best = front.iter().position(|core| core.error <= wanted.most && wanted.is_met(core));
    Ok(Exploration { front, best, tried: number, refused })
}

/// The cores on the front of those that fit the device and reach the clock, and on the front of the
/// others: whether they do is only estimated before they are made for the target.
fn candidates(tried: Vec<Explored>, wanted: &Wanted) -> Vec<Explored> {
    let (met, others): (Vec<_>, Vec<_>) =
        tried.into_par_iter().partition(|core| wanted.is_met(core));
    front(met).into_iter().chain(front(others)).collect()
}

/// The cores that fit the device and reach the clock, or all if none does.
fn met_or_all(cores: Vec<Explored>, wanted: &Wanted) -> Vec<Explored> {
    let met: Vec<Explored> = cores.iter().filter(|core| wanted.is_met(core)).cloned().collect();
    if met.is_empty() { cores } else { met }
}

/// The cores on the front, the smallest first. Of equal cores the first is kept.
fn front(tried: Vec<Explored>) -> Vec<Explored> {
    // An effort is far below 2^53, so it is exact as an f64.
    let places: Vec<(f64, f64)> =
        tried.iter().map(|core| (core.effort() as f64, core.error)).collect();
    pareto_front(&places).into_iter().map(|number| tried[number].clone()).collect()
}

/// The front of cores whose errors are known on a sample, by their errors over every pixel.
fn measured(
    cores: Vec<Explored>,
    frame: &Frame,
    wanted: &Wanted,
) -> Result<Vec<Explored>, BenchError> {
    let whole = ExactPicture::new(frame.clone());
    let measured = cores.into_par_iter().map(|core| {
        let core = on_its_target(core, frame, wanted)?;
        Ok(Explored { error: whole.largest_error(&core.spec)?, ..core })
    });
    let front = front(met_or_all(measured.collect::<Result<_, BenchError>>()?, wanted));
    let checked = front
        .into_iter()
        .map(|core| Ok(Explored { quantisation: Some(largest_error(&core.spec, frame)?), ..core }));
    checked.collect()
}

/// A core made for the target that is asked for, if one is.
fn on_its_target(core: Explored, frame: &Frame, wanted: &Wanted) -> Result<Explored, BenchError> {
    let Some(target) = &wanted.target else { return Ok(core) };
    let spec = target.made(&core.spec)?;
    let design = specula_hdl::elaborate(&spec, "core")?;
    let (on_target, cycles) = (target.of(&design), FrameCycles::new(&design, frame));
    Ok(Explored { spec, on_target, cycles, ..core })
}

impl Wanted<'_> {
    /// Whether a core fits the device and reaches the clock that is asked for.
    fn is_met(&self, core: &Explored) -> bool {
        let reaches = |target: &WantedClock| core.on_target.is_some_and(|on| target.is_met(&on));
        let has = |device: &Device| core.fits(device);
        self.target.as_ref().is_none_or(reaches) && self.device.as_ref().is_none_or(has)
    }
}

impl Explored {
    /// Whether a device has enough for the core.
    pub fn fits(&self, device: &Device) -> bool {
        match &self.on_target {
            Some(on_target) => device.has(&on_target.resources),
            None => {
                let design = specula_hdl::elaborate(&self.spec, "core");
                design.is_ok_and(|design| device.has(&device.resources(&design)))
            }
        }
    }

    /// What cores are compared by: cells, times nanoseconds for a frame where the core is made for a
    /// target.
    pub fn effort(&self) -> u64 {
        match &self.on_target {
            Some(OnTarget { cells, predicted_mhz, .. }) => {
                let nanoseconds = 1000.0 * self.cycles.with_set_up as f64 / predicted_mhz;
                (*cells as f64 * nanoseconds) as u64
            }
            None => self.cost.cells(),
        }
    }

    /// The quantisation error and its bound, if the error exceeds it: then the set-up of spans or
    /// the bound is wrong.
    pub fn beyond_bound(&self) -> Option<[f64; 2]> {
        let (quantisation, bound) = self.quantisation.zip(self.bound)?;
        (quantisation > bound).then_some([quantisation, bound])
    }
}

/// The search over one method's cores.
struct Search<'a> {
    frame: &'a Frame,
    needs: &'a Needs,
    sample: &'a ExactPicture,
    wanted: &'a Wanted<'a>,
    progress: &'a (dyn Fn() + Sync),
}

/// The result of that search.
#[derive(Default)]
struct Searched {
    tried: Vec<Explored>,
    refused: Option<String>,
}

/// Options with formats that were narrowed together.
struct Setting {
    options: Options,
    spec: CoreSpec,
    rank: Rank,
}

/// The rank of a setting; less is better.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
enum Rank {
    /// The setting is within the error and takes this effort.
    Within(u64),
    /// The setting has a larger error, in LSBs.
    Beyond(f64),
}

impl Search<'_> {
    fn method(&self, method: Method) -> Result<Searched, BenchError> {
        let start = Options::default_of(method);
        if let Err(error) = start.spec(self.needs) {
            return Ok(Searched {
                refused: Some(format!("{}: {error}", method.name())),
                ..Searched::default()
            });
        }
        let tries = Tries {
            search: self,
            tried: RefCell::default(),
            known: RefCell::default(),
            clocks: RefCell::default(),
        };
        if let Some(Setting { options, spec, rank: Rank::Within(_) }) = tries.best_options(start)? {
            tries.search_with(&options, |goal| goal.narrow_each(spec))?;
        }
        Ok(Searched { tried: tries.tried.into_inner(), refused: None })
    }
}

/// One method's cores while they are tried.
struct Tries<'a> {
    search: &'a Search<'a>,
    tried: RefCell<Vec<Explored>>,
    /// The results for general cores, which are kept because specialising one takes the set-up of
    /// every span.
    known: RefCell<Vec<(CoreSpec, Tried)>>,
    /// The highest clock in MHz of the first core with these options.
    clocks: RefCell<Vec<(Options, f64)>>,
}

impl Tries<'_> {
    /// The best options that are found by changing one after the other.
    fn best_options(&self, start: Options) -> Result<Option<Setting>, BenchError> {
        let mut best = self.narrowed(start)?;
        for _ in 0..ROUNDS {
            let Some(before) = best.as_ref().map(|setting| setting.options.clone()) else { break };
            for neighbour in before.neighbours() {
                let setting = self.narrowed(neighbour)?;
                let is_better =
                    |old: &Setting| setting.as_ref().is_some_and(|new| new.rank < old.rank);
                if best.as_ref().is_some_and(is_better) {
                    best = setting;
                }
            }
            if best.as_ref().is_some_and(|setting| setting.options == before) {
                break;
            }
        }
        Ok(best)
    }

    /// Options with all formats narrowed together; `None` if no core can be built with them.
    fn narrowed(&self, options: Options) -> Result<Option<Setting>, BenchError> {
        let Ok(start) = options.spec(self.search.needs) else { return Ok(None) };
        let (spec, rank) = match self.search_with(&options, |goal| goal.narrow_together(&start))? {
            Ok(spec) => {
                let effort = self.tried(&options, &spec)?.effort;
                (spec, Rank::Within(effort))
            }
            Err(error) => (start, Rank::Beyond(error)),
        };
        Ok(Some(Setting { options, spec, rank }))
    }

    /// Runs a search of formats for these options.
    fn search_with<T>(&self, options: &Options, search: impl FnOnce(&Goal<u64>) -> T) -> T {
        let error = |spec: &CoreSpec| Ok(self.tried(options, spec)?.error);
        let cost = |spec: &CoreSpec| Ok(self.tried(options, spec)?.effort);
        search(&Goal { most: self.search.wanted.most, error: &error, cost: &cost })
    }

    /// The error and size of a general core after specialisation; infinite if it cannot be built.
    fn tried(&self, options: &Options, general: &CoreSpec) -> Result<Tried, BenchError> {
        let known =
            self.known.borrow().iter().find(|(core, _)| core == general).map(|(_, tried)| *tried);
        if let Some(known) = known {
            return Ok(known);
        }
        let tried = self.tried_anew(options, general)?;
        self.known.borrow_mut().push((general.clone(), tried));
        Ok(tried)
    }

    /// What a core is likely to be on the target that is asked for, by its design for any device.
    fn on_target(
        &self,
        options: &Options,
        spec: &CoreSpec,
        design: &Design,
    ) -> Result<Option<OnTarget>, BenchError> {
        let Some(target) = &self.search.wanted.target else { return Ok(None) };
        let known = self.clocks.borrow().iter().find(|(of, _)| of == options).map(|(_, mhz)| *mhz);
        let highest = match known {
            Some(mhz) => mhz,
            None => {
                let mhz = target.highest_clock(spec)?;
                self.clocks.borrow_mut().push((options.clone(), mhz));
                mhz
            }
        };
        Ok(Some(target.estimated(design, highest)))
    }

    fn tried_anew(&self, options: &Options, general: &CoreSpec) -> Result<Tried, BenchError> {
        let Search { frame, sample, wanted, progress, .. } = self.search;
        let spec = general.specialised(*frame);
        let of = |core: &Explored| Tried::of(core, wanted);
        let seen = self.tried.borrow().iter().find(|core| core.spec == spec).map(of);
        if let Some(seen) = seen {
            return Ok(seen);
        }
        let Ok(design) = specula_hdl::elaborate(&spec, "core") else {
            return Ok(Tried { error: f64::INFINITY, effort: u64::MAX });
        };
        let block = wanted.device.as_ref().and_then(|device| device.block);
        let cost = Cost::of(&design, block);
        let error = sample.largest_error(&spec)?;
        let (cycles, bound) = (FrameCycles::new(&design, frame), design.error_bound());
        let bound = bound.is_finite().then_some(bound);
        let core = Explored {
            core: options.describe(),
            error,
            quantisation: None,
            bound,
            cost,
            on_target: self.on_target(options, &spec, &design)?,
            cycles,
            spec,
        };
        let tried = Tried::of(&core, wanted);
        self.tried.borrow_mut().push(core);
        progress();
        Ok(tried)
    }
}

/// The quantities of a core that a search compares.
#[derive(Clone, Copy)]
struct Tried {
    error: f64,
    effort: u64,
}

impl Tried {
    fn of(core: &Explored, wanted: &Wanted) -> Tried {
        let times = if wanted.is_met(core) { 1 } else { UNMET };
        Tried { error: core.error, effort: core.effort().saturating_mul(times) }
    }
}
