//! How one method does in one row of the catalogue.
use serde::Serialize;
use specula_spec::FULL_SCALE;
use specula_spec::{CoreSpec, Method};

use super::measured::Measurements;
use super::requirement::{Requirement, RowVerdict};
use super::row::{Case, PixelPlace};
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

    pub(super) fn try_case(&mut self, case: &Case, variants: &[Variant]) {
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
