//! Requirements on a method, their results, and the verdict.
use serde::Serialize;

use super::limits::Reason;
use super::row::PixelPlace;

/// Description of the quantisation error where it has a bound.
pub const QUANTISATION: &str = "LSB of quantisation, within the proven bound";

/// The verdict on a method in a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum RowVerdict {
    /// All requirements are met, and no pixel is more than 1 LSB from exact shading.
    Holds,
    /// The method is farther from exact shading for a documented reason, but within the limit that
    /// follows from it.
    Limit,
    /// A requirement is not met.
    Fault,
}

impl RowVerdict {
    /// The name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            RowVerdict::Holds => "holds",
            RowVerdict::Limit => "limit",
            RowVerdict::Fault => "FAULT",
        }
    }
}

/// A requirement and its result.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Requirement {
    /// The requirement as text.
    pub what: String,
    /// Whether only this row requires it, rather than every row.
    pub of_row: bool,
    /// Number of cores that were checked.
    pub cores: usize,
    /// The largest allowed value; `None` if nothing bounds it.
    pub most: Option<f64>,
    /// The value of the core that comes closest to the limit.
    pub came: f64,
    /// The description of that core.
    pub core: String,
    /// The reasons why more than 1 LSB is allowed, if it is.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub reasons: Vec<Reason>,
    /// The place of the value.
    #[serde(skip)]
    pub place: Option<PixelPlace>,
    /// Further information, if the requirement is not met.
    #[serde(skip)]
    pub detail: Option<String>,
}

impl Requirement {
    /// The requirement that there are none of some things; `came` were found.
    pub fn none_of(what: impl Into<String>, came: u64, place: Option<PixelPlace>) -> Requirement {
        Requirement::within(what, Some(0.0), came as f64, place)
    }

    /// The requirement that a quantity does not exceed `most`, if there is a limit.
    pub fn within(
        what: impl Into<String>,
        most: Option<f64>,
        came: f64,
        place: Option<PixelPlace>,
    ) -> Requirement {
        Requirement {
            what: what.into(),
            of_row: false,
            cores: 1,
            most,
            came,
            core: String::new(),
            reasons: Vec::new(),
            place,
            detail: None,
        }
    }

    /// Whether the requirement is met. A NaN does not meet it.
    pub fn holds(&self) -> bool {
        self.most.is_none_or(|most| self.came <= most) && !self.came.is_nan()
    }

    /// The verdict on this requirement alone.
    pub fn verdict(&self) -> RowVerdict {
        match (self.holds(), self.reasons.is_empty()) {
            (false, _) => RowVerdict::Fault,
            (true, false) => RowVerdict::Limit,
            (true, true) => RowVerdict::Holds,
        }
    }

    /// Whether this is the quantisation error of cores with a proven bound.
    pub fn is_bounded_quantisation(&self) -> bool {
        self.what == QUANTISATION
    }

    /// The value and its limit in LSBs, as text.
    pub fn figure(&self) -> String {
        match self.most {
            Some(most) => format!("{:.1} of {most:.1}", self.came),
            None => format!("{:.1}, no limit", self.came),
        }
    }

    /// The value as a share of its limit.
    fn share(&self) -> f64 {
        if !self.holds() {
            return f64::INFINITY;
        }
        self.came / self.most.filter(|&most| most > 0.0).unwrap_or(1.0)
    }

    /// Merges the result of the same requirement on other cores: the one that is closest to its
    /// limit counts, and the first of two equal ones.
    fn merge(&mut self, other: Requirement) {
        let cores = self.cores + other.cores;
        if other.share() > self.share() {
            *self = other;
        }
        self.cores = cores;
    }

    /// Adds a result of one more core.
    pub fn add_to(all: &mut Vec<Requirement>, one: Requirement) {
        match all.iter_mut().find(|asked| asked.what == one.what) {
            Some(asked) => asked.merge(one),
            None => all.push(one),
        }
    }
}
