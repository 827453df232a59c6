//! Drives a core with a scene's spans, compares every pixel with independent models, and measures error and run time.
mod arrival;
mod assumptions;
pub mod bench;
mod compare;
mod error;
pub mod figure9;
mod image;
pub mod reproduce;
mod run;
mod savings;
pub mod search;
mod spans;
mod statistics;
pub mod stress;
pub mod trace;

pub use assumptions::Violation;
pub use compare::{Comparison, Mismatch, WorstPixel};
pub use error::BenchError;
pub use image::Image;
pub use run::{Bench, EngineKind, Outcome, Progress};
pub use savings::{Saving, Savings, Spared, savings};
pub use spans::FrameSpans;
pub use statistics::{ErrorFigures, Errors};
