//! The results of the search.
use serde::Serialize;

/// A scene with a high ratio, or with a fault.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Peak {
    /// The largest quantisation error divided by the bound; above 1 the bound is broken.
    pub ratio: f64,
    /// The largest quantisation error, in LSBs.
    pub quantisation_lsb: f64,
    /// The proven bound, in LSBs.
    pub bound_lsb: f64,
    /// Another fault, if there is one.
    pub fault: Option<String>,
    /// The scene file with its `[core]` table, which `specula run` accepts.
    #[serde(skip)]
    pub scene: String,
}

impl Peak {
    /// Whether the scene shows a fault.
    pub fn is_wrong(&self) -> bool {
        self.ratio > 1.0 || self.fault.is_some()
    }
}

/// The results with one method.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MethodReport {
    /// The method.
    pub method: &'static str,
    /// Number of scenes tried.
    pub scenes: u64,
    /// Number of these for which there is no core.
    pub refused: u64,
    /// Number of these whose bound is 255 LSB or more and therefore says nothing.
    pub without_bound: u64,
    /// Number of scenes until the first bound was broken, if one was.
    pub first_broken_after: Option<u64>,
    /// Number of climbers that broke a bound.
    pub climbers_that_broke_one: usize,
    /// The scene with the largest ratio; `None` if no scene had a bound.
    pub largest: Option<Peak>,
    /// Scenes with faults, minimised: broken bounds, those with the largest ratio first, then other
    /// faults.
    pub wrong: Vec<Peak>,
}

impl MethodReport {
    /// Whether no fault was found.
    pub fn holds(&self) -> bool {
        self.wrong.is_empty()
    }
}
