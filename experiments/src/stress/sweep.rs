//! The whole catalogue.
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use serde::Serialize;
use specula_spec::{CoreSpec, FULL_SCALE, Method};

use super::asked::{Asked, Verdict};
use super::catalogue::CATALOGUE;
use super::draw::Draw;
use super::measured::Measured;
use super::raw;
use super::row::{Case, Extent, Place, Row, Trial};
use super::trial::{Prepared, Tried};
use super::variant::Variant;

/// How one method does in one row.
#[derive(Clone, Debug, Serialize)]
pub struct Cell {
    /// The row.
    pub row: &'static str,
    /// The method; none where no core is asked.
    pub method: Option<&'static str>,
    /// Cores that were built.
    pub cores: usize,
    /// Pixels that they shaded.
    pub pixels: u64,
    /// Why others were not built, each reason once.
    pub refused: Vec<String>,
    /// Patterns of bits that break a fact which hosts keep; each was reported by the bench.
    pub reported: usize,
    /// What is asked, everywhere and in this row, and what came.
    pub asked: Vec<Asked>,
    /// Largest total error, if any pixel was shaded that has an exact shade.
    pub worst: Option<Worst>,
    /// The scene file in which the fault, or the largest error, is to be seen; none without a core
    /// that ran.
    #[serde(skip)]
    pub reproducer: Option<String>,
}

/// The pixel with the largest total error, and the core that made it.
#[derive(Clone, Debug, Serialize)]
pub struct Worst {
    /// The method and its options.
    pub core: String,
    /// Total error in LSBs.
    pub total: f64,
    /// Largest error of the method in exact arithmetic, in LSBs.
    pub method: f64,
    /// Largest error of quantisation, in LSBs.
    pub quantisation: f64,
    /// Its proven bound, in LSBs; none where nothing is proven.
    pub bound: Option<f64>,
}

/// Tries the catalogue on `methods`, row by row; `progress` is told how many parts of how many are
/// done.
pub fn sweep(
    seed: u64,
    methods: &[Method],
    extent: Extent,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Cell> {
    let draws = |(number, row): (usize, &'static Row)| {
        let draw = Draw::new(seed, number as u64);
        parts(row, methods).into_iter().map(move |part| (draw.clone(), row, part))
    };
    let parts: Vec<(Draw, &Row, Option<Method>)> =
        CATALOGUE.iter().copied().enumerate().flat_map(draws).collect();
    let (done, all) = (AtomicUsize::new(0), parts.len() + methods.len());
    let count = || progress(done.fetch_add(1, Ordering::Relaxed) + 1, all);
    let one = |(mut draw, row, method): (Draw, &Row, Option<Method>)| {
        let cell = tried(row, method, &mut draw, extent);
        count();
        cell
    };
    let mut cells: Vec<Cell> = parts.into_par_iter().map(one).collect();
    let patterns = |(number, &method): (usize, &Method)| {
        let cell =
            raw::cell(method, &mut Draw::new(seed, (CATALOGUE.len() + number) as u64), extent);
        count();
        cell
    };
    cells.extend(methods.par_iter().enumerate().map(patterns).collect::<Vec<Cell>>());
    cells
}

/// Every method, or none for what the host does alone.
fn parts(row: &Row, methods: &[Method]) -> Vec<Option<Method>> {
    match row.trial {
        Trial::Scenes { .. } => methods.iter().copied().map(Some).collect(),
        Trial::Host { .. } => vec![None],
    }
}

fn tried(row: &Row, method: Option<Method>, draw: &mut Draw, extent: Extent) -> Cell {
    let mut cell = Cell::empty(row.id, method);
    match (&row.trial, method) {
        (Trial::Host { what, check }, _) => {
            let error = check().err();
            cell.ask(
                "host",
                Asked {
                    detail: error.clone(),
                    of_row: true,
                    ..Asked::none_of(*what, u64::from(error.is_some()), None)
                },
            );
        }
        (Trial::Scenes { cases, variants }, Some(method)) => {
            let everywhere = if extent.every_option {
                Variant::all_of(method)
            } else {
                vec![Variant::default_of(method)]
            };
            let of_row = variants().into_iter().filter(|variant| variant.method == method);
            let variants: Vec<Variant> = everywhere.into_iter().chain(of_row).collect();
            for case in cases(draw, extent) {
                cell.try_case(&case, &variants);
            }
        }
        (Trial::Scenes { .. }, None) => {}
    }
    cell
}

impl Cell {
    /// Nothing tried yet.
    pub(super) fn empty(row: &'static str, method: Option<Method>) -> Cell {
        Cell {
            row,
            method: method.map(Method::name),
            cores: 0,
            pixels: 0,
            refused: Vec::new(),
            reported: 0,
            asked: Vec::new(),
            worst: None,
            reproducer: None,
        }
    }

    /// What it all comes to; nothing where no core could be built.
    pub fn verdict(&self) -> Option<Verdict> {
        self.asked.iter().map(Asked::verdict).max()
    }

    /// The first thing that did not happen.
    pub fn fault(&self) -> Option<&Asked> {
        self.asked.iter().find(|asked| asked.verdict() == Verdict::Fault)
    }

    /// Adds what was asked of a core, and what came.
    pub(super) fn ask(&mut self, core: &str, asked: Asked) {
        Asked::add_to(&mut self.asked, Asked { core: core.to_owned(), ..asked });
    }

    fn try_case(&mut self, case: &Case, variants: &[Variant]) {
        let prepared = match Prepared::new(case) {
            Ok(prepared) => prepared,
            Err(error) => return self.breaks("none", format!("the scene is refused: {error}")),
        };
        let mut before: Vec<CoreSpec> = Vec::new();
        for variant in variants {
            match prepared.run(variant, &mut before) {
                Tried::Again => {}
                Tried::Refused(reason) => self.refuse(reason),
                Tried::Ran(Ok(measured)) => self.add(&prepared, variant, &measured),
                Tried::Ran(Err(what)) => {
                    self.breaks(&variant.describe(), what);
                    self.reproducer = Some(prepared.reproducer(variant, Place::default(), true));
                }
            }
        }
    }

    /// A core that gave nothing.
    fn breaks(&mut self, core: &str, detail: String) {
        self.ask(
            core,
            Asked { detail: Some(detail), ..Asked::none_of("runs that break off", 1, None) },
        );
    }

    pub(super) fn refuse(&mut self, reason: String) {
        if !self.refused.contains(&reason) {
            self.refused.push(reason);
        }
    }

    fn add(&mut self, prepared: &Prepared, variant: &Variant, measured: &Measured) {
        let (total, core, had_fault) =
            (measured.total.lsb, variant.describe(), self.fault().is_some());
        let is_worst = self.worst.as_ref().is_none_or(|worst| total > worst.total);
        self.cores += 1;
        self.pixels += measured.pixels;
        for asked in measured.asked() {
            let is_first_fault = !had_fault && !asked.holds() && self.fault().is_none();
            if is_first_fault {
                self.reproducer =
                    Some(prepared.reproducer(variant, asked.place.unwrap_or_default(), true));
            }
            self.ask(&core, asked);
        }
        if self.fault().is_none() && is_worst {
            self.reproducer = Some(prepared.reproducer(variant, measured.total.place, false));
        }
        if is_worst {
            let (method, quantisation) = (measured.method.lsb, measured.quantisation.lsb);
            let bound = Some(measured.bound).filter(|&bound| bound < FULL_SCALE);
            self.worst = Some(Worst { core, total, method, quantisation, bound });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::limits::Reason;
    use super::*;

    /// A light a quarter of a unit from a wall: wrapped directions are 191 LSB off, which is told
    /// as a limit, and what the row asks is said of whom it is asked of.
    #[test]
    fn places_wrapped_are_at_a_limit_near_a_wall() {
        let row = CATALOGUE.iter().find(|row| row.id == "40").expect("it is in the catalogue");
        let extent = Extent { every_option: true, ..Extent::SMALL };
        let cell = tried(row, Some(Method::Phong), &mut Draw::new(1, 0), extent);
        assert_eq!(cell.verdict(), Some(Verdict::Limit));
        let wrapped =
            cell.asked.iter().filter(|asked| asked.reasons.contains(&Reason::WrappedPlaces));
        let worst = wrapped.map(|asked| asked.came).fold(0.0, f64::max);
        assert!((191.0..192.0).contains(&worst), "{worst}");
        let besides =
            cell.asked.iter().filter(|asked| asked.of_row).map(|asked| asked.what.as_str());
        let besides: Vec<&str> = besides.collect();
        assert!(besides.iter().any(|what| what.starts_with("wrapped directions") && what.contains("at both ends")), "{besides:?}");
    }
}
