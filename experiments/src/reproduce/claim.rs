//! Claims of a paper: what is claimed, what is measured, and what follows.
use serde::Serialize;

use super::paper::Paper;

/// Half an LSB of full scale.
pub(super) const HALF_LSB: f64 = 0.5 / specula_spec::FULL_SCALE;

/// A claim.
pub(super) struct Claim {
    /// The claim as text.
    pub what: &'static str,
    /// The quantity that is measured, with its unit.
    pub quantity: &'static str,
    /// What the quantity is measured on.
    pub on: Ground,
    /// docs/numerics.md's number, and the tolerance: half a unit of its last digit if both are
    /// computed in f64 from the same formula, more if samples or a core's roundings differ, with
    /// the reason next to it.
    pub expected: (f64, f64),
    /// Measures the quantity; NaN if that is impossible.
    pub measure: fn() -> f64,
    /// Decides from the measured number whether the claim holds.
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
    /// The name in tables.
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
    /// It holds as stated.
    Holds,
    /// It holds within the named limits.
    HoldsWithin(&'static str),
    /// It does not hold, for the named reason.
    DoesNotHold(&'static str),
}

impl Ruling {
    /// `Holds` if `holds`; else `DoesNotHold` with the reason `why`.
    pub(super) const fn of(holds: bool, why: &'static str) -> Ruling {
        if holds { Ruling::Holds } else { Ruling::DoesNotHold(why) }
    }

    /// The ruling as text.
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
pub struct ClaimVerdict {
    /// The paper.
    pub paper: Paper,
    /// The claim as text.
    pub claim: &'static str,
    /// The quantity that is measured, with its unit.
    pub quantity: &'static str,
    /// What the quantity was measured on.
    pub on: Ground,
    /// The measured number.
    pub measured: f64,
    /// docs/numerics.md's number.
    pub expected: f64,
    /// Whether the measured number is the expected one within the claim's tolerance.
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
    pub fn verdict(&self, paper: Paper) -> ClaimVerdict {
        let (measured, (expected, tolerance)) = ((self.measure)(), self.expected);
        ClaimVerdict {
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
