//! What a paper claims, what is measured for it, and what follows.
use serde::Serialize;

use super::paper::Paper;

/// Half an LSB of full scale.
pub(super) const HALF_LSB: f64 = 0.5 / specula_spec::FULL_SCALE;

/// A claim.
pub(super) struct Claim {
    /// What is claimed.
    pub what: &'static str,
    /// What is measured, with its unit.
    pub quantity: &'static str,
    /// What measures it.
    pub on: Ground,
    /// docs/numerics.md's number, and how far from it the measured one may be: half a unit of
    /// its last digit where both are computed in f64 from the same formula, more where samples or a
    /// core's roundings differ, with the reason beside it.
    pub expected: (f64, f64),
    /// Measures it; NaN if it cannot.
    pub measure: fn() -> f64,
    /// What follows from what was measured.
    pub judge: fn(f64) -> Ruling,
}

/// What a claim was measured on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Ground {
    /// `golden::exact`, in f64.
    Exact,
    /// A core: its bit-true model, which the simulated core equals on every pixel.
    Core,
}

impl Ground {
    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Ground::Exact => "f64",
            Ground::Core => "core",
        }
    }
}

/// Whether a claim holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "ruling", content = "why")]
pub enum Ruling {
    /// It holds as it stands.
    Holds,
    /// It holds within the limits named.
    HoldsWithin(&'static str),
    /// It does not, for the reason named.
    DoesNotHold(&'static str),
}

impl Ruling {
    /// Holds if `true`; else it does not, for the reason `why`.
    pub(super) const fn of(holds: bool, why: &'static str) -> Ruling {
        if holds { Ruling::Holds } else { Ruling::DoesNotHold(why) }
    }

    /// In words.
    pub fn words(self) -> String {
        match self {
            Ruling::Holds => "holds".to_owned(),
            Ruling::HoldsWithin(limits) => format!("holds within {limits}"),
            Ruling::DoesNotHold(why) => format!("does not hold: {why}"),
        }
    }
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
    /// What measures it.
    pub on: Ground,
    /// What came out.
    pub measured: f64,
    /// docs/numerics.md's number.
    pub expected: f64,
    /// Whether that came out, as near as the claim's tolerance says.
    pub as_expected: bool,
    /// Whether the claim holds.
    #[serde(flatten)]
    pub ruling: Ruling,
}

/// A claim about exact arithmetic.
pub(super) const fn exact(
    what: &'static str,
    quantity: &'static str,
    expected: (f64, f64),
    measure: fn() -> f64,
    judge: fn(f64) -> Ruling,
) -> Claim {
    Claim { what, quantity, on: Ground::Exact, expected, measure, judge }
}

impl Claim {
    pub fn verdict(&self, paper: Paper) -> Verdict {
        let (measured, (expected, tolerance)) = ((self.measure)(), self.expected);
        Verdict {
            paper,
            claim: self.what,
            quantity: self.quantity,
            on: self.on,
            measured,
            expected,
            as_expected: (measured - expected).abs() <= tolerance,
            ruling: (self.judge)(measured),
        }
    }
}
