//! Any spec that `CoreSpec::check` accepts, with any scene: hardware and model agree bit for bit,
//! no stated fact is untrue, and the error of each output stays within its stated bound. A spec may
//! be refused as too wide, and nothing else.
use specula_datapath::Design;
use specula_fixtures::{Draw, drawn, each_method};
use specula_golden::exact::MethodSpan;
use specula_scene::Frame;
use specula_spec::{Components, CoreSpec, LightPipelines, Method};
use specula_testbench::{Bench, BenchError, EngineKind, Image};

/// What takes turns in a core: nothing, lights or components.
const TURNS: [(LightPipelines, Components); 3] = [
    (LightPipelines::Each, Components::Parallel),
    (LightPipelines::Shared, Components::Parallel),
    (LightPipelines::Each, Components::Serial),
];

fn agrees(seed: u64, method: Method) {
    let mut draw = Draw::new(seed);
    let longest = draw.one_of(&[1, 2, 3, 20, 150]);
    let frame = drawn::frame(&mut draw, longest);
    let (light_pipelines, components) = draw.one_of(&TURNS);
    let mut general = drawn::spec(&mut draw, &frame, method);
    general.parameters.light_pipelines = light_pipelines;
    general.parameters.components = components;
    let spec = if draw.one_of(&[true, false]) { general.specialised(&frame) } else { general };
    println!("{spec:?}");
    let bench = match Bench::new(&frame, &spec, "core") {
        Ok(bench) => bench,
        Err(BenchError::TooWide(_)) => return,
        Err(error) => panic!("{error}"),
    };
    let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.fault(), None);
    errors_stay_within_bounds(&bench.design, &spec, &frame, &outcome.simulated);
}

/// Each output against the method in f64, before its rounding to 8 bits.
fn errors_stay_within_bounds(design: &Design, spec: &CoreSpec, frame: &Frame, simulated: &Image) {
    let bounds = &design.output_errors;
    for span in &frame.spans {
        let method = MethodSpan::new(spec, frame, span);
        for pixel in 0..span.length {
            let code = simulated.pixels[(span.y * frame.width + span.x + pixel) as usize];
            let exact = method.pixel(pixel);
            for channel in 0..3 {
                let error = (f64::from(code[channel]) - exact[channel]).abs();
                let place = (span.y, pixel, channel);
                assert!(
                    error <= bounds[channel],
                    "{place:?}: off by {error}, bound {}",
                    bounds[channel]
                );
            }
        }
    }
}

fn hardware_agrees_with_the_model(method: Method) {
    let specs = if matches!(method, Method::Slerp | Method::Direct) { 250 } else { 80 };
    (0..specs).for_each(|seed| agrees(seed, method));
}

each_method!(hardware_agrees_with_the_model);
