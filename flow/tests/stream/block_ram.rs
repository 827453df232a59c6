//! The block RAM of an ECP5 that a block asks for by name.
use std::fs;

use specula_fixtures::tools;
use specula_spec::{CoreSpec, Method, TargetClock};

use crate::block::{Block, core, frames, shapes};

/// What synthesis sees of the memory for pixels does what simulators see of it, in memories of as
/// many places as the core needs, and of as many as there are.
#[test]
fn block_ram_is_the_memory_that_simulators_see() {
    if !tools::is_installed("iverilog") {
        return;
    }
    let frames = frames(22);
    let target = TargetClock { name: "ecp5".to_owned(), clock_mhz: 200.0 };
    let spec = CoreSpec { target: Some(target), ..core(Method::Lyon, &frames, false) };
    let block = Block::new(&spec, &frames, shapes()[1]);
    let written = |name: &str, text: &str| {
        fs::write(block.path(name), text).expect("it can be written");
    };
    written("block_ram.v", include_str!("block_ram.v"));
    written("DP16KD.v", include_str!("../../models/DP16KD.v"));
    for log2_depth in ["6", "9"] {
        let depth = format!("-DLOG2_DEPTH={log2_depth}");
        let files = ["block_ram.v", "shader_axis.v", "DP16KD.v"];
        let options = ["-g2005", "-DSYNTHESIS", &depth, "-s", "block_ram", "-o", "block_ram.vvp"];
        let (compiled, said) = block.run("iverilog", &[&options[..], &files].concat());
        assert!(compiled, "{said}");
        let (_, said) = block.run("vvp", &["-n", "block_ram.vvp"]);
        assert_eq!(said, "PASS\n");
    }
}
