//! The fast engine against rust-hdl, on every signal and clock of both cores.
use specula_datapath::design::NodeId;
use specula_fixtures::each_method;
use specula_scene::load;
use specula_sim::fast::{InstructionSet, Settings};
use specula_sim::{Columns, Engine, Fast, Flow, RustHdl, Stimulus};
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind, FrameSpans};

fn all_columns(engine: &mut dyn Engine, stimulus: &Stimulus, nodes: &[NodeId]) -> Columns {
    let mut all = Columns::new(nodes);
    engine
        .run(stimulus, nodes, &mut |columns| {
            all.extend(columns);
            Flow::Continue
        })
        .unwrap();
    all
}

fn every_signal_agrees_with_rust_hdl_at_every_clock(method: Method) {
    for (scene, size) in [("teapot", (40, 30)), ("torus", (24, 18)), ("icosahedron", (40, 30))] {
        let loaded = load(scene, Some(size)).unwrap();
        let spec = loaded.core_spec(Some(method)).unwrap();
        let bench = Bench::new(&loaded.frame, &spec, scene).unwrap();
        let spans = FrameSpans::new(&loaded.frame, &spec);
        let stimulus = Stimulus::whole(&spans, &bench.design);
        let nodes: Vec<NodeId> = bench.design.variables();
        let expected = all_columns(&mut RustHdl::new(&bench.design).unwrap(), &stimulus, &nodes);
        let baseline = InstructionSet::BASELINE;
        for (batch, instruction_set, threads) in [
            (1, baseline, 1),
            (7, baseline, 3),
            (512, baseline, 1),
            (7, InstructionSet::best(), 1),
            (512, InstructionSet::best(), 2),
        ] {
            let settings = Settings { batch, instruction_set, threads, piece: 50 };
            let mut fast = Fast::with_settings(&bench.design, settings);
            let given = all_columns(&mut fast, &stimulus, &nodes);
            assert_eq!(given.span(), expected.span(), "{scene} {settings:?}");
            for (i, &node) in nodes.iter().enumerate() {
                let differs =
                    (0..expected.clocks()).find(|&c| expected.values[i][c] != given.values[i][c]);
                if let Some(clock) = differs {
                    panic!(
                        "{scene} {} {settings:?}: {} at clock {clock}: {} instead of {} {:?}",
                        method.name(),
                        bench.design.full_name(node),
                        given.values[i][clock],
                        expected.values[i][clock],
                        bench.design.node(node)
                    );
                }
            }
            // Fused, with the outputs alone.
            let outputs = all_columns(&mut fast, &stimulus, &bench.design.outputs);
            for &node in &bench.design.outputs {
                assert_eq!(outputs.of(node), expected.of(node), "{scene} {settings:?}");
            }
        }
    }
}

fn whole_frames_agree(method: Method) {
    for scene in specula_fixtures::still_scenes() {
        let loaded = load(scene, Some((640, 480))).unwrap();
        let spec = loaded.core_spec(Some(method)).unwrap();
        let bench = Bench::new(&loaded.frame, &spec, scene).unwrap();
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
        println!(
            "{scene} {}: {} pixels {} s: {} ns/clock",
            method.name(),
            outcome.pixels,
            outcome.simulation_seconds,
            outcome.simulation_seconds * 1e9 / outcome.cycles as f64
        );
        assert_eq!(outcome.fault(), None);
    }
}

each_method!(every_signal_agrees_with_rust_hdl_at_every_clock);
each_method!(whole_frames_agree);
