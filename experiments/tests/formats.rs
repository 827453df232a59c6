//! Formats by proof.
use specula_experiments::cost::{Cost, GENERIC_BLOCK};
use specula_experiments::formats::{
    DefaultCore, FAITHFUL, MARGIN, NotFaithful, NotProven, Products, Proven, Wanted,
    cheapest_formats, default_core,
};
use specula_fixtures::each_method;
use specula_scene::{Frame, LoadedScene, Needs, load};
use specula_spec::{CoreOptions, CoreSpec, Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

fn scene(name: &str) -> LoadedScene {
    load(name, Some((48, 36))).unwrap()
}

fn found(start: &CoreSpec, frame: &Frame, below: f64) -> Result<Proven, NotProven> {
    cheapest_formats(
        start,
        frame,
        &Wanted { below, products: Products::Blocks(GENERIC_BLOCK), kept: &[] },
    )
    .unwrap()
}

fn fraction_bits(spec: &CoreSpec) -> Vec<u32> {
    spec.narrowing_points().iter().map(|point| point.format.fraction_bits).collect()
}

/// The bound of a core and the cells that it takes.
fn elaborated(spec: &CoreSpec) -> (f64, i64) {
    let design = specula_hdl::elaborate(spec, "core").unwrap();
    // Sizes are far below 2^63.
    (design.error_bound(), Cost::of(&design, Some(GENERIC_BLOCK)).cells() as i64)
}

/// The core with each format narrower by a bit, where that can be described, for the same frame.
fn narrower<'a>(spec: &'a CoreSpec, frame: &'a Frame) -> impl Iterator<Item = CoreSpec> + 'a {
    (0..spec.narrowing_points().len()).filter_map(move |point| {
        let mut bits = fraction_bits(spec);
        bits[point] = bits[point].checked_sub(1)?;
        let general = spec.with_fraction_bits(&bits)?;
        Some(if spec.specialisation.is_general() { general } else { general.specialised(frame) })
    })
}

fn faithful_cores_are_proven_and_could_not_be_narrower(method: Method) {
    for name in ["teapot", "lamps"] {
        let scene = scene(name);
        let start = scene.core_spec(Some(method)).unwrap();
        let core = found(&start, &scene.frame, FAITHFUL).unwrap();
        let (bound, cells) = elaborated(&core.spec);
        assert!((bound, cells) == (core.bound, core.cells) && bound < 1.0, "{bound}");
        assert_eq!(core.spec, core.spec.specialised(&scene.frame), "{name}");
        for narrower in narrower(&core.spec, &scene.frame) {
            let (bound, other) = elaborated(&narrower);
            let bits = fraction_bits(&narrower);
            let met = bound < FAITHFUL - MARGIN;
            assert!(!met || other >= cells, "{name} {bits:?}: {bound}, {other} < {cells}");
        }
        let bench = Bench::new(&scene.frame, &core.spec, name).unwrap();
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
        let error = outcome.comparison.errors.quantisation.max_lsb;
        assert!(outcome.agrees() && error <= bound, "{name}: {error} of {bound}");
    }
}

each_method!(faithful_cores_are_proven_and_could_not_be_narrower);

/// No pixel is shaded: a frame without pixels gives the same formats, in about as many elaborations
/// as a few for each bit of each format.
#[test]
fn general_cores_are_found_without_any_pixel() {
    for method in [Method::Lyon, Method::Hybrid, Method::Slerp] {
        let scene = scene("spheres");
        let start = scene.core_spec(Some(method)).unwrap().general();
        let core = found(&start, &scene.frame, FAITHFUL).unwrap();
        assert!(core.spec.specialisation.is_general() && core.bound < FAITHFUL);
        assert!((20..300).contains(&core.tried), "{}", core.tried);
        let empty = Frame { spans: vec![], ..scene.frame.clone() };
        assert_eq!(found(&start, &empty, FAITHFUL).unwrap().spec, core.spec);
    }
}

#[test]
fn a_closer_goal_is_met_too() {
    let scene = scene("teapot");
    let start = scene.core_spec(Some(Method::Hybrid)).unwrap();
    let costs = [3.0, 1.0, 0.75, 0.6].map(|below| {
        let core = found(&start, &scene.frame, below).unwrap();
        assert!(core.bound < below, "{} of {below}", core.bound);
        core.cells
    });
    assert!(costs.is_sorted(), "{costs:?}");
}

/// The teapot's `lyon` core has operands of 19 to 21 bits by default.
#[test]
fn operands_come_to_fit_the_blocks() {
    let scene = load("teapot", None).unwrap();
    let start = scene.core_spec(Some(Method::Lyon)).unwrap();
    let blocks = |spec: &CoreSpec, block| {
        let design = specula_hdl::elaborate(spec, "core").unwrap();
        Cost::of(&design, Some(block)).blocks.unwrap()
    };
    for (block, least_saving) in [([18, 18], 3), ([25, 18], 1), ([16, 16], 2)] {
        let wanted = Wanted { below: FAITHFUL, products: Products::Blocks(block), kept: &[] };
        let core = cheapest_formats(&start, &scene.frame, &wanted).unwrap().unwrap();
        let products = specula_hdl::elaborate(&core.spec, "core").unwrap().size().multipliers;
        let [before, after] = [&start, &core.spec].map(|spec| blocks(spec, block));
        assert!(after * least_saving <= before, "{block:?}: {before}, {after}");
        if block[1] == 18 {
            assert_eq!(after, products as u64, "every product takes one block");
        }
    }
}

#[test]
fn formats_that_are_kept_stay() {
    let scene = scene("teapot");
    let start = scene.core_spec(Some(Method::Lyon)).unwrap();
    let kept = ["vector".to_owned(), "shape".to_owned()];
    let wanted = Wanted { below: FAITHFUL, products: Products::Blocks(GENERIC_BLOCK), kept: &kept };
    let core = cheapest_formats(&start, &scene.frame, &wanted).unwrap().unwrap();
    let of = |spec: &CoreSpec, name: &str| {
        spec.narrowing_points().into_iter().find(|point| point.name == name).unwrap().format
    };
    for name in &kept {
        assert_eq!(of(&core.spec, name), of(&start, name));
    }
    assert!(core.bound < FAITHFUL && core.spec != start);
}

#[test]
fn what_cannot_be_proven_is_refused_with_what_is_in_the_way() {
    let scene = scene("spheres");
    let start = scene.core_spec(Some(Method::Phong)).unwrap();
    let refusal = found(&start, &scene.frame, 0.6).unwrap_err();
    assert!(refusal.reached > 0.6 && refusal.reached < FAITHFUL, "{refusal}");
    assert!(refusal.obstacle.starts_with("`vector` ("), "{refusal}");
    let refusal = found(&start, &scene.frame, 0.3).unwrap_err();
    assert!(refusal.reached >= 0.5, "{refusal}");
    let start = scene.core_spec(Some(Method::Gouraud)).unwrap();
    let refusal = found(&start, &scene.frame, 0.5).unwrap_err();
    assert!(refusal.obstacle.starts_with("it comes from no format"), "{refusal}");
}

#[test]
fn a_core_that_cannot_be_proven_faithful_has_recommended_formats() {
    let scene = scene("teapot");
    let start = scene.core_spec(Some(Method::Lyon)).unwrap();
    let default = |spec: &CoreSpec, named: &[String]| {
        let products = Products::Blocks(GENERIC_BLOCK);
        default_core(spec.clone(), &scene.frame, named, products).unwrap()
    };
    let coarse = start.with_formats(&[("vector", "S1.7".parse().unwrap())]).unwrap();
    let coarse = coarse.specialised(&scene.frame);
    let core = default(&coarse, &["vector".to_owned()]);
    assert_eq!(core.spec, coarse);
    let NotFaithful { reason, below } = core.not_faithful.unwrap();
    assert_eq!(below, None);
    assert!(reason.reached > FAITHFUL && reason.below == FAITHFUL, "{reason}");
    assert!(reason.obstacle.starts_with("`vector` (") && reason.obstacle.contains("asked for"));
    // The same without a format that is named, and with all of them.
    let core = default(&coarse, &[]);
    assert!(core.not_faithful.is_none() && elaborated(&core.spec).0 < FAITHFUL);
    let all: Vec<String> =
        coarse.narrowing_points().iter().map(|point| point.name.to_owned()).collect();
    let core = default(&coarse, &all);
    assert!(core.not_faithful.is_none() && core.spec == coarse);
}

/// Options of which the recommended formats have a bound many times what is measured
/// (docs/error-bounds.md): a core is faithful by default all the same, so that its bound, below 1 LSB,
/// is less than twice the half LSB that rounding to 8 bits takes.
#[test]
fn options_far_from_their_bounds_in_recommended_formats_are_faithful_by_default() {
    for (method, option) in [
        ("consistent", "diffuse = \"consistent\""),
        ("consistent", "highlight = \"blinn\""),
        ("phong", "highlight = \"blinn\""),
        ("phong", "highlight = \"trowbridge-reitz\""),
        ("phong", "places = \"wrapped\""),
        ("duff", "specular = \"blinn\""),
        ("reflection", "bisector = \"triangle\""),
        ("direct", "root = \"newton\""),
    ] {
        let (core, _) = by_default(method, option);
        assert!(core.not_faithful.is_none(), "{method}, {option}: {:?}", core.not_faithful);
    }
}

/// The two that are not, since fraction bits end: a bound of a few LSB is as near as formats come, so
/// that is what they have by default, and what can be asked for.
#[test]
fn two_options_come_near_to_faithful() {
    for (method, option, near) in [
        ("phong", "highlight = \"torrance-sparrow\"", 2.6),
        ("reflection", "specular = \"blinn\"", 1.4),
    ] {
        let (core, frame) = by_default(method, option);
        let NotFaithful { reason, below } = core.not_faithful.expect("it is not faithful");
        assert!(reason.reached > FAITHFUL && reason.reached < near, "{method}: {reason}");
        let below = below.expect("recommended formats have many times that bound");
        let (bound, _) = elaborated(&core.spec);
        assert!(bound < below && below < 1.2 * near, "{method}: {bound}, {below}");
        let (bound, _) = elaborated(&found(&core.spec, &frame, near).unwrap().spec);
        assert!(bound < near, "{method}: {bound}");
    }
}

/// The core that `lamps` has by default with an option of a method, and the frame.
fn by_default(method: &str, option: &str) -> (DefaultCore, Frame) {
    let LoadedScene { frame, .. } = scene("lamps");
    let options: CoreOptions =
        format!("method = \"{method}\"\n[{method}]\n{option}").parse().unwrap();
    let general = CoreSpec::for_scene(&Needs::of(&frame), Some(&options), None).unwrap();
    let products = Products::Blocks(GENERIC_BLOCK);
    (default_core(general.specialised(&frame), &frame, &[], products).unwrap(), frame)
}
