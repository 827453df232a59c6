//! The Verilog of a core.
use specula_datapath::Design;
use specula_spec::CoreSpec;

use crate::header::{self, Origin};

/// A core as text.
pub fn text(origin: &Origin, spec: &CoreSpec, design: &Design) -> String {
    specula_datapath::verilog::print(&design.to_block(), &header::header(origin, spec, design))
}

/// The file that holds the module `module`: lint tools ask for the same name.
pub fn file_name(module: &str) -> String {
    format!("{module}.v")
}
