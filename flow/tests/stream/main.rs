//! Cores with streams and registers around them, as simulators run them from the emitted files.
mod block;
mod block_ram;
mod data_sheet;
mod fusesoc;
mod handshake;
mod layout;
mod malformed;
mod model;
mod packages;
mod proof;

use block::{Block, core, frames, shapes};
use specula_fixtures::{each_method, tools};
use specula_spec::{Components, Method};

/// Frames of two kinds of light and material one after the other, of cores whose lights have a
/// pipeline each, of those that share one and of one whose components take turns, in words of both
/// widths, with positions and without: as `make sim` says, which stands for what `model` does with
/// every method.
#[test]
fn make_sim_passes() {
    if !["iverilog", "make"].into_iter().all(tools::is_installed) {
        return;
    }
    let frames = frames(7);
    for (number, shape) in shapes().into_iter().enumerate() {
        let mut spec = core(Method::Lyon, &frames, number % 2 == 1);
        if number == 2 {
            spec.parameters.components = Components::Serial;
        }
        let block = Block::new(&spec, &frames, shape);
        for seed in [0, 1 + number as u32] {
            let said = block.make(&["sim", &format!("SEED={seed}")]);
            assert!(said.contains("\nPASS: "), "{shape:?} {seed}: {said}");
        }
    }
}

/// No tool warns of any file.
fn files_are_clean(method: Method) {
    if !["iverilog", "verilator", "yosys", "make"].into_iter().all(tools::is_installed) {
        return;
    }
    let frames = frames(8);
    let shapes = shapes();
    for (shared, shape) in [(false, shapes[0]), (true, shapes[3])] {
        let spec = core(method, &frames, shared);
        Block::new(&spec, &frames, shape).make(&["lint"]);
        let spec = spec.specialised(&frames[0]);
        Block::new(&spec, &frames[..1], shape).make(&["lint"]);
    }
}

each_method!(files_are_clean);

#[test]
fn verilator_runs_the_same_bench() {
    if !["verilator", "make"].into_iter().all(tools::is_installed) {
        return;
    }
    let frames = frames(9);
    let spec = core(Method::Lyon, &frames, false);
    let block = Block::new(&spec, &frames, shapes()[0]);
    for seed in [0, 3] {
        let said = block.make(&["sim-verilator", &format!("SEED={seed}")]);
        assert!(said.contains("\nPASS: "), "{said}");
    }
}

/// Spans of 8 pixels and more follow each other without an idle clock.
#[test]
fn spans_whose_packets_arrive_in_time_take_a_clock_a_pixel() {
    if !["iverilog", "make"].into_iter().all(tools::is_installed) {
        return;
    }
    let mut frame = frames(10).swap_remove(0);
    let spans = frame.spans.clone();
    frame.spans = spans.iter().cycle().take(400).cloned().collect();
    for (span, length) in frame.spans.iter_mut().zip([8, 9, 12].into_iter().cycle()) {
        span.length = length;
    }
    let spec = core(Method::Gouraud, std::slice::from_ref(&frame), false);
    for shape in shapes() {
        let block = Block::new(&spec, std::slice::from_ref(&frame), shape);
        assert!(block.words_a_packet < 8);
        let said = block.make(&["sim", "SEED=0"]);
        let numbers: Vec<u32> = said
            .lines()
            .find_map(|line| line.strip_prefix("PASS: "))
            .expect("it passes")
            .split(' ')
            .filter_map(|word| word.parse().ok())
            .collect();
        let (pixels, clocks) = (numbers[0], numbers[1]);
        // What the first packet takes, and the last pixel's way.
        assert!(clocks <= pixels + block.latency + 16, "{shape:?}: {said}");
    }
}
