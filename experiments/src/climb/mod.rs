//! The search for broken bounds: it climbs, starting at random scenes and cores, towards the
//! largest ratio of measured quantisation error to proven bound.
//!
//! Errors that a proof forgot show in corners that random sampling does not reach: a step that
//! rounds to 0 over a long span, or a component of a light just below half a unit in the last
//! place. A genome is a scene of spans and its `[core]` table; it is changed a little (`mutation`),
//! measured (`measure`), and kept if the ratio does not fall.
//!
//! Nothing is simulated on the way: the bit-true model gives the hardware's codes, as other tests
//! show. The scene at the end of a climb is simulated.
mod ascent;
mod core;
mod genome;
mod measure;
mod mutation;
mod random;
mod report;
mod search;
mod shrink;

pub use report::{MethodReport, Peak};
pub use search::{MAX_REPORTED, Search, climb};
