//! Cores that are run, and what leaves them.
use specula_scene::Frame;
use specula_spec::CoreSpec;
use specula_testbench::{Bench, EngineKind, Outcome};

/// Runs a core: every pixel is the model's and leaves in its clock, every stated fact holds, and no
/// error exceeds its bound.
pub fn assert_agrees(core: &CoreSpec, frame: &Frame) -> Outcome {
    let bench = Bench::new(frame, core, "core").unwrap();
    let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.fault(), None, "{core:?}");
    outcome
}

/// The red codes of a row, from left to right; the frames here are grey.
pub fn row(outcome: &Outcome, frame: &Frame, number: usize) -> Vec<u8> {
    let first = number * frame.width as usize;
    let length = frame.spans[number].length as usize;
    outcome.simulated.pixels[first..first + length].iter().map(|code| code[0]).collect()
}

/// The red codes of a frame's only span.
pub fn codes(core: &CoreSpec, frame: &Frame) -> Vec<u8> {
    row(&assert_agrees(core, frame), frame, 0)
}
