//! The search for a small core near exact shading.
use specula_datapath::resources::Resources;
use specula_datapath::target::Target;
use specula_experiments::auto;
use specula_experiments::cost::{Cost, GENERIC_BLOCK};
use specula_experiments::explore::{Device, Exploration, Explored, Wanted, WantedClock, explore};
use specula_experiments::formats::Products;
use specula_experiments::search::{Measured, narrowest_formats};
use specula_experiments::tradeoff::predicted_mhz;
use specula_scene::load;
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

const METHODS: [Method; 4] = [Method::Lyon, Method::Gouraud, Method::Phong, Method::Direct];

fn explored(scene: &str, most: f64) -> Exploration {
    let frame = load(scene, Some((48, 36))).unwrap().frame;
    explore(&frame, &Wanted { most, methods: &METHODS, device: None, target: None }, &|| ())
        .unwrap()
}

#[test]
fn every_core_of_the_front_is_as_good_as_is_said() {
    let loaded = load("teapot", Some((48, 36))).unwrap();
    let exploration = explored("teapot", 2.0);
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
fn the_core_that_is_chosen_is_near_the_smallest() {
    let loaded = load("icosahedron", Some((48, 36))).unwrap();
    let products = Products::Blocks(GENERIC_BLOCK);
    let choice = auto::choose(&loaded, auto::GOAL, &products).unwrap();
    assert!(choice.keeps_goal, "{}", choice.in_words());
    // Formats of both are as narrow as errors on this picture allow.
    let most = choice.chosen.error;
    let found = narrowest_formats(&choice.spec, &loaded.frame, (Measured::Total, most)).unwrap();
    let spec = found.expect("its own formats keep the error").specialised(&loaded.frame);
    let cells = Cost::of(&specula_hdl::elaborate(&spec, "core").unwrap(), None).cells();
    let wanted = Wanted { most, methods: &Method::ALL, device: None, target: None };
    let exploration = explore(&loaded.frame, &wanted, &|| ()).unwrap();
    let best = &exploration.front[exploration.best.expect("there is one")];
    assert!(cells as f64 <= 1.15 * best.cost.cells() as f64, "{cells} cells, {best:?}");
}

#[test]
fn the_same_search_finds_the_same() {
    assert_eq!(
        format!("{:?}", explored("spheres", 3.0)),
        format!("{:?}", explored("spheres", 3.0))
    );
}

#[test]
fn methods_that_cannot_shade_the_scene_are_named() {
    let mut frame = load("teapot", Some((48, 36))).unwrap().frame;
    // Brighter than the coefficients of any core.
    frame.lights[0].colour = [1e6; 3];
    let wanted = Wanted { most: 3.0, methods: &METHODS, device: None, target: None };
    let exploration = explore(&frame, &wanted, &|| ()).unwrap();
    assert!(exploration.front.is_empty() && exploration.best.is_none());
    assert_eq!(exploration.refused.len(), METHODS.len());
    for (method, reason) in METHODS.into_iter().zip(&exploration.refused) {
        assert!(reason.starts_with(&format!("{}: `coefficient", method.name())), "{reason}");
    }
}

fn on_ecp5_25(mhz: Option<f64>, change: impl FnOnce(&mut Device)) -> Exploration {
    let frame = load("teapot", Some((48, 36))).unwrap().frame;
    let mut device = Device::all().find(|device| device.name == "ecp5-25").unwrap();
    let target = Target::named(&device.target).map(|target| WantedClock { target, mhz });
    change(&mut device);
    let methods = &[Method::Gouraud, Method::Direct];
    explore(&frame, &Wanted { most: 4.0, methods, device: Some(device), target }, &|| ()).unwrap()
}

#[test]
fn the_best_core_fits_the_device_and_has_its_clock() {
    let exploration = on_ecp5_25(Some(150.0), |_| ());
    let best = &exploration.front[exploration.best.expect("there is one")];
    let target = Target::named("ecp5").unwrap();
    let design = specula_hdl::elaborate(&best.spec, "core").unwrap();
    let on_target = best.on_target.expect("it is made for the target");
    assert_eq!(on_target.resources, Resources::of(&design, &target));
    assert!(on_target.resources.blocks > 0 && on_target.resources.blocks <= 28);
    assert_eq!(Some(on_target.predicted_mhz), predicted_mhz(&best.spec, &design));
    assert!(on_target.predicted_mhz >= 150.0);
    for pair in exploration.front.windows(2) {
        assert!(pair[0].effort() < pair[1].effort() && pair[0].error > pair[1].error);
    }
    let small = on_ecp5_25(Some(150.0), |device| device.blocks = on_target.resources.blocks - 1);
    let fits =
        |core: &Explored| core.on_target.unwrap().resources.blocks < on_target.resources.blocks;
    assert!(small.best.is_none_or(|best| fits(&small.front[best])));
    assert_eq!(on_ecp5_25(Some(150.0), |device| device.registers = 10).best, None);
}

#[test]
fn cores_on_a_target_have_their_own_highest_clocks() {
    let exploration = on_ecp5_25(None, |_| ());
    for core in &exploration.front {
        let asked = core.spec.target.as_ref().unwrap().clock_mhz;
        assert_eq!(asked, specula_hdl::highest_clock(&core.spec).unwrap(), "{}", core.core);
        assert!(core.on_target.unwrap().predicted_mhz >= asked, "{}", core.core);
    }
}
