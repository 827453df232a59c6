//! The model of the stream top beside the Verilog, clock by clock.
use std::fs;

use specula_fixtures::{each_method, tools};
use specula_flow::stream::{BlockSimulator, StreamRecord, StreamRun, Vectors};
use specula_spec::Method;

use crate::block::{Block, core, frames, shapes, with_core};

/// A second top of the simulation, which tells the clocks in which a time slot goes into the core.
const ENTRIES: &str = "\
module entries;
  always @(posedge shader_tb.aclk)
    if (shader_tb.aresetn && shader_tb.dut.axis.enter) $display(\"enters %0d\", shader_tb.clocks);
endmodule
";

/// Each time slot goes in, and each pixel is taken, in the clock in which the model has it: two frames
/// one after the other and one of a core of its own, streams of every shape, with pauses and without.
fn clocks_are_those_of_the_model(method: Method) {
    if !tools::is_installed("iverilog") {
        return;
    }
    let frames = frames(21);
    for (number, shape) in shapes().into_iter().enumerate() {
        let general = core(method, &frames, number % 2 == 1);
        let own = general.specialised(&frames[0]);
        for (spec, frames) in [(&general, &frames[..]), (&own, &frames[..1])] {
            let block = Block::new(spec, frames, shape);
            for seed in [0, 1 + number as u32, 0x8000_0000 + number as u32] {
                let (run, record, packets) = with_core(spec, frames, shape, |core, vectors| {
                    let run = StreamRun::new(core, vectors, seed).expect("it comes to an end");
                    let spans = || vectors.iter().flat_map(|frame| &frame.spans);
                    let codes: Vec<[u8; 3]> =
                        spans().flat_map(|span| span.codes.iter().copied()).collect();
                    let packets: Vec<Vec<i64>> = spans().map(|span| span.inputs.clone()).collect();
                    (run.clone(), run.record(core, &codes), packets)
                });
                let (entries, found) = simulated(&block, seed);
                assert_eq!(run.entries, entries, "{shape:?} {seed}");
                assert!(record == found, "{shape:?} {seed}");
                let inputs: Vec<Vec<i64>> =
                    run.packets.into_iter().map(|packet| packet.inputs).collect();
                assert_eq!(inputs, packets, "{shape:?} {seed}");
            }
        }
    }
}

each_method!(clocks_are_those_of_the_model);

/// The clocks of time slots and the pixels that Icarus shows.
fn simulated(block: &Block, seed: u32) -> (Vec<u64>, StreamRecord) {
    fs::write(block.path("entries.v"), ENTRIES).expect("it can be written");
    let sources = ["_tb", "", "_axis", "_regs", "_ip"].map(|part| format!("shader{part}.v"));
    let mut words = vec!["-g2001", "-s", "shader_tb", "-s", "entries", "-o", "m.vvp", "entries.v"];
    words.extend(sources.iter().map(String::as_str));
    let (built, said) = block.run("iverilog", &words);
    assert!(built, "{said}");
    let (_, said) = block.run("vvp", &["-n", "m.vvp", &format!("+seed={seed}"), "+record=sent"]);
    assert!(said.contains("PASS"), "{said}");
    let clock = |line: &str| line.strip_prefix("enters ")?.parse().ok();
    let text = fs::read_to_string(block.path("sent")).expect("it is written");
    (said.lines().filter_map(clock).collect(), StreamRecord::read(&text).expect("lines are right"))
}

/// Simulators run a block's bench and tell what comes out, and what is wrong.
#[test]
fn simulators_record_what_comes_out() {
    if !["iverilog", "verilator"].into_iter().all(tools::is_installed) {
        return;
    }
    let frames = frames(22);
    let spec = core(Method::Gouraud, &frames, false);
    let shape = shapes()[0];
    let block = Block::new(&spec, &frames, shape);
    let expected = with_core(&spec, &frames, shape, |core, vectors| {
        Vectors::new(core, vectors).marked_pixels()
    });
    let [icarus, verilator] = [BlockSimulator::Icarus, BlockSimulator::Verilator]
        .map(|simulator| simulator.run("shader", &block.files(), 5).expect("it runs"));
    assert_eq!((icarus.failure, verilator.failure), (None, None));
    assert!(icarus.record == verilator.record);
    assert_eq!(icarus.record.difference(&expected), None);
    block.spoil_pixel(9);
    let spoilt = BlockSimulator::Icarus.run("shader", &block.files(), 5).expect("it runs");
    let failure = spoilt.failure.expect("the bench complains");
    assert!(failure.starts_with("FAIL: pixel 9 is "), "{failure}");
    assert_eq!(spoilt.record.pixels[..9], verilator.record.pixels[..9]);
}

#[test]
fn what_is_lost_doubled_or_wrong_is_found() {
    let text = "7 1\n8 2\n10 3\n";
    let record = StreamRecord::read(text).expect("it is a record");
    assert_eq!(record.difference(&[1, 2, 3]), None);
    for (expected, said) in [
        (&[1, 2][..], "pixel 2 is sent in cycle 10, and is one too many"),
        (&[1, 2, 3, 4], "pixel 3 is never sent"),
        (
            &[1, 5, 3],
            "pixel 1 of the stream is 2 in cycle 8, not 5 (tuser, tlast, row, column, b, g, r)",
        ),
    ] {
        assert_eq!(record.difference(expected).expect("it differs").in_words(), said);
    }
    for text in ["7", "7 x\n", "x 1\n", "7 1 1\n"] {
        assert_eq!(StreamRecord::read(text), None, "{text}");
    }
}
