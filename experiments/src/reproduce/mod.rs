//! What the papers claim and show, computed by our own code: whether it holds, and whether
//! docs/numerics.md's number comes out.
mod claim;
pub mod figure;
pub mod hast;
mod lecture;
mod lyon;
pub mod reshetov;
mod span_core;

use serde::Serialize;

use claim::Claim;
pub use claim::{Ground, Ruling, Verdict};
pub use figure::Figure;

/// A paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Paper {
    /// Lyon, TR 43.
    Lyon,
    /// Hast et al.
    Hast,
    /// The lecture on shading.
    Lecture,
    /// Reshetov, Soupikov and Mark.
    Reshetov,
}

impl Paper {
    /// Every paper.
    pub const ALL: [Paper; 4] = [Paper::Lyon, Paper::Hast, Paper::Lecture, Paper::Reshetov];

    /// The name that the command line uses.
    pub const fn name(self) -> &'static str {
        match self {
            Paper::Lyon => "lyon",
            Paper::Hast => "hast",
            Paper::Lecture => "lecture",
            Paper::Reshetov => "reshetov",
        }
    }

    /// Its authors and title.
    pub const fn title(self) -> &'static str {
        match self {
            Paper::Lyon => {
                "R. F. Lyon, Phong Shading Reformulation for Hardware Renderer Simplification"
            }
            Paper::Hast => {
                "A. Hast, T. Barrera and E. Bengtsson, Improved Shading Performance by Avoiding Vector Normalization"
            }
            Paper::Lecture => "Lecture 21, Shading",
            Paper::Reshetov => {
                "A. Reshetov, A. Soupikov and W. R. Mark, Consistent Normal Interpolation"
            }
        }
    }

    fn claims(self) -> Vec<&'static Claim> {
        match self {
            Paper::Lyon => lyon::claims(),
            Paper::Hast => hast::claims(),
            Paper::Lecture => lecture::CLAIMS.iter().collect(),
            Paper::Reshetov => reshetov::claims(),
        }
    }

    /// Computes what the paper claims.
    pub fn verdicts(self) -> Vec<Verdict> {
        self.claims().into_iter().map(|claim| claim.verdict(self)).collect()
    }

    /// The paper's figures that are curves.
    pub fn figures(self) -> Vec<Figure> {
        match self {
            Paper::Lyon => lyon::figures(),
            Paper::Hast | Paper::Lecture => vec![],
            Paper::Reshetov => reshetov::figures(),
        }
    }
}

/// Samples of a maximum.
const SAMPLES: u32 = 20_000;

/// The largest of `f` over 0 to 1.
fn largest(f: impl Fn(f64) -> f64) -> f64 {
    (0..=SAMPLES).map(|k| f(f64::from(k) / f64::from(SAMPLES))).fold(f64::NEG_INFINITY, f64::max)
}

/// Half an LSB of full scale.
const HALF_LSB: f64 = 0.5 / specula_spec::FULL_SCALE;
