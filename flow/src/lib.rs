//! What stands around a core on its way into a device: streams, registers, vectors, benches, host code,
//! synthesis with place-and-route, and the program that measures the delays of a target's table with
//! it.
pub mod host;
pub mod measure;
pub mod stream;
pub mod synth;
