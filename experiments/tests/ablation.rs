//! What cores for one scene save, need by need.
use specula_experiments::{Baseline, Saving, Savings, ablation};
use specula_scene::{LoadedScene, Needs, load};
use specula_spec::{Method, SceneCore};

fn of(scene: &LoadedScene, method: Method) -> Savings {
    let spec = scene.core_spec(Some(method)).unwrap();
    ablation(scene, &spec, None).unwrap()
}

fn scene(name: &str) -> LoadedScene {
    load(name, Some((64, 48))).unwrap()
}

fn line<'a>(savings: &'a Savings, need: &str) -> Option<&'a Saving> {
    savings.needs.iter().find(|saving| saving.need == need)
}

#[test]
fn flat_triangles_need_no_normalisation_by_the_method_that_can_do_without() {
    let mut flat = scene("icosahedron");
    let smooth = of(&flat, Method::Lyon);
    for triangle in &mut flat.frame.triangles {
        triangle.normals = [triangle.facet.normal; 3];
    }
    let flat_of = |method| of(&flat, method);
    let saves = line(&flat_of(Method::Lyon), "flat normals").unwrap().saves;
    assert!(saves.multipliers >= 3 && saves.latency > 0, "{saves:?}");
    assert_eq!(line(&smooth, "flat normals"), None);
    assert_eq!(line(&flat_of(Method::Hybrid), "flat normals"), None);
}

#[test]
fn exponents_that_are_powers_of_two_are_squared() {
    let mut teapot = scene("teapot");
    let need = "exponents are powers of two";
    for method in [
        Method::Hybrid,
        Method::Duff,
        Method::Reflection,
        Method::Consistent,
        Method::Slerp,
        Method::Direct,
    ] {
        let saves = line(&of(&teapot, method), need).unwrap().saves;
        assert!(saves.adder_bits > 0 && saves.register_bits > 0, "{method:?} {saves:?}");
    }
    // Those take any exponent as they are.
    assert_eq!(line(&of(&teapot, Method::Lyon), need), None);
    assert_eq!(line(&of(&teapot, Method::Phong), need), None);
    teapot.frame.materials.iter_mut().for_each(|material| material.shininess = 33);
    assert_eq!(line(&of(&teapot, Method::Hybrid), need), None);
}

#[test]
fn directions_that_are_constant_are_not_worked_out_at_every_pixel() {
    let spheres = of(&scene("spheres"), Method::Phong);
    for need in ["lights at infinity", "eye at infinity"] {
        assert!(line(&spheres, need).unwrap().saves.multipliers >= 6, "{need}: {spheres:?}");
    }
    // It has an eye and two lights at places, and one light at infinity.
    let lamps = of(&scene("lamps"), Method::Phong);
    assert_eq!(line(&lamps, "eye at infinity"), None);
    assert!(line(&lamps, "lights at infinity").unwrap().left_out.contains(" 1 "), "{lamps:?}");
    assert!(
        line(&lamps, "distance to places").is_some()
            && line(&spheres, "distance to places").is_none()
    );
    // Ways to places would be followed.
    let hybrid = of(&scene("spheres"), Method::Hybrid);
    assert!(line(&hybrid, "lights at infinity").unwrap().saves.multipliers >= 6, "{hybrid:?}");
    // There the host works them out for each vertex, and what is constant is a constant.
    assert_eq!(line(&of(&scene("spheres"), Method::Gouraud), "lights at infinity"), None);
}

#[test]
fn angles_and_exponents_decide_formats() {
    let spheres = of(&scene("spheres"), Method::Phong);
    for need in ["angle between the normals of a span", "largest exponent"] {
        let line = line(&spheres, need).unwrap();
        assert!(
            line.saves.multiplier_bits > 0 && line.left_out.contains("narrower formats"),
            "{line:?}"
        );
    }
    let torus = of(&scene("torus"), Method::Consistent);
    assert!(line(&torus, "angle between normals and faces").unwrap().saves.register_bits > 0);
    // Up to 30 degrees `lyon` does without Newton's step.
    let narrow = of(&scene("torus"), Method::Lyon);
    assert!(
        line(&narrow, "angle between the normals of a span")
            .unwrap()
            .left_out
            .contains("Newton steps: 0, not 1")
    );
    // Spans of this one are wider, and formats the finest anyway.
    assert_eq!(
        line(&of(&scene("icosahedron"), Method::Lyon), "angle between the normals of a span"),
        None
    );
}

#[test]
fn all_together_contains_every_need() {
    for (name, method) in
        [("teapot", Method::Lyon), ("spheres", Method::Phong), ("torus", Method::Reflection)]
    {
        let savings = of(&scene(name), method);
        let [nothing, _] = &savings.together[..] else { panic!("{savings:?}") };
        assert_eq!((nothing.baseline, nothing.known.len()), (Baseline::Nothing, 0), "{name}");
        for saving in &savings.needs {
            let (one, all) = (saving.saves, nothing.saves);
            assert!(
                one.multiplier_bits <= all.multiplier_bits
                    && one.register_bits <= all.register_bits,
                "{name}: {saving:?}"
            );
        }
    }
}

/// The general cores say what they are built for: anything, or what a renderer asks for. That saves
/// less, and still something.
#[test]
fn general_cores_are_named() {
    for (name, method, lights) in
        [("teapot", Method::Lyon, 1), ("spheres", Method::Lyon, 2), ("lamps", Method::Phong, 3)]
    {
        let scene = scene(name);
        let savings = of(&scene, method);
        let [nothing, renderer] = &savings.together[..] else { panic!("{savings:?}") };
        assert_eq!((nothing.longest_span, nothing.largest_shininess), (8192, 8191), "{name}");
        assert!(
            nothing.built_for.contains("spans of 8192 pixels, n up to 8191"),
            "{}",
            nothing.built_for
        );
        assert_eq!(
            (renderer.baseline, renderer.lights, renderer.longest_span),
            (Baseline::Renderer, lights, 64),
            "{name}"
        );
        let n = Needs::of(&scene.frame).largest_shininess.max(128);
        assert_eq!(renderer.largest_shininess, n, "{name}");
        assert!(
            renderer.built_for.contains(&format!("spans of 64 pixels, n up to {n}")),
            "{}",
            renderer.built_for
        );
        let (all, usual) = (nothing.saves, renderer.saves);
        assert!(
            usual.register_bits < all.register_bits && usual.register_bits > 0,
            "{name}: {usual:?} and {all:?}"
        );
        assert!(
            usual.multiplier_bits < all.multiplier_bits && usual.multiplier_bits > 0,
            "{name}: {usual:?} and {all:?}"
        );
    }
}

/// A core whose formats were narrowed keeps them, and so do the cores that it is compared with.
#[test]
fn narrowed_formats_are_no_need() {
    let torus = scene("torus");
    let spec = torus.core_spec(Some(Method::Hybrid)).unwrap();
    let points = spec.narrowing_points();
    let shape = points.iter().find(|point| point.name == "base").unwrap().format;
    let narrow = specula_spec::Format { fraction_bits: shape.fraction_bits - 3, ..shape };
    let narrowed = spec.with_formats(&[("base", narrow)]).unwrap().specialised(&torus.frame);
    let of = |spec| ablation(&torus, spec, None).unwrap();
    let needs =
        |savings: &Savings| savings.needs.iter().map(|saving| saving.need).collect::<Vec<_>>();
    let (wide, narrow) = (of(&spec), of(&narrowed));
    assert_eq!(needs(&wide), needs(&narrow));
    let bits = |savings: &Savings| line(savings, "longest span").unwrap().saves.adder_bits;
    assert_eq!(bits(&wide), bits(&narrow));
}
