//! What the papers claim, computed by our own code: whether it holds, and whether NUMERICS.md's number comes out.
mod hast;
mod lecture;
mod lyon;
mod reshetov;

use serde::Serialize;

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

    fn claims(self) -> &'static [Claim] {
        match self {
            Paper::Lyon => &lyon::CLAIMS,
            Paper::Hast => &hast::CLAIMS,
            Paper::Lecture => &lecture::CLAIMS,
            Paper::Reshetov => &reshetov::CLAIMS,
        }
    }

    /// Computes what the paper claims.
    pub fn verdicts(self) -> Vec<Verdict> {
        self.claims().iter().map(|claim| claim.verdict(self)).collect()
    }
}

/// A claim.
struct Claim {
    /// What is claimed.
    what: &'static str,
    /// What is measured, with its unit.
    quantity: &'static str,
    /// NUMERICS.md's number, and half a unit of its last digit.
    expected: (f64, f64),
    /// Measures it.
    measure: fn() -> f64,
    /// Whether the claim holds for what was measured.
    holds: fn(f64) -> bool,
}

/// A claim, computed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Verdict {
    /// The paper.
    pub paper: Paper,
    /// What is claimed.
    pub claim: &'static str,
    /// What is measured, with its unit.
    pub quantity: &'static str,
    /// What came out.
    pub measured: f64,
    /// NUMERICS.md's number.
    pub expected: f64,
    /// Whether that came out, to its last digit.
    pub as_expected: bool,
    /// Whether the claim holds.
    pub holds: bool,
}

impl Claim {
    fn verdict(&self, paper: Paper) -> Verdict {
        let (measured, (expected, tolerance)) = ((self.measure)(), self.expected);
        Verdict {
            paper,
            claim: self.what,
            quantity: self.quantity,
            measured,
            expected,
            as_expected: (measured - expected).abs() <= tolerance,
            holds: (self.holds)(measured),
        }
    }
}

/// Samples of a maximum.
const SAMPLES: u32 = 20_000;

/// The largest of `f` over 0 to 1.
fn largest(f: impl Fn(f64) -> f64) -> f64 {
    (0..=SAMPLES).map(|k| f(f64::from(k) / f64::from(SAMPLES))).fold(f64::NEG_INFINITY, f64::max)
}
