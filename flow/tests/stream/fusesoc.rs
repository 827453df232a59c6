//! FuseSoC runs the targets of a block's `.core` file.
use std::fs;

use specula_fixtures::tools;
use specula_spec::{CoreSpec, Method, TargetClock};

use crate::block::{Block, core, frames, shapes};

/// Whether FuseSoC and these programs are there.
fn are_installed(programs: &[&str]) -> bool {
    ["fusesoc", "python3", "make"]
        .iter()
        .chain(programs)
        .all(|program| tools::is_installed(program))
}

/// Runs a target; whether it succeeds, and what it prints.
fn run(block: &Block, target: &str) -> (bool, String) {
    let target = format!("--target={target}");
    block.run("fusesoc", &["--cores-root", ".", "run", &target, "specula:cores:shader_ip"])
}

/// The shortest core with inputs that hold for a frame, and positions.
fn block() -> Block {
    let frames = frames(18);
    Block::new(&core(Method::Gouraud, &frames, false), &frames, shapes()[0])
}

#[test]
fn the_bench_runs_and_tells_a_wrong_pixel() {
    if !are_installed(&["iverilog"]) {
        return;
    }
    let block = block();
    let (succeeded, said) = run(&block, "sim");
    assert!(succeeded && said.contains("\nPASS: "), "{said}");
    block.spoil_pixel(7);
    let (succeeded, said) = run(&block, "sim");
    assert!(!succeeded && said.contains("\nFAIL: pixel 7 is"), "{said}");
}

#[test]
fn the_cocotb_test_runs_and_tells_a_wrong_pixel() {
    if !are_installed(&["iverilog", "cocotb-config"]) {
        return;
    }
    let block = block();
    for target in [&["cocotb"][..], &["cocotb", "SEED=0"], &["cocotb", "SEED=5"]] {
        let said = block.make(target);
        assert!(said.contains(" PASS: "), "{said}");
        for frame in ["shader_frame_0.png", "shader_frame_1.png"] {
            let png = fs::read(block.path(frame)).expect("the frame is a picture");
            assert!(png.starts_with(b"\x89PNG"));
            fs::remove_file(block.path(frame)).expect("it can be removed");
        }
    }
    let (succeeded, said) = run(&block, "cocotb");
    assert!(succeeded && said.contains(" PASS: "), "{said}");
    block.spoil_pixel(7);
    let (succeeded, said) = run(&block, "cocotb");
    assert!(!succeeded && said.contains("FAIL: pixel 7, at "), "{said}");
}

#[test]
fn the_linter_and_synthesis_take_the_block() {
    if !are_installed(&["verilator", "yosys"]) {
        return;
    }
    let block = block();
    for target in ["lint", "synth"] {
        let (succeeded, said) = run(&block, target);
        assert!(succeeded, "{target}: {said}");
    }
}

/// A small core goes through place-and-route with its ports at the pins of an iCE40.
#[test]
fn a_small_core_is_placed_and_routed() {
    if !are_installed(&["yosys", "nextpnr-ice40"]) {
        return;
    }
    let frames = &frames(18)[..1];
    let spec = core(Method::Gouraud, frames, false).specialised(&frames[0]);
    let target = TargetClock { name: "ice40hx".to_owned(), clock_mhz: 40.0 };
    let spec = CoreSpec { target: Some(target), ..spec };
    let block = Block::new(&spec, frames, shapes()[1]);
    let (succeeded, said) = run(&block, "ice40");
    assert!(succeeded && said.contains("Max frequency for clock"), "{said}");
}
