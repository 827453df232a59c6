//! The search for broken bounds: it climbs, from random scenes and cores on, towards the largest
//! ratio of the measured quantisation error to the proven bound.
//!
//! Errors that a proof forgot show in corners which random drawing does not meet: a step that
//! rounds to 0 over a long span, a component of a light that is just short of half a unit in the
//! last place. A genome is a scene of spans and what its `[core]` table asks for; it is changed a
//! little (`mutation`), measured (`measure`), and kept where the ratio does not fall.
//!
//! Nothing is simulated on the way: the bit-true model gives the hardware's codes, as other tests
//! show. What a climb ends with is.
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
pub use search::{MOST_TOLD, Search, climb};
