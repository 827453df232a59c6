//! All engines against each other, and against what was meant.
mod agreement;
mod cores;
mod delays;
mod dump;
mod frames;
mod installed;
mod netlists;
mod number;
mod operators;
mod pausing;
mod program;
mod waves;
mod waves_of_engines;

use specula_datapath::Design;
use specula_datapath::design::NodeId;
use specula_spec::CoreSpec;

/// A core, elaborated.
fn elaborated(spec: &CoreSpec) -> Design {
    specula_hdl::elaborate(spec, spec.method().name()).unwrap()
}

/// Outputs, and the bit that says when they count.
fn outputs(design: &Design) -> Vec<NodeId> {
    [design.valid_out].iter().chain(&design.outputs).copied().collect()
}
