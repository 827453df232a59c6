//! Trying the whole catalogue.
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use serde::Serialize;
use specula_scene::spec::FULL_SCALE;
use specula_scene::{CoreSpec, Method};

use super::catalogue::CATALOGUE;
use super::draw::Draw;
use super::measured::Measurements;
use super::raw;
use super::requirement::{Requirement, RowVerdict};
use super::row::{Case, CatalogueRow, PixelPlace, Trial, TrialExtent};
use super::trial::{Prepared, Tried};
use super::variant::Variant;

/// The result of one method in one row.
#[derive(Clone, Debug, Serialize)]
pub struct Cell {
    /// The row.
    pub row: &'static str,
    /// The method; `None` if the row needs no core.
    pub method: Option<&'static str>,
    /// Number of cores that were built.
    pub cores: usize,
    /// Number of pixels that they shaded.
    pub pixels: u64,
    /// The reasons why others were not built, each once.
    pub refused: Vec<String>,
    /// Number of bit patterns that break a fact which hosts guarantee; each was reported by the
    /// bench.
    pub reported: usize,
    /// All requirements, those of every row and this row's own, with the results.
    pub asked: Vec<Requirement>,
    /// The largest total error, if a pixel was shaded that has an exact shade.
    pub worst: Option<Worst>,
    /// The scene file that shows the fault, or the largest error; `None` if no core ran.
    #[serde(skip)]
    pub reproducer: Option<String>,
}

/// The pixel with the largest total error, and its core.
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
    /// The proven bound of that error in LSBs; `None` if there is none.
    pub bound: Option<f64>,
}

/// Tries the catalogue with `methods`, row by row; `progress` is called with the number of parts
/// done and the number of all parts.
pub fn sweep(
    seed: u64,
    methods: &[Method],
    extent: TrialExtent,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Vec<Cell> {
    let draws = |(number, row): (usize, &'static CatalogueRow)| {
        let draw = Draw::new(seed, number as u64);
        parts(row, methods).into_iter().map(move |part| (draw.clone(), row, part))
    };
    let parts: Vec<(Draw, &CatalogueRow, Option<Method>)> =
        CATALOGUE.iter().copied().enumerate().flat_map(draws).collect();
    let (done, all) = (AtomicUsize::new(0), parts.len() + methods.len());
    let count = || progress(done.fetch_add(1, Ordering::Relaxed) + 1, all);
    let one = |(mut draw, row, method): (Draw, &CatalogueRow, Option<Method>)| {
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

/// The parts of a row: one for each method, or one without a method for what the host does alone.
fn parts(row: &CatalogueRow, methods: &[Method]) -> Vec<Option<Method>> {
    match row.trial {
        Trial::Scenes { .. } => methods.iter().copied().map(Some).collect(),
        Trial::Host { .. } => vec![None],
    }
}

fn tried(row: &CatalogueRow, method: Option<Method>, draw: &mut Draw, extent: TrialExtent) -> Cell {
    let mut cell = Cell::empty(row.id, method);
    match (&row.trial, method) {
        (Trial::Host { what, check }, _) => {
            let error = check().err();
            cell.ask(
                "host",
                Requirement {
                    detail: error.clone(),
                    of_row: true,
                    ..Requirement::none_of(*what, u64::from(error.is_some()), None)
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
    /// A cell before anything is tried.
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

    /// The verdict; `None` if no core could be built.
    pub fn verdict(&self) -> Option<RowVerdict> {
        self.asked.iter().map(Requirement::verdict).max()
    }

    /// The first requirement that is not met.
    pub fn fault(&self) -> Option<&Requirement> {
        self.asked.iter().find(|asked| asked.verdict() == RowVerdict::Fault)
    }

    /// Adds a requirement on a core, and its result.
    pub(super) fn ask(&mut self, core: &str, asked: Requirement) {
        Requirement::add_to(&mut self.asked, Requirement { core: core.to_owned(), ..asked });
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
                    self.reproducer =
                        Some(prepared.reproducer(variant, PixelPlace::default(), true));
                }
            }
        }
    }

    /// Records a core that failed without a result.
    fn breaks(&mut self, core: &str, detail: String) {
        self.ask(
            core,
            Requirement {
                detail: Some(detail),
                ..Requirement::none_of("runs that break off", 1, None)
            },
        );
    }

    pub(super) fn refuse(&mut self, reason: String) {
        if !self.refused.contains(&reason) {
            self.refused.push(reason);
        }
    }

    fn add(&mut self, prepared: &Prepared, variant: &Variant, measured: &Measurements) {
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

    /// A light a quarter of a unit from a wall: wrapped directions have an error of 191 LSB, which
    /// is reported as a limit, and the row's requirement names the cores that it applies to.
    #[test]
    fn places_wrapped_are_at_a_limit_near_a_wall() {
        let row = CATALOGUE.iter().find(|row| row.id == "40").expect("it is in the catalogue");
        let extent = TrialExtent { every_option: true, ..TrialExtent::SMALL };
        let cell = tried(row, Some(Method::Phong), &mut Draw::new(1, 0), extent);
        assert_eq!(cell.verdict(), Some(RowVerdict::Limit));
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
