//! The cases of docs/extremes.md that concern the model; numbers in names and comments are its
//! rows.
mod both;
mod consistent;
mod degenerate;
mod lyon;
mod powers;
mod spans;

use specula_fixtures::specs::packet;
use specula_golden::exact;
use specula_golden::fixed::{Model, Observation};
use specula_scene::Frame;
use specula_spec::CoreSpec;

/// Every code of a frame's span, red alone; the frames here are grey.
fn codes(core: &CoreSpec, frame: &Frame) -> Vec<u8> {
    let mut codes = Vec::new();
    Model::new(core).shade(&packet(core, frame), &mut codes).expect("the packet is this core's");
    codes.into_iter().map(|code| code[0]).collect()
}

fn trace(core: &CoreSpec, frame: &Frame, i: u32) -> Vec<Observation> {
    Model::new(core).trace(&packet(core, frame), i).expect("the packet is this core's")
}

/// The value of that name.
fn value(trace: &[Observation], name: &str) -> f64 {
    observation(trace, name).value()
}

fn observation<'a>(trace: &'a [Observation], name: &str) -> &'a Observation {
    Observation::named(trace, name).unwrap_or_else(|| panic!("no value is named {name}"))
}

/// The method in f64 at every pixel, 0..=255 LSB.
fn method(core: &CoreSpec, frame: &Frame) -> Vec<f64> {
    let span = &frame.spans[0];
    (0..span.length).map(|i| exact::method(core, frame, span, i)[0]).collect()
}

fn assert_within_one_code(core: &CoreSpec, frame: &Frame) {
    for (i, (code, exact)) in codes(core, frame).into_iter().zip(method(core, frame)).enumerate() {
        assert!(
            (f64::from(code) - exact.round()).abs() <= 1.0,
            "pixel {i} is {code}, and {exact} in f64"
        );
    }
}
