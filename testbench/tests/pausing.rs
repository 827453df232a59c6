//! Spans that pause anywhere: random bubbles before time slots of pixels change no pixel.
use std::ops::Range;

use glam::DVec3;
use specula_datapath::Design;
use specula_datapath::design::{Node, NodeId, Op};
use specula_fixtures::each_method;
use specula_fixtures::frames::{Row, frame_of, material, tilted};
use specula_fixtures::specs::{spec, spec_with};
use specula_scene::Frame;
use specula_sim::{Batch, Columns, Flow};
use specula_spec::{Components, CoreSpec, LightPipelines, Method};
use specula_testbench::trace::Choice;
use specula_testbench::{Bench, EngineKind, Outcome};

const SEEDS: [u64; 3] = [1, 2, 3];

/// Spans of one pixel, of a few and of many, under three lights.
fn picture() -> Frame {
    let lights =
        [DVec3::new(0.36, -0.48, 0.8), DVec3::new(-0.48, 0.6, 0.64), DVec3::new(0.0, -0.6, 0.8)];
    let row = |(number, &length): (usize, &u32)| {
        let from = tilted(25.0 * number as f64 - 60.0);
        let to = (from + DVec3::new(0.7, 0.8 - 0.3 * number as f64, 0.2)).normalize();
        Row { normals: [from, to], length, material: material(0.1, 0.3, 0.3, 8) }
    };
    let rows: Vec<Row> = [3, 1, 40, 1, 2, 17].iter().enumerate().map(row).collect();
    frame_of(&rows, &lights)
}

fn shared(mut spec: CoreSpec) -> CoreSpec {
    spec.parameters.light_pipelines = LightPipelines::Shared;
    spec
}

fn serial(mut spec: CoreSpec) -> CoreSpec {
    spec.parameters.components = Components::Serial;
    spec
}

fn run(bench: &Bench, engine: EngineKind) -> Outcome {
    bench.run(engine, &mut |_, _| ()).unwrap()
}

fn every_pixel_is_the_models(method: Method) {
    let frame = picture();
    let own = spec(&frame, method);
    let specialised = own.specialised(&frame);
    for core in [
        shared(own.clone()),
        shared(specialised.clone()),
        serial(specialised.clone()),
        own,
        specialised,
    ] {
        let mut bench = Bench::new(&frame, &core, "core").unwrap();
        let plain = run(&bench, EngineKind::Fast);
        for seed in SEEDS {
            bench = bench.with_bubbles(seed);
            for engine in [EngineKind::Fast, EngineKind::RustHdl] {
                let outcome = run(&bench, engine);
                let first = (&outcome.comparison.first_mismatch, &outcome.violation);
                assert!(outcome.agrees(), "seed {seed}, {engine:?}: {first:?}\n{core:?}");
                assert!(outcome.simulated == plain.simulated);
                assert_eq!(outcome.facts_seen, plain.facts_seen);
                assert_eq!(outcome.cycles, bench.clocks());
                assert!(outcome.cycles > plain.cycles + outcome.pixels / 2);
            }
        }
    }
}

each_method!(every_pixel_is_the_models);

/// A trace shows in every window what it shows of the whole run.
#[test]
fn windows_show_what_the_whole_run_shows() {
    let frame = picture();
    for core in [shared(spec(&frame, Method::Hybrid)), spec(&frame, Method::Slerp)] {
        let bench = Bench::new(&frame, &core, "core").unwrap().with_bubbles(7);
        let outcome = run(&bench, EngineKind::RustHdl);
        let (all, whole) = trace(&bench, &Choice::All, &outcome);
        for first in (0..all.end).step_by(23) {
            let choice = Choice::Cycles(first..first + 5);
            let (window, shown) = trace(&bench, &choice, &outcome);
            let mut wanted = Columns::new(&whole.nodes);
            wanted.extend(&whole.batch().within(&window));
            assert_eq!((shown.span(), &shown.nodes), (wanted.span(), &wanted.nodes));
            for (number, &node) in shown.nodes.iter().enumerate() {
                let name = bench.design.full_name(node);
                assert_eq!(shown.values[number], wanted.values[number], "{name} over {window:?}");
            }
        }
    }
}

/// Every signal over the clocks of a choice, and those clocks.
fn trace(bench: &Bench, choice: &Choice, outcome: &Outcome) -> (Range<u64>, Columns) {
    let mut shown = Columns::default();
    let mut sink = |batch: &Batch| {
        if shown.nodes.is_empty() {
            shown = Columns::new(batch.nodes());
        }
        shown.extend(batch);
        Flow::Continue
    };
    let window = bench.trace(EngineKind::RustHdl, choice, outcome, &mut sink).unwrap();
    (window.unwrap(), shown)
}

/// The registers that step with a valid pixel, and what each takes over.
fn enabled(design: &Design) -> Vec<(NodeId, NodeId)> {
    let next = |(id, node): (NodeId, &Node)| node.clock_enable(id).map(|(_, next)| (id, next));
    design.iter().filter_map(next).collect()
}

/// A register that steps in every clock, whether a pixel is there or not, is found. (Newton's root in
/// `direct` only comes nearer to its root: what it does at each pixel its unit's test says.)
#[test]
fn a_loop_that_does_not_pause_is_reported() {
    let frame = picture();
    let cores = [
        spec_with(
            &frame,
            Method::Lyon,
            "normals = \"wrapped\"\naxis = \"previous\"\nincrements = \"added\"",
        ),
        spec_with(&frame, Method::Direct, "increments = \"added\""),
        spec(&frame, Method::Hybrid),
        spec(&frame, Method::Slerp),
        shared(spec(&frame, Method::Gouraud)),
    ];
    for core in cores {
        let bench = || Bench::new(&frame, &core, "core").unwrap();
        let registers = enabled(&bench().design);
        assert!(!registers.is_empty());
        for (register, next) in registers {
            let agrees = |mut bench: Bench| {
                bench.design.nodes[register.0 as usize].op = Op::Wrap(next);
                run(&bench, EngineKind::RustHdl).agrees()
            };
            let name = bench().design.full_name(register);
            assert!(agrees(bench()), "{name} is wrong without bubbles");
            let found = SEEDS.iter().any(|&seed| !agrees(bench().with_bubbles(seed)));
            assert!(found, "{name} of {:?} is not found", core.method());
        }
    }
}
