//! Pipelined fixed-point datapaths, described at run time on rust-hdl.
//!
//! [`builder`] is what units are written with; [`design`] is what comes out, [`block`] turns it
//! into rust-hdl blocks, and [`verilog`] prints those.
pub mod block;
pub mod builder;
pub mod design;
pub mod format;
pub mod graph;
mod packet;
pub mod pass;
mod port;
pub mod target;
pub mod verilog;

pub use builder::{BuildError, Builder};
pub use design::Design;
pub use format::{Format, FormatError};
pub use packet::SpanPacket;
pub use port::InputPort;
