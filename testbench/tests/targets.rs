//! Cores made for a clock on a target: every pixel is the model's, whatever operators were lowered
//! to and whichever clock they run in.
use glam::DVec3;
use specula_datapath::target::Target;
use specula_fixtures::each_method;
use specula_fixtures::frames::{Row, frame_of, material, tilted};
use specula_fixtures::specs::spec;
use specula_fixtures::tools;
use specula_scene::Frame;
use specula_spec::{Components, CoreSpec, LightPipelines, Method, TargetClock};
use specula_testbench::{Bench, EngineKind};

/// Clocks in MHz: operators in a row, and sums in many pieces.
const CLOCKS: [f64; 2] = [40.0, 260.0];

/// Spans of one pixel, of a few and of many, under two lights.
fn picture() -> Frame {
    let lights = [DVec3::new(0.36, -0.48, 0.8), DVec3::new(-0.48, 0.6, 0.64)];
    let row = |(number, &length): (usize, &u32)| {
        let from = tilted(20.0 * number as f64 - 40.0);
        let to = (from + DVec3::new(0.6, 0.7 - 0.3 * number as f64, 0.3)).normalize();
        Row { normals: [from, to], length, material: material(0.1, 0.4, 0.4, 8) }
    };
    let rows: Vec<Row> = [3, 1, 40, 2].iter().enumerate().map(row).collect();
    frame_of(&rows, &lights)
}

fn made_for(core: &CoreSpec, name: &str, clock_mhz: f64) -> CoreSpec {
    CoreSpec { target: Some(TargetClock { name: name.to_owned(), clock_mhz }), ..core.clone() }
}

fn every_pixel_is_the_models(method: Method) {
    let frame = picture();
    let own = spec(&frame, method);
    let mut shared = own.clone();
    shared.parameters.light_pipelines = LightPipelines::Shared;
    let mut serial = own.clone();
    serial.parameters.components = Components::Serial;
    for core in [own.specialised(&frame), shared.specialised(&frame)] {
        for target in Target::clocked() {
            for clock in CLOCKS {
                agrees(&frame, &made_for(&core, target, clock));
            }
        }
    }
    agrees(&frame, &made_for(&own, "ecp5", 260.0));
    agrees(&frame, &made_for(&serial.specialised(&frame), "ecp5", 260.0));
    agrees(&frame, &made_for(&serial, "ice40up", 40.0));
}

each_method!(every_pixel_is_the_models);

/// The Verilog of each target, by methods that use most of its cells: blocks with registers in them,
/// sums in pieces, memories that delay.
#[test]
fn icarus_agrees_on_every_target() {
    if !tools::is_installed("iverilog") {
        return;
    }
    let frame = picture();
    for (target, method, clock) in [
        ("ecp5", Method::Lyon, 260.0),
        ("ecp5", Method::Direct, 100.0),
        ("xilinx7", Method::Reflection, 100.0),
        ("ice40up", Method::Lyon, 20.0),
        ("ice40hx", Method::Gouraud, 40.0),
    ] {
        let core = made_for(&spec(&frame, method).specialised(&frame), target, clock);
        let bench = Bench::new(&frame, &core, "core").unwrap();
        let outcome = bench.run(EngineKind::Icarus, &mut |_, _| ()).unwrap();
        let first = (&outcome.comparison.first_mismatch, &outcome.violation);
        assert!(outcome.agrees(), "{target}, {}: {first:?}", method.name());
    }
}

fn agrees(frame: &Frame, core: &CoreSpec) {
    let bench = Bench::new(frame, core, "core").unwrap();
    let plain = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
    let first = (&plain.comparison.first_mismatch, &plain.violation);
    assert!(plain.agrees(), "{first:?}\n{core:?}");
    let paused = bench.with_bubbles(7).run(EngineKind::Fast, &mut |_, _| ()).unwrap();
    assert!(paused.agrees() && paused.simulated == plain.simulated, "with bubbles\n{core:?}");
}
