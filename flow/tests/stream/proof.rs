//! The properties of a block, proven for all times; and that each of them is noticed where it fails.
use std::fs;

use specula_fixtures::tools;
use specula_spec::Method;

use crate::block::{Block, core, frames, shapes};

/// The streams and registers of a core whose lights take turns.
#[test]
fn properties_are_proven() {
    if !["yosys", "yosys-abc"].into_iter().all(tools::is_installed) {
        return;
    }
    let frames = frames(12);
    let spec = core(Method::Gouraud, &frames, true);
    let block = Block::new(&spec, &frames, shapes()[3]);
    let (succeeded, said) = block.run("sh", &["prove.sh"]);
    assert!(succeeded && said.ends_with("PASS\n"), "{said}");
    for property in ["order", "last_arrives", "frame_when_empty", "inputs_hold"] {
        assert!(said.contains(&format!("proven: {property}\n")), "{said}");
    }
}

/// A fault: the file, what stands there, what is put in its place, and the property that says so.
type Fault = (&'static str, &'static str, &'static str, &'static str);

const FAULTS: [Fault; 11] = [
    (
        "axis",
        "m_axis_tvalid <= move | (m_axis_tvalid & ~m_axis_tready);",
        "m_axis_tvalid <= move;",
        "pixel_waits",
    ),
    ("axis", "if (freed ^ spend) places", "if (freed) places", "places_are_kept"),
    ("axis", "if (leaves) leaving", "if (leaves & ~read) leaving", "order"),
    ("axis", "if (has_entered) entering", "if (has_entered & ~leaves) entering", "last_arrives"),
    (
        "axis",
        "of_frame, at_last}),\n      .leaves",
        "at_first, at_last}),\n      .leaves",
        "first_arrives",
    ),
    (
        "axis",
        "x, of_frame, at_last}),\n      .leaves",
        "y, of_frame, at_last}),\n      .leaves",
        "column_arrives",
    ),
    ("axis", "at_last <= left ==", "at_last <= left !=", "last_of_span"),
    ("axis", "if (whole & fits) full", "if (whole) full", "packet_is_whole"),
    ("axis", "& ~shading & drained;", "& ~shading;", "frame_when_empty"),
    ("regs", "if (frame) begin", "if (accepted) begin", "inputs_hold"),
    (
        "regs",
        "else s_axi_bvalid <= write | (s_axi_bvalid & ~s_axi_bready);",
        "else s_axi_bvalid <= write;",
        "one_answer",
    ),
];

#[test]
fn faults_are_found_by_their_properties() {
    if !["yosys", "yosys-abc"].into_iter().all(tools::is_installed) {
        return;
    }
    let frames = frames(12);
    let spec = core(Method::Gouraud, &frames, false);
    let block = Block::new(&spec, &frames, shapes()[0]);
    for (file, sound, faulty, property) in FAULTS {
        let path = block.path(&format!("shader_{file}.v"));
        let text = fs::read_to_string(&path).expect("it is there");
        assert_eq!(text.matches(sound).count(), 1, "{sound}");
        fs::write(&path, text.replace(sound, faulty)).expect("it can be written");
        let (succeeded, said) = block.run("sh", &["prove.sh", property]);
        let failed = format!("FAIL: {property} does not hold\n");
        assert!(!succeeded && said.contains(&failed), "{faulty}: {said}");
        fs::write(&path, text).expect("it can be written");
    }
}
