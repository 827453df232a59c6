//! Lights that become weaker with distance, in the core of every method [Hast, Barrera and
//! Bengtsson, §1].
use specula_fixtures::tools;
use specula_scene::{LoadedScene, parse};
use specula_spec::{CoreSpec, LightPipelines, Method, SceneCore};
use specula_testbench::{Bench, EngineKind, Outcome};

/// An icosahedron before a near eye, with a lamp close to it and a spot that become weaker, and a
/// lamp that does not.
const SCENE: &str = r#"
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

/// The scene at a size in pixels.
fn scene([width, height]: [u32; 2]) -> LoadedScene {
    parse("lamp.toml", format!("size = [{width}, {height}]\n{SCENE}")).unwrap()
}

fn shaded(scene: &LoadedScene, spec: &CoreSpec, engine: EngineKind) -> Outcome {
    let bench = Bench::new(&scene.frame, spec, "core").unwrap();
    let outcome = bench.run(engine, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.fault(), None, "{} {engine:?}", spec.method().name());
    outcome
}

/// Cores for the scene and for any, with a pipeline for each light or one for all, give the model's
/// pixels within their bounds; only `gouraud` does without inputs for it.
#[test]
fn every_method_knows_what_distance_leaves() {
    let scene = scene([64, 48]);
    for method in Method::ALL {
        let spec = scene.core_spec(Some(method)).unwrap();
        let outcome = shaded(&scene, &spec, EngineKind::Fast);
        let mut shared = spec.general();
        shared.parameters.light_pipelines = LightPipelines::Shared;
        let in_turns = shaded(&scene, &shared, EngineKind::Fast);
        assert!(outcome.simulated == in_turns.simulated, "{}", method.name());
        let has_inputs = shared.inputs().iter().any(|port| port.name.contains("attenuation"));
        assert_eq!(has_inputs, method != Method::Gouraud);
        let [of_method, quantisation] =
            [outcome.comparison.errors.method, outcome.comparison.errors.quantisation]
                .map(|figures| figures.max_lsb);
        let bound = outcome.bound_lsb;
        println!("{}: {of_method:.2} and {quantisation:.2} of {bound:.2} LSB", method.name());
        // With true directions nothing but the quadratic is other than exact shading.
        if method == Method::Phong {
            assert!(of_method > 1.0 && of_method < 3.0, "{of_method}");
        }
    }
}

/// The same pixels in rust-hdl's simulator and in Icarus, for the emitted Verilog.
#[test]
fn engines_give_the_same_pixels() {
    let scene = scene([24, 18]);
    let engines = [EngineKind::RustHdl].into_iter();
    let icarus = tools::is_installed("iverilog").then_some(EngineKind::Icarus);
    let engines: Vec<EngineKind> = engines.chain(icarus).collect();
    for method in Method::ALL {
        let spec = scene.core_spec(Some(method)).unwrap();
        for &engine in &engines {
            shaded(&scene, &spec, engine);
        }
    }
}
