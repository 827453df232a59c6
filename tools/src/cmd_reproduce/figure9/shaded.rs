//! Rows that have been simulated and compared.
use serde::Serialize;
use specula_experiments::figure9::FigureRow;
use specula_testbench::{Bench, ErrorFigures, Image, Outcome};

use super::names::module;
use crate::disagreement::Disagreement;
use crate::verilog::{self, bound};

/// A row that has been simulated and compared.
pub struct Shaded {
    pub line: Line,
    pub verilog: String,
    pub simulated: Image,
    pub disagreement: Option<Disagreement>,
}

/// A row of the report. Errors are in LSBs of the 8-bit output.
#[derive(Serialize)]
pub struct Line {
    /// Number of the row, from 1.
    pub row: usize,
    pub title: &'static str,
    pub method: &'static str,
    pub options: &'static [&'static str],
    pub pixels: u64,
    pub agrees: bool,
    pub mismatches: u64,
    /// Error of the core's codes against the formula in f64, at most full scale.
    pub error: ErrorFigures,
    /// Proven bound of the largest error; `None` if there is no finite one.
    pub bound_lsb: Option<f64>,
    pub latency: u32,
    /// Multipliers of two variables.
    pub multipliers: usize,
    pub register_bits: u64,
    /// Name of the file that holds the core.
    pub verilog: String,
}

impl Line {
    /// The line of a row that has been simulated.
    pub fn new(
        (row, number): (&FigureRow, usize),
        bench: &Bench,
        outcome: &Outcome,
        error: ErrorFigures,
    ) -> Line {
        let (bound, size) = (bench.design.error_bound(), bench.design.size());
        Line {
            row: number,
            title: row.title,
            method: row.method.name(),
            options: row.options,
            pixels: outcome.pixels,
            agrees: outcome.agrees(),
            mismatches: outcome.comparison.mismatches,
            error,
            bound_lsb: bound.is_finite().then_some(bound),
            latency: bench.design.latency(),
            multipliers: size.multipliers,
            register_bits: size.register_bits,
            verilog: verilog::file_name(&module(number)),
        }
    }

    pub fn cells(&self) -> [String; 9] {
        [
            self.row.to_string(),
            self.title.to_owned(),
            self.method.to_owned(),
            self.mismatches.to_string(),
            format!("{:.3}", self.error.max_lsb),
            format!("{:.3}", self.error.rms_lsb),
            bound(self.bound_lsb.unwrap_or(f64::INFINITY)),
            self.latency.to_string(),
            self.multipliers.to_string(),
        ]
    }
}
