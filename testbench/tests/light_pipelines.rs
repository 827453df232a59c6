//! Lights with a pipeline each, and lights or components that take turns in one: the same pixels.
use glam::DVec3;
use specula_datapath::design::Size;
use specula_scene::limits::MOST_LIGHTS;
use specula_scene::{DirectionalLight, Frame, load};
use specula_spec::phong::{Highlight, Places};
use specula_spec::{
    Components, CoreSpec, Increments, LightPipelines, Method, MethodSpec, SceneCore,
};
use specula_testbench::{Bench, EngineKind, Outcome};

fn shaded<'a>(frame: &'a Frame, spec: &'a CoreSpec) -> (Bench<'a>, Outcome) {
    let bench = Bench::new(frame, spec, "core").unwrap();
    let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.fault(), None);
    (bench, outcome)
}

/// Both forms give the same picture; sharing takes a clock for each light, and fewer multipliers.
fn take_turns(frame: &Frame, each: &CoreSpec) {
    let mut shared = each.clone();
    shared.parameters.light_pipelines = LightPipelines::Shared;
    let [each, shared] = same_pixels(frame, [each, &shared]);
    assert!(shared.multiplier_bits < each.multiplier_bits && shared.multipliers < each.multipliers);
}

/// The same of components, each of which takes a clock.
fn components_take_turns(frame: &Frame, parallel: &CoreSpec) {
    let mut serial = parallel.clone();
    serial.parameters.components = Components::Serial;
    let [parallel, serial] = same_pixels(frame, [parallel, &serial]);
    assert!(serial.multipliers <= parallel.multipliers);
}

/// Runs a core and one in which something takes turns, and gives their sizes.
fn same_pixels(frame: &Frame, cores: [&CoreSpec; 2]) -> [Size; 2] {
    let [(own, outcome), (turned, in_turns)] = cores.map(|core| shaded(frame, core));
    assert!(outcome.simulated == in_turns.simulated, "{}", cores[0].method().name());
    let (turns, depth) = (cores[1].parameters.interval(), turned.design.depth());
    assert_eq!(in_turns.cycles, in_turns.pixels * u64::from(turns) + u64::from(depth));
    assert_eq!(turned.design.latency(), depth + turns - 1);
    [own, turned].map(|bench| bench.design.size())
}

#[test]
fn every_methods_lights_and_components_can_take_turns() {
    let mut loaded = load("spheres", Some((40, 30))).unwrap();
    let light = |x, y| DirectionalLight {
        direction: DVec3::new(x, y, 1.0).normalize(),
        colour: [0.5, 0.4, 0.3],
    };
    loaded.frame.lights = vec![light(0.5, 0.2), light(-0.7, 0.1), light(0.0, -0.6)];
    for method in Method::ALL {
        let spec = loaded.core_spec(Some(method)).unwrap();
        for core in [&spec.general(), &spec] {
            take_turns(&loaded.frame, core);
            components_take_turns(&loaded.frame, core);
        }
    }
}

/// As many lights as a scene may have, of all kinds: the pixels of rust-hdl and of the fast engine
/// are those of the model, and within their bounds, whether lights take turns or not.
#[test]
fn eight_lights_are_shaded() {
    let mut loaded = load("lamps", Some((24, 18))).unwrap();
    let others = MOST_LIGHTS - loaded.frame.lights.len() - loaded.frame.local_lights.len();
    let light = |k: usize| DirectionalLight {
        direction: DVec3::new(0.3 * k as f64 - 0.6, 0.2 * k as f64 - 0.5, 1.0).normalize(),
        colour: [0.2, 0.05 * k as f64, 0.1],
    };
    loaded.frame.lights.extend((0..others).map(light));
    for method in [Method::Lyon, Method::Phong, Method::Duff] {
        let mut spec = loaded.core_spec(Some(method)).unwrap();
        assert_eq!(spec.parameters.lights, MOST_LIGHTS);
        for pipelines in [LightPipelines::Each, LightPipelines::Shared] {
            spec.parameters.light_pipelines = pipelines;
            let bench = Bench::new(&loaded.frame, &spec, "core").unwrap();
            let [fast, reference] = [EngineKind::Fast, EngineKind::RustHdl]
                .map(|engine| bench.run(engine, &mut |_, _| ()).unwrap());
            assert_eq!((fast.fault(), reference.fault()), (None, None), "{}", method.name());
            assert!(fast.simulated == reference.simulated, "{}", method.name());
        }
    }
}

/// A distant light, a lamp and a spot seen from an eye nearby: whatever `phong` makes of directions,
/// increments and highlights.
#[test]
fn lights_of_all_kinds_can_take_turns() {
    let loaded = load("lamps", Some((48, 36))).unwrap();
    for (highlight, increments) in [
        (Highlight::Reflection, Increments::Multiplied),
        (Highlight::Blinn, Increments::Added),
        (Highlight::TrowbridgeReitz, Increments::Multiplied),
    ] {
        for places in [Places::Exact, Places::Wrapped] {
            let mut spec = loaded.core_spec(Some(Method::Phong)).unwrap().general();
            if let MethodSpec::Phong(phong) = &mut spec.method {
                (phong.places, phong.highlight) = (places, highlight);
                phong.increments = increments;
            }
            take_turns(&loaded.frame, &spec);
            take_turns(&loaded.frame, &spec.specialised(&loaded.frame));
            components_take_turns(&loaded.frame, &spec);
        }
    }
}
