//! What is asked of a method, what came, and the verdict.
use serde::Serialize;

use super::limits::Reason;
use super::row::Place;

/// The error of quantisation where it has a bound.
pub const QUANTISATION: &str = "LSB of quantisation, within the proven bound";

/// What a method's row comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// All that is asked happens, and no pixel is more than 1 LSB from exact shading.
    Holds,
    /// The method is farther from exact shading, for a documented reason, and within the limit that
    /// this sets.
    Limit,
    /// Something that is asked does not happen.
    Fault,
}

impl Verdict {
    /// Its name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Limit => "limit",
            Verdict::Fault => "FAULT",
        }
    }
}

/// One thing that is asked, and what came of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Asked {
    /// What.
    pub what: String,
    /// Whether the row asks it, and not every row.
    pub of_row: bool,
    /// Of how many cores.
    pub cores: usize,
    /// The most that may come; none where nothing bounds it.
    pub most: Option<f64>,
    /// What came, of the core that comes nearest to the most.
    pub came: f64,
    /// That core.
    pub core: String,
    /// Why more than 1 LSB may come, if so much may.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub reasons: Vec<Reason>,
    /// Where.
    #[serde(skip)]
    pub place: Option<Place>,
    /// What else is known of it, if it does not happen.
    #[serde(skip)]
    pub detail: Option<String>,
}

impl Asked {
    /// A number of things of which there must be none.
    pub fn none_of(what: impl Into<String>, came: u64, place: Option<Place>) -> Asked {
        Asked::within(what, Some(0.0), came as f64, place)
    }

    /// A quantity that `most` bounds, if anything does.
    pub fn within(
        what: impl Into<String>,
        most: Option<f64>,
        came: f64,
        place: Option<Place>,
    ) -> Asked {
        Asked {
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

    /// Whether it happened. What is no number did not.
    pub fn holds(&self) -> bool {
        self.most.is_none_or(|most| self.came <= most) && !self.came.is_nan()
    }

    /// What it comes to by itself.
    pub fn verdict(&self) -> Verdict {
        match (self.holds(), self.reasons.is_empty()) {
            (false, _) => Verdict::Fault,
            (true, false) => Verdict::Limit,
            (true, true) => Verdict::Holds,
        }
    }

    /// Whether it is the error of quantisation of cores with a proven bound.
    pub fn is_of_bound(&self) -> bool {
        self.what == QUANTISATION
    }

    /// What came, and of how much, in LSBs.
    pub fn figure(&self) -> String {
        match self.most {
            Some(most) => format!("{:.1} of {most:.1}", self.came),
            None => format!("{:.1}, no limit", self.came),
        }
    }

    /// How much of what may come has come.
    fn share(&self) -> f64 {
        if !self.holds() {
            return f64::INFINITY;
        }
        self.came / self.most.filter(|&most| most > 0.0).unwrap_or(1.0)
    }

    /// The same thing, asked of other cores too: the one that comes nearest counts, and the first
    /// of two alike.
    fn merge(&mut self, other: Asked) {
        let cores = self.cores + other.cores;
        if other.share() > self.share() {
            *self = other;
        }
        self.cores = cores;
    }

    /// Adds what was asked of one more core.
    pub fn add_to(all: &mut Vec<Asked>, one: Asked) {
        match all.iter_mut().find(|asked| asked.what == one.what) {
            Some(asked) => asked.merge(one),
            None => all.push(one),
        }
    }
}
