//! What the search found.
use serde::Serialize;

/// A scene that stands high, or is wrong.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Peak {
    /// The largest quantisation error by the bound; above 1 the bound is broken.
    pub ratio: f64,
    /// The largest quantisation error, in LSBs.
    pub quantisation_lsb: f64,
    /// The proven bound, in LSBs.
    pub bound_lsb: f64,
    /// What else is wrong.
    pub fault: Option<String>,
    /// The scene file with its `[core]` table, which `specula run` takes.
    #[serde(skip)]
    pub scene: String,
}

impl Peak {
    /// Whether this must not be.
    pub fn is_wrong(&self) -> bool {
        self.ratio > 1.0 || self.fault.is_some()
    }
}

/// What was found with one method.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MethodReport {
    /// The method.
    pub method: &'static str,
    /// Scenes that were tried.
    pub scenes: u64,
    /// Those of them for which there is no core.
    pub refused: u64,
    /// Those of which the bound is 255 LSB or more, and so says nothing.
    pub without_bound: u64,
    /// Scenes until the first bound was broken, if one was.
    pub first_broken_after: Option<u64>,
    /// Climbers that broke a bound.
    pub climbers_that_broke_one: usize,
    /// That with the largest ratio; none where no scene had a bound.
    pub largest: Option<Peak>,
    /// What must not be, made small: broken bounds, those with the largest ratio first, and other
    /// faults.
    pub wrong: Vec<Peak>,
}

impl MethodReport {
    /// Whether nothing is wrong.
    pub fn holds(&self) -> bool {
        self.wrong.is_empty()
    }
}
