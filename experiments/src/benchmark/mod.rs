//! Measuring engines against each other: the same spans through each of them, in each way of
//! keeping signals, and how many clocks a second each comes to.
//!
//! Spans are set up before anything is timed, and every engine reads them from memory (but Icarus,
//! whose testbench reads them from a file). A frame is repeated without an idle clock between, so
//! that a measurement is long enough for the clock it is timed by; slow engines get the beginning
//! of it. Every run adds up the codes of the pixels that leave, and the sums must be those of the
//! bit-true model, in every run of every engine.
//!
//! Waveforms hold the same signals. Verilator writes each clock at one time; ours have two, for the
//! edges of the clock.
//!
//! Rounds are interleaved: each measures every engine once, so that what else the machine does
//! meets all of them alike. What counts is the median of the rounds, and a ratio of two medians of
//! the same run.
mod batch_sink;
mod checksum;
mod clocked;
mod config;
mod error;
mod external;
mod in_process;
mod machine;
mod measurement;
mod progress;
mod roster;
mod rounds;
mod runner;
mod scratch;
mod workload;

pub use config::{Config, Mode};
pub use error::MeasureError;
pub use machine::Machine;
pub use measurement::{Measurement, Row, Skipped};
pub use progress::Step;
pub use rounds::{Budget, measure};
