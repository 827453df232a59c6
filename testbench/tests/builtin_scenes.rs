//! Built-in scenes, small, through the whole path.
use specula_fixtures::each_method;
use specula_scene::load;
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

fn every_pixel_of_every_built_in_scene_agrees(method: Method) {
    for scene in specula_fixtures::still_scenes() {
        let loaded = load(scene, Some((160, 120))).unwrap();
        let spec = loaded.core_spec(Some(method)).unwrap();
        let bench = Bench::new(&loaded.frame, &spec, scene).unwrap();
        let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
        assert_eq!(outcome.fault(), None, "{scene} {}: {spec:?}", method.name());
    }
}

each_method!(every_pixel_of_every_built_in_scene_agrees);
