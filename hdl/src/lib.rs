//! Shading hardware, described at run time on rust-hdl.
//!
//! [`units`] and [`cores`] are written with the builder of [`specula_datapath`]; a core comes out as
//! a [`specula_datapath::Design`]. [`error`] proves how far their results are off.
pub mod cores;
pub mod error;
pub mod units;

pub use cores::{clock_limit, elaborate, error_bound, highest_clock};

use specula_spec::CoreSpec;

/// A name for the module of a scene's core, as [`specula_datapath::verilog::module_name`] makes it.
pub fn module_name(scene: &str, spec: &CoreSpec) -> String {
    let inputs = spec.inputs();
    specula_datapath::verilog::module_name(scene, inputs.iter().map(|port| port.name.as_str()))
}
