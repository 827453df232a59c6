//! Engines that run an elaborated design clock by clock, and what they are given and give back.
//!
//! An engine takes a [`Stimulus`] and hands over the values of any signals at every clock, a batch
//! of clocks at a time, as a [`Batch`]. Clock c is the time between two rising edges: inputs of
//! clock c are applied, everything has settled, and the next edge ends it. Every run begins with
//! one clock of reset before its first clock, with all registers and inputs 0.
mod changes;
mod columns;
mod digits;
mod engine;
mod external;
pub mod fast;
pub mod fst;
pub mod gtkw;
mod icarus;
mod outline;
mod rust_hdl;
mod stimulus;
mod synthesis;
pub mod vcd;
mod verilator;

pub use columns::{Batch, Columns, Lanes};
pub use engine::{Engine, Flow, SimError};
pub use external::{Tool, temporary_directory};
pub use fast::Fast;
pub use icarus::{ICARUS, ICARUS_RUNTIME, Icarus};
pub use rust_hdl::RustHdl;
pub use stimulus::{FirstPixels, InputHold, SpanSource, Stimulus};
pub use synthesis::{Progress, Synthesised, cells, synthesise};
pub use verilator::{Effort, Keeping, Library, TimedVerilator, Timing, VERILATOR, Verilator};
