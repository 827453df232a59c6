//! Drives a core with a scene's spans, compares every pixel with independent models, and measures
//! error and run time.
mod arrival;
mod assumptions;
pub mod bench;
pub mod climb;
mod compare;
mod error;
pub mod explore;
pub mod figure9;
mod image;
pub mod operations;
mod pareto;
pub mod reproduce;
mod run;
mod savings;
pub mod search;
mod shares;
mod spans;
mod statistics;
pub mod stress;
pub mod trace;
pub mod tradeoff;

pub use assumptions::Violation;
pub use compare::{Comparison, Mismatch, WorstPixel, WorstQuantisation};
pub use error::BenchError;
pub use image::Image;
pub use pareto::pareto_front;
pub use run::{Bench, EngineKind, Outcome, Progress};
pub use savings::{
    AgainstGeneral, Baseline, Saving, Savings, Spared, SparedCells, Synthesis, savings,
};
pub use shares::{Share, shares};
pub use spans::FrameSpans;
pub use statistics::{ErrorFigures, Errors};
