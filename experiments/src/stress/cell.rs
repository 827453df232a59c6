//! How one method does in one row of the catalogue.
use serde::Serialize;
use specula_spec::FULL_SCALE;
use specula_spec::{CoreSpec, Method};

use super::asked::{Asked, Verdict};
use super::measured::Measured;
use super::row::{Case, Place};
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
