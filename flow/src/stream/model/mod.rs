//! The stream top `NAME_axis` and the bench around it, clock by clock, as a model that any engine can
//! be put into.
//!
//! When a pixel leaves a core does not depend on its values: its validity is delayed by the core's
//! depth. So the model runs first, with numbers in place of colours ([`StreamRun`]). It says in which
//! clock each time slot goes in, and in which clock which pixel is taken at `m_axis`. An engine then
//! runs the core with these clocks; that pixels leave it when the model expects them to is the
//! testbench's to check.
//!
//! A register of the Verilog has a field of the same meaning here. Clock c is the time before the
//! rising edge that ends it, counted from the first clock without reset. Malformed packets are no part
//! of the model, as a bench sends none.
mod bench;
mod packet_buffer;
mod pixel_memory;
mod random;
mod register_host;
mod registers;
mod run;
mod span_stage;
mod top;

pub use run::{StreamRun, Stuck};
