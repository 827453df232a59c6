//! Lights with a pipeline each, and lights that take turns in one: the same pixels.
use glam::DVec3;
use specula_scene::{DirectionalLight, Frame, load};
use specula_spec::phong::{Highlight, Places};
use specula_spec::{CoreSpec, Increments, LightPipelines, Method, MethodSpec, SceneCore};
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
    let (a, b) = (shaded(frame, each), shaded(frame, &shared));
    assert!(a.1.simulated == b.1.simulated, "{}", each.method().name());
    let lights = each.parameters.lights as u64;
    assert_eq!(b.1.cycles, b.1.pixels * lights + u64::from(b.0.design.depth()));
    assert_eq!(u64::from(b.0.design.latency()), u64::from(b.0.design.depth()) + lights - 1);
    let [each, shared] = [&a.0, &b.0].map(|bench| bench.design.size());
    assert!(shared.multiplier_bits < each.multiplier_bits && shared.multipliers < each.multipliers);
}

#[test]
fn every_methods_lights_can_take_turns() {
    let mut loaded = load("spheres", Some((40, 30))).unwrap();
    let light = |x, y| DirectionalLight {
        direction: DVec3::new(x, y, 1.0).normalize(),
        colour: [0.5, 0.4, 0.3],
    };
    loaded.frame.lights = vec![light(0.5, 0.2), light(-0.7, 0.1), light(0.0, -0.6)];
    for method in Method::ALL {
        let spec = loaded.core_spec(Some(method)).unwrap();
        take_turns(&loaded.frame, &spec.general());
        take_turns(&loaded.frame, &spec);
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
        }
    }
}
