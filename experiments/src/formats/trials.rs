//! Trials of formats: the bound and the size of a core, each elaborated once.
use std::collections::HashMap;
use std::sync::Mutex;

use specula_spec::CoreSpec;

use super::Wanted;
use crate::cost::Cost;

/// Numbers of fraction bits, in the order of the narrowing points.
pub(super) type Formats = Vec<u32>;

/// What is known of a core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tried {
    /// The proven bound of its quantisation error, in LSBs.
    pub bound: f64,
    /// The resources that it takes, as one number.
    pub cells: u64,
}

/// Formats with what is known of the core that has them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    pub formats: Formats,
    pub tried: Tried,
}

/// The trials of one search.
pub(super) struct Trials<'a> {
    start: &'a CoreSpec,
    block: [u32; 2],
    /// Whether each narrowing point keeps its format.
    kept: Vec<bool>,
    known: Mutex<HashMap<Formats, Option<Tried>>>,
}

/// The formats of a core.
pub(super) fn formats_of(spec: &CoreSpec) -> Formats {
    spec.narrowing_points().iter().map(|point| point.format.fraction_bits).collect()
}

impl<'a> Trials<'a> {
    /// Trials of the formats of `start`; those that are to be kept stay, and those that change
    /// nothing.
    pub fn new(start: &'a CoreSpec, wanted: &Wanted) -> Trials<'a> {
        let points = start.narrowing_points();
        let kept = points.iter().map(|point| wanted.kept.iter().any(|name| name == point.name));
        let kept = kept.collect();
        let mut trials = Trials { start, block: wanted.block, kept, known: Mutex::default() };
        let formats = formats_of(start);
        if let Some(begin) = trials.state(formats.clone()) {
            let finer = trials.neighbours(&formats, 1);
            let inert = finer.into_iter().map(|finer| {
                let finer = finer.and_then(|finer| trials.state(finer));
                finer.is_some_and(|finer| finer.tried == begin.tried)
            });
            let kept = trials.kept.iter().zip(inert).map(|(kept, inert)| *kept || inert);
            trials.kept = kept.collect();
        }
        trials
    }

    /// Number of cores that were elaborated.
    pub fn count(&self) -> usize {
        self.known().len()
    }

    /// The core whose formats are tried.
    pub fn start(&self) -> &CoreSpec {
        self.start
    }

    /// What is known of a core in these formats; none if it cannot be built.
    pub fn state(&self, formats: Formats) -> Option<State> {
        let seen = self.known().get(&formats).copied();
        let tried = seen.unwrap_or_else(|| {
            let tried = self.tried(&formats);
            self.known().insert(formats.clone(), tried);
            tried
        });
        tried.map(|tried| State { formats, tried })
    }

    fn known(&self) -> std::sync::MutexGuard<'_, HashMap<Formats, Option<Tried>>> {
        // Whoever panicked while it held the lock had not begun to change anything.
        self.known.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn tried(&self, formats: &[u32]) -> Option<Tried> {
        let general = self.start.with_fraction_bits(formats)?;
        let spec = general.nearly_specialised_as(self.start);
        let design = specula_hdl::elaborate(&spec, "core").ok()?;
        let cells = Cost::of(&design, Some(self.block)).cells();
        Some(Tried { bound: design.error_bound(), cells }).filter(|tried| tried.bound.is_finite())
    }

    /// The start's formats, all finer by so many bits, each as far as it may be; none if no such core
    /// can be described.
    pub fn finer(&self, added: i32) -> Option<Formats> {
        let formats = formats_of(self.start);
        let moved = formats
            .iter()
            .zip(&self.kept)
            .map(|(&bits, kept)| if *kept { bits } else { bits.saturating_add_signed(added) });
        self.allowed(&moved.collect::<Formats>())
    }

    /// For each narrowing point the formats with that one finer by so many bits, and with those that
    /// this takes along; none if it may not be, or is to be kept.
    pub fn neighbours(&self, formats: &[u32], added: i32) -> Vec<Option<Formats>> {
        (0..formats.len()).map(|point| self.neighbour(formats, point, added)).collect()
    }

    /// One of them.
    pub fn neighbour(&self, formats: &[u32], point: usize, added: i32) -> Option<Formats> {
        let mut moved = formats.to_vec();
        moved[point] = moved[point].checked_add_signed(added)?;
        self.allowed(&moved).filter(|allowed| allowed[point] != formats[point])
    }

    /// The nearest formats that a core may have; none if a kept one would change.
    fn allowed(&self, formats: &[u32]) -> Option<Formats> {
        let allowed = formats_of(&self.start.with_fraction_bits(formats)?);
        let start = formats_of(self.start);
        let stays = |point: usize| !self.kept[point] || allowed[point] == start[point];
        (0..allowed.len()).all(stays).then_some(allowed)
    }
}
