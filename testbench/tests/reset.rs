//! A reset in the midst of pixels: what leaves behind it is what a run without one gives, whatever was
//! in the registers and whatever the pins were.
use glam::DVec3;
use specula_datapath::verilog::{self, Header};
use specula_fixtures::each_method;
use specula_fixtures::frames::{Row, frame_of, material, tilted};
use specula_fixtures::specs::spec;
use specula_fixtures::tools;
use specula_scene::Frame;
use specula_sim::Icarus;
use specula_spec::{LightPipelines, Method};
use specula_testbench::{Bench, EngineKind, Outcome};

/// Spans of one pixel one behind the other, of a few pixels and of many.
fn picture() -> Frame {
    let lights = [DVec3::new(0.36, -0.48, 0.8), DVec3::new(-0.48, 0.6, 0.64)];
    let row = |(number, &length): (usize, &u32)| {
        let from = tilted(20.0 * number as f64 - 50.0);
        let to = (from + DVec3::new(0.6, 0.7 - 0.3 * number as f64, 0.3)).normalize();
        Row { normals: [from, to], length, material: material(0.1, 0.4, 0.4, 8) }
    };
    let rows: Vec<Row> = [1, 1, 1, 30, 2, 1].iter().enumerate().map(row).collect();
    frame_of(&rows, &lights)
}

fn run(bench: &Bench, icarus: Icarus, interrupted: u64) -> Outcome {
    let mut icarus = icarus.behind_an_interruption(interrupted);
    bench.run_ports(&mut icarus, &mut |_, _| ()).unwrap()
}

fn a_reset_ends_what_was_under_way(method: Method) {
    if !tools::is_installed("iverilog") {
        return;
    }
    let frame = picture();
    let own = spec(&frame, method).specialised(&frame);
    let mut shared = own.clone();
    shared.parameters.light_pipelines = LightPipelines::Shared;
    for core in [own, shared] {
        for seed in [None, Some(3)] {
            let bench = Bench::new(&frame, &core, "core").unwrap();
            let bench = match seed {
                None => bench,
                Some(seed) => bench.with_bubbles(seed),
            };
            let plain = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
            let latency = u64::from(bench.design.latency());
            // In the first spans; with the pipeline full; when the last pixels are on their way.
            for interrupted in [2, latency / 2 + 1, latency + 20] {
                let outcome = run(&bench, Icarus::new(&bench.design).unwrap(), interrupted);
                let first = (&outcome.comparison.first_mismatch, &outcome.wrong_clocks.first());
                assert!(outcome.agrees(), "behind {interrupted} clocks: {first:?}\n{core:?}");
                assert!(outcome.simulated == plain.simulated && outcome.cycles == plain.cycles);
            }
        }
    }
}

each_method!(a_reset_ends_what_was_under_way);

/// Each bit that the reset clears has to be: where one is not, a pixel that was under way leaves.
#[test]
fn a_bit_that_is_not_reset_is_found() {
    if !tools::is_installed("iverilog") {
        return;
    }
    let frame = picture();
    let core = spec(&frame, Method::Gouraud).specialised(&frame);
    let bench = Bench::new(&frame, &core, "core").unwrap();
    let text = verilog::print(&bench.design.to_block(), &Header::default());
    let bits = bench.design.latency();
    let cleared = format!("valid_line <= {bits}'d0;");
    assert!(text.contains(&cleared), "{text}");
    for bit in 0..bits {
        let kept = format!("valid_line <= valid_line & ({bits}'d1 << {bit});");
        let icarus = Icarus::of_netlist(&bench.design, &text.replace(&cleared, &kept)).unwrap();
        let outcome = run(&bench, icarus, u64::from(bits) + 5);
        assert!(!outcome.agrees(), "bit {bit} of {bits}");
    }
}
