//! Cores within an error that is asked for.
use specula_experiments::search::{self, Measured};
use specula_fixtures::each_method;
use specula_scene::load;
use specula_spec::{CoreSpec, Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

fn multiplier_bits(spec: &CoreSpec) -> u64 {
    specula_hdl::elaborate(spec, "core").unwrap().size().multiplier_bits
}

fn simulated_pictures_stay_within_an_lsb_of_their_method(method: Method) {
    for scene in specula_fixtures::still_scenes() {
        let loaded = load(scene, Some((48, 36))).unwrap();
        let start = loaded.core_spec(Some(method)).unwrap();
        let general =
            search::narrowest_formats(&start, &loaded.frame, (Measured::Quantisation, 1.0))
                .unwrap()
                .unwrap();
        let spec = general.specialised(&loaded.frame);
        let bench = Bench::new(&loaded.frame, &spec, scene).unwrap();
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
        let error = outcome.comparison.errors.quantisation.max_lsb;
        assert!(outcome.agrees() && error <= 1.0, "{scene} {}: {error}", method.name());
        assert!(
            multiplier_bits(&general) <= multiplier_bits(&start.general()),
            "{scene} {}",
            method.name()
        );
    }
}

each_method!(simulated_pictures_stay_within_an_lsb_of_their_method);

#[test]
fn a_total_error_is_kept_too() {
    let loaded = load("teapot", Some((48, 36))).unwrap();
    let start = loaded.core_spec(Some(Method::Phong)).unwrap();
    let goal = (Measured::Total, 1.5);
    let general = search::narrowest_formats(&start, &loaded.frame, goal).unwrap().unwrap();
    let bench = Bench::new(&loaded.frame, &general, "teapot").unwrap();
    let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
    let error = outcome.comparison.errors.total.max_lsb;
    assert!(outcome.agrees() && error <= 1.5, "{error}");
    assert!(multiplier_bits(&general) < multiplier_bits(&start.general()));
}

#[test]
fn a_method_that_is_further_off_says_how_far() {
    let loaded = load("teapot", Some((48, 36))).unwrap();
    let start = loaded.core_spec(Some(Method::Gouraud)).unwrap();
    let goal = (Measured::Total, 1.0);
    let refusal = search::narrowest_formats(&start, &loaded.frame, goal).unwrap().unwrap_err();
    let bench = Bench::new(&loaded.frame, &start, "teapot").unwrap();
    let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
    assert_eq!(refusal.own, Some(outcome.comparison.errors.method.max_lsb), "{refusal}");
    assert_eq!(refusal.own, Some(search::error_of_method(&start, &loaded.frame)));
}

#[test]
fn what_cannot_be_had_is_refused() {
    let loaded = load("icosahedron", Some((48, 36))).unwrap();
    let start = loaded.core_spec(None).unwrap();
    let refusal = search::narrowest_formats(&start, &loaded.frame, (Measured::Quantisation, 0.01))
        .unwrap()
        .unwrap_err();
    assert!(refusal.best > 0.01 && refusal.best < 1.0, "{refusal}");
}
