//! The search for a small core near exact shading.
use specula_experiments::explore::{Device, Exploration, Explored, Wanted, explore};
use specula_scene::load;
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

const METHODS: [Method; 4] = [Method::Lyon, Method::Gouraud, Method::Phong, Method::Direct];

fn explored(scene: &str, most: f64, device: Option<Device>) -> Exploration {
    let frame = load(scene, Some((48, 36))).unwrap().frame;
    explore(&frame, &Wanted { most, methods: &METHODS, device }, &|| ()).unwrap()
}

#[test]
fn every_core_of_the_front_is_as_good_as_is_said() {
    let loaded = load("teapot", Some((48, 36))).unwrap();
    let exploration = explored("teapot", 2.0, None);
    assert!(exploration.tried > 50 && exploration.refused.is_empty());
    let best = &exploration.front[exploration.best.expect("phong comes within 2 LSB")];
    assert!(best.error <= 2.0);
    let general = load("teapot", Some((48, 36))).unwrap().core_spec(Some(Method::Phong)).unwrap();
    let size = |spec| specula_hdl::elaborate(spec, "core").unwrap().size().multiplier_bits;
    assert!(size(&best.spec) < size(&general), "{best:?}");
    for (core, next) in
        exploration.front.iter().zip(exploration.front[1..].iter().map(Some).chain([None]))
    {
        let bench = Bench::new(&loaded.frame, &core.spec, "teapot").unwrap();
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
        assert_eq!(outcome.fault(), None);
        assert_eq!(outcome.comparison.errors.total.max_lsb, core.error, "{}", core.core);
        let quantisation = outcome.comparison.errors.quantisation.max_lsb;
        assert_eq!((core.quantisation, core.bound), (Some(quantisation), Some(outcome.bound_lsb)));
        assert_eq!(core.beyond_bound(), None);
        let broken = Explored { bound: Some(0.25), ..core.clone() };
        assert_eq!(broken.beyond_bound(), Some([quantisation, 0.25]));
        assert!(next.is_none_or(|next| next.cost.cells() > core.cost.cells() && next.error < core.error));
    }
}

#[test]
fn the_same_search_finds_the_same() {
    assert_eq!(
        format!("{:?}", explored("spheres", 3.0, None)),
        format!("{:?}", explored("spheres", 3.0, None))
    );
}

#[test]
fn methods_that_cannot_shade_the_scene_are_named() {
    let mut frame = load("teapot", Some((48, 36))).unwrap().frame;
    // Brighter than the coefficients of any core.
    frame.lights[0].colour = [1e6; 3];
    let exploration =
        explore(&frame, &Wanted { most: 3.0, methods: &METHODS, device: None }, &|| ()).unwrap();
    assert!(exploration.front.is_empty() && exploration.best.is_none());
    assert_eq!(exploration.refused.len(), METHODS.len());
    for (method, reason) in METHODS.into_iter().zip(&exploration.refused) {
        assert!(reason.starts_with(&format!("{}: `coefficient", method.name())), "{reason}");
    }
}

#[test]
fn the_best_core_fits_the_device() {
    let device = Device::all().find(|device| device.name == "ecp5-25").unwrap();
    let exploration = explored("teapot", 4.0, Some(device.clone()));
    let best = &exploration.front[exploration.best.expect("there is one")];
    assert!(
        best.cost.fits(&device) && best.cost.blocks.is_some_and(|blocks| blocks > 0),
        "{best:?}"
    );
    let none = explored("teapot", 4.0, Some(Device { blocks: 0, registers: 10, ..device }));
    assert_eq!(none.best, None);
}
