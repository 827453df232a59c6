//! What is said of a design that is not made is what is said of the one that is.
use specula_datapath::builder::Builder;
use specula_datapath::pass;
use specula_fixtures::{Draw, any_spec, each_method};
use specula_scene::{Needs, load};
use specula_spec::{CoreSpec, Method, SceneCore};

fn assert_same_extent(spec: &CoreSpec) {
    let graph = specula_hdl::cores::graph(spec, |formula| Builder::new("core", formula)).unwrap();
    let design = specula_hdl::elaborate(spec, "core").unwrap();
    assert_eq!(pass::extent(&graph), Ok(design.extent()), "{spec:?}");
}

fn extents_are_those_of_designs(method: Method) {
    for name in ["teapot", "lamps"] {
        let scene = load(name, Some((48, 36))).unwrap();
        let special = scene.core_spec(Some(method)).unwrap();
        assert_same_extent(&special);
        assert_same_extent(&special.general());
        let needs = Needs::of(&scene.frame);
        let mut draw = Draw::new(14);
        for _ in 0..20 {
            assert_same_extent(&any_spec(&needs, method, |low, high| {
                draw.between_or_end(low, high)
            }));
        }
    }
}

each_method!(extents_are_those_of_designs);
