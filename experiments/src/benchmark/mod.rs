//! Benchmarks of engines: each simulates the same spans, in each way of recording signals, and the
//! result is how many clocks per second it reaches.
//!
//! Spans are set up before anything is timed, and every engine reads them from memory (except
//! Icarus, whose test bench reads them from a file). A frame is repeated without an idle clock in
//! between, so that a run is long enough to be timed; slow engines simulate only its beginning.
//! Every run sums the codes of the pixels that leave, and the sums must be those of the bit-true
//! model, in every run of every engine.
//!
//! All waveforms contain the same signals. Verilator writes one time for each clock; Specula's
//! waveforms have two, for the edges of the clock.
//!
//! Rounds are interleaved: each measures every engine once, so that other work on the machine
//! disturbs all of them alike. The result is the median of the rounds; a ratio is one of two
//! medians of the same measurement.
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
pub use measurement::{EngineResult, Measurement, Skipped};
pub use progress::Step;
pub use rounds::{Budget, measure};
