//! The whole catalogue.
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use serde::Serialize;
use specula_scene::{CoreSpec, Method};

use super::catalogue::CATALOGUE;
use super::draw::Draw;
use super::raw;
use super::row::{Case, Extent, Row, Trial};
use super::trial::{Fault, Prepared, Ran, Tried};
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
    /// Largest total error, if any pixel was shaded.
    pub worst: Option<Worst>,
    /// Largest share of its proven bound that a quantisation error takes; at most 1, or it is a fault.
    pub share_of_bound: f64,
    /// The first thing that is not as it must be.
    pub fault: Option<Fault>,
    /// With which options.
    pub faulty: Option<String>,
    /// The scene file in which the fault, or the largest error, is to be seen; none without a core that ran.
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
    /// Its proven bound, in LSBs.
    pub bound: f64,
}

/// Tries the catalogue on `methods`, row by row; `progress` is told how many parts of how many are done.
pub fn sweep(seed: u64, methods: &[Method], extent: Extent, progress: &(dyn Fn(usize, usize) + Sync)) -> Vec<Cell> {
    let draws = |(number, row): (usize, &'static Row)| {
        let draw = Draw::new(seed, number as u64);
        parts(row, methods).into_iter().map(move |part| (draw.clone(), row, part))
    };
    let parts: Vec<(Draw, &Row, Option<Method>)> = CATALOGUE.iter().copied().enumerate().flat_map(draws).collect();
    let (done, all) = (AtomicUsize::new(0), parts.len() + methods.len());
    let count = || progress(done.fetch_add(1, Ordering::Relaxed) + 1, all);
    let one = |(mut draw, row, method): (Draw, &Row, Option<Method>)| {
        let cell = tried(row, method, &mut draw, extent);
        count();
        cell
    };
    let mut cells: Vec<Cell> = parts.into_par_iter().map(one).collect();
    let patterns = |(number, &method): (usize, &Method)| {
        let cell = raw::cell(method, &mut Draw::new(seed, (CATALOGUE.len() + number) as u64), extent);
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
        Trial::Host(_) => vec![None],
    }
}

fn tried(row: &Row, method: Option<Method>, draw: &mut Draw, extent: Extent) -> Cell {
    let mut cell = Cell::empty(row.id, method);
    match (&row.trial, method) {
        (Trial::Host(check), _) => {
            cell.fault = check().err().map(|what| Fault { what, span: 0, pixel: 0 });
        }
        (Trial::Scenes { cases, variants }, Some(method)) => {
            let everywhere = if extent.every_option { Variant::all_of(method) } else { vec![Variant::default_of(method)] };
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
            worst: None,
            share_of_bound: 0.0,
            fault: None,
            faulty: None,
            reproducer: None,
        }
    }

    fn try_case(&mut self, case: &Case, variants: &[Variant]) {
        let prepared = match Prepared::new(case) {
            Ok(prepared) => prepared,
            Err(error) => {
                let fault = Fault { what: format!("the scene is refused: {error}"), span: 0, pixel: 0 };
                self.fault.get_or_insert(fault);
                return;
            }
        };
        let mut before: Vec<CoreSpec> = Vec::new();
        for variant in variants {
            match prepared.run(variant, &mut before) {
                Tried::Again => {}
                Tried::Refused(reason) => self.refuse(reason),
                Tried::Ran(ran) => self.add(&prepared, variant, ran),
            }
        }
    }

    pub(super) fn refuse(&mut self, reason: String) {
        if !self.refused.contains(&reason) {
            self.refused.push(reason);
        }
    }

    fn add(&mut self, prepared: &Prepared, variant: &Variant, ran: Ran) {
        let [total, method, quantisation] = ran.errors;
        let is_worst = self.worst.as_ref().is_none_or(|worst| total > worst.total);
        let is_first_fault = self.fault.is_none() && ran.fault.is_some();
        self.cores += 1;
        self.pixels += ran.pixels;
        self.share_of_bound = self.share_of_bound.max(quantisation / ran.bound.max(f64::MIN_POSITIVE));
        if is_first_fault || (self.fault.is_none() && is_worst) {
            self.reproducer = Some(prepared.reproducer(variant, &ran));
        }
        if is_worst {
            self.worst = Some(Worst { core: variant.describe(), total, method, quantisation, bound: ran.bound });
        }
        if is_first_fault {
            (self.fault, self.faulty) = (ran.fault, Some(variant.describe()));
        }
    }
}
