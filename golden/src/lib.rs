//! The reference with which hardware is compared.
//!
//! - [`exact`] shades in f64 and is written to be read next to the papers: exact Phong shading, and
//!   a core's method without any rounding. Their difference is the *method error*.
//! - [`fixed`] computes what a core must output, bit for bit, from `docs/arithmetic.md` and the
//!   `CoreSpec`. Its difference from the method in f64 is the *quantisation error*.
//! - [`loops`] has the papers' inner loops, runs them in f32 for their run time
//!   ([`loops::software`]), and counts their operations ([`loops::operations`]).
//!
//! Nothing here knows how hardware is pipelined.
pub mod exact;
pub mod fixed;
pub mod loops;
