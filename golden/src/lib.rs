//! The truth that hardware is compared with.
//!
//! - [`exact`] shades in f64 and is written to be read beside the papers: true Phong shading, and a
//!   core's method without any rounding. Their difference is the *method error*.
//! - [`fixed`] computes what a core must give, bit for bit, from `docs/arithmetic.md` and the
//!   `CoreSpec`. Its difference from the method in f64 is the *quantisation error*.
//! - [`software`] runs each paper's loop in f32, for its run time, on the [`recurrence`]s that
//!   [`operations`] counts.
//!
//! Nothing here knows how hardware is pipelined.
pub mod exact;
pub mod fixed;
pub mod operations;
pub mod recurrence;
pub mod software;
