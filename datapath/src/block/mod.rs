//! A design as rust-hdl blocks: what rust-hdl checks and simulates, and what `verilog` prints.
mod logic;
mod lower;
mod module;
mod wire;

pub use module::{Cell, Child, Module};
pub use wire::{Wire, WireType};

pub use rust_hdl_core::atom::AtomKind;
pub use rust_hdl_core::check_error::{CheckError, check_all};
pub use rust_hdl_core::module_defines::generate_verilog;
pub use rust_hdl_core::simulate::simulate;
