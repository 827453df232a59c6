//! Shading hardware, described at run time on rust-hdl.
//!
//! [`builder`] is what units are written with; [`units`] and [`cores`] are the hardware; [`design`]
//! is what comes out, [`block`] turns it into rust-hdl blocks, and [`verilog`] prints those.
pub mod block;
pub mod builder;
pub mod cores;
pub mod design;
pub mod target;
pub mod units;
pub mod verilog;

pub use cores::elaborate;
pub use design::Design;
pub use specula_scene::SpanPacket;
