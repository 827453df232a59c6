//! The operations per pixel in the paper, in the inner loops and in the cores.
use glam::DVec3;
use specula_golden::loops::Line;
pub use specula_golden::loops::operations::Operations;
use specula_golden::loops::operations::{SchemeRow, TABLE};
use specula_scene::frame::EYE;
use specula_scene::{Frame, load};

use super::super::claim::{Claim, Ground, Ruling};
use crate::operations::{Contents, HAST};
use specula_testbench::BenchError;

/// A scheme of the paper.
#[derive(Clone, Debug)]
pub struct Scheme {
    /// Its equations, with their numbers in docs/methods.md.
    pub source: &'static str,
    /// The operations that the paper states.
    pub printed: Operations,
    /// The operations of the inner loop.
    pub counted: Operations,
    /// The operations of the core.
    pub core: Contents,
    /// Number of products that replace divisions, where the core has a reciprocal already.
    pub further_products: usize,
}

impl Scheme {
    /// Whether the core's operations are the printed ones, if a root with its division counts as
    /// one, and a product that replaces a division counts as a division.
    pub fn core_agrees(&self) -> bool {
        let printed = &self.printed;
        let (core, count) = (&self.core, |n: u32| n as usize);
        core.accumulators == count(printed.adds)
            && core.reciprocal_roots == count(printed.square_roots)
            && core.dividers + core.reciprocal_roots == count(printed.divisions)
            && core.multipliers == count(printed.multiplies) + self.further_products
    }
}

/// The schemes that have cores, elaborated for `frame`.
///
/// # Errors
/// [`BenchError`] if a core cannot be built for the frame.
pub fn schemes(frame: &Frame) -> Result<Vec<Scheme>, BenchError> {
    let row = |name: &str| TABLE.iter().find(|row| row.name == name);
    let pairs = HAST.iter().filter_map(|counterpart| Some((counterpart, row(counterpart.row)?)));
    let scheme = |(counterpart, row): (&crate::operations::Counterpart, &SchemeRow)| {
        Ok(Scheme {
            source: row.source,
            printed: row.printed,
            counted: counted(row),
            core: counterpart.contents(frame)?,
            further_products: counterpart.further_products,
        })
    };
    pairs.map(scheme).collect()
}

/// The operations of a row's inner loop for a pixel, which are the same for every pixel.
fn counted(row: &SchemeRow) -> Operations {
    let ends = [DVec3::Z, DVec3::new(0.6, 0.0, 0.8)];
    let weights = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let vertices = [ends[0], ends[1], DVec3::Z];
    let line = Line { ends, steps: 8, vertices, face: DVec3::Z, weights, shininess: 16, eye: EYE };
    (row.counted)(&line, DVec3::new(0.0, 0.6, 0.8))
}

/// Number of rows of the table whose loop has other operations than are printed.
fn miscounted() -> f64 {
    TABLE.iter().filter(|row| row.source.contains("Hast") && counted(row) != row.printed).count()
        as f64
}

/// Number of schemes whose cores have other operations than are printed, except for products that
/// replace divisions.
fn different_cores() -> f64 {
    let schemes =
        load("teapot", Some((160, 120))).ok().and_then(|scene| schemes(&scene.frame).ok());
    schemes.map_or(f64::NAN, |schemes| {
        schemes.iter().filter(|scheme| !scheme.core_agrees()).count() as f64
    })
}

fn none(wrong: f64) -> Ruling {
    Ruling::of(wrong == 0.0, "some differ")
}

/// Claims about the counts, which are scattered over the paper's text.
pub(super) const CLAIMS: [Claim; 2] = [
    Claim {
        what: "additions, multiplications, divisions and roots of the schemes",
        quantity: "inner loops that do others than are printed",
        on: Ground::Exact,
        expected: (0.0, 0.0),
        measure: miscounted,
        judge: none,
    },
    Claim {
        what: "additions, multiplications, divisions and roots of the schemes",
        quantity: "cores that do others than are printed, but for the products named below",
        on: Ground::Core,
        expected: (0.0, 0.0),
        measure: different_cores,
        judge: none,
    },
];
