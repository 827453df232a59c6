//! What external simulators have in common: the emitted Verilog in a temporary directory, a file
//! that holds the stimulus, and files from which values come back.
mod batches;
mod ports;
mod results;
mod stimulus;
pub mod tool;
mod trace;
mod workshop;

pub use ports::{Port, Ports};
pub use results::read_results;
pub use tool::{OTHER_ENGINE, Tool};
pub use trace::{Sampling, Trace};
pub use workshop::{RESULTS, STIMULUS, TRACE, Workshop, temporary_directory};
