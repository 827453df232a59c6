//! Drives a core with a scene's spans and compares every pixel with independent models.
//!
//! [`FrameSpans`] is the *driver*'s side: it sets up a frame's spans, once for a run, and
//! [`KeptSpans`] give them to the engine and to the models. The [`Monitor`]
//! collects the pixels that leave and the clocks in which they do. The *scoreboard* compares them
//! with the bit-true model and with exact shading ([`Comparison`]). The [`checker`] looks at the
//! facts that a core rests on, in every clock, and [`moved_input`] whether what holds for a frame
//! does. A [`Bench`] puts them together.
pub mod checker;
mod directions;
mod error;
mod expected;
mod fault;
mod image;
mod monitor;
mod run;
mod scoreboard;
mod spans;
pub mod statistics;
mod steady;
pub mod trace;

pub use checker::Violation;
pub use directions::WrongDirection;
pub use error::BenchError;
pub use expected::expected_codes;
pub use image::Image;
pub use monitor::Monitor;
pub use run::{Bench, EngineKind, Outcome, Progress};
pub use scoreboard::{Comparison, Mismatch, WorstPixel, WorstQuantisation};
pub use spans::{FrameSpans, KeptSpans};
pub use statistics::{ErrorFigures, Errors};
pub use steady::{MovedInput, Wrong, moved_input};
