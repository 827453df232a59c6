//! Lights that become weaker with distance, in the core of every method [Hast, Barrera and
//! Bengtsson, §1].
use specula_scene::{LoadedScene, parse};
use specula_spec::{CoreSpec, LightPipelines, Method, SceneCore};
use specula_testbench::{Bench, EngineKind, Outcome};

/// An icosahedron in front of a near eye, with a lamp close to it, a spot that becomes weaker too,
/// and a lamp that does not.
const SCENE: &str = r#"
size = [64, 48]

[camera]
eye = [0.6, 0.9, 3.0]
target = [0, 0, 0]
viewer = "local"

[[light]]
kind = "point"
position = [0.9, 1.1, 1.5]
attenuation = { constant = 0.4, linear = 0.2, quadratic = 0.5 }
colour = 0.9

[[light]]
kind = "spot"
position = [-1.6, 0.4, 1.6]
target = [0, 0, 0]
exponent = 8
attenuation = { quadratic = 0.3 }
colour = [0.3, 0.5, 0.9]

[[light]]
kind = "point"
position = [0.0, -2.0, 2.0]
colour = [0.3, 0.2, 0.1]

[[object]]
primitive = "icosahedron"
"#;

fn scene() -> LoadedScene {
    parse("attenuation.toml", SCENE.to_owned()).unwrap()
}

fn shaded(scene: &LoadedScene, spec: &CoreSpec, engine: EngineKind) -> Outcome {
    let bench = Bench::new(&scene.frame, spec, "core").unwrap();
    let outcome = bench.run(engine, &mut |_, _| ()).unwrap();
    let fault = outcome.fault();
    assert_eq!(fault, None, "{} {engine:?}", spec.method().name());
    outcome
}

#[test]
fn every_method_is_told() {
    let scene = scene();
    for method in Method::ALL {
        let spec = scene.core_spec(Some(method)).unwrap();
        let outcome = shaded(&scene, &spec, EngineKind::Fast);
        let mut shared = spec.general();
        shared.parameters.light_pipelines = LightPipelines::Shared;
        let in_turns = shaded(&scene, &shared, EngineKind::Fast);
        assert!(outcome.simulated == in_turns.simulated, "{}", method.name());
        println!(
            "{} {} {:?} {:?} {:?} bound {}",
            method.name(),
            outcome.pixels,
            outcome.comparison.mismatches,
            outcome.comparison.errors.method,
            outcome.comparison.errors.quantisation,
            outcome.bound_lsb
        );
    }
}
