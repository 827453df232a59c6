//! Built-in scenes, small, through the whole path.
#[macro_use]
#[path = "../../scene/tests/common/each_method.rs"]
mod each_method;

use specula_scene::load;
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

fn every_pixel_of_every_built_in_scene_agrees(method: Method) {
    for scene in specula_scene::builtin_names() {
        let loaded = load(scene, Some((160, 120))).unwrap();
        let spec = loaded.core_spec(Some(method)).unwrap();
        let bench = Bench::new(&loaded.frame, &spec, scene).unwrap();
        let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
        let c = &outcome.comparison;
        println!(
            "{scene} {}: {} pixels, {} s, {:?} bound {} max code {} {:?} {:?}",
            method.name(),
            outcome.pixels,
            outcome.simulation_seconds,
            c.errors,
            bench.design.error_bound(),
            c.largest_code_difference,
            outcome.violation,
            c.first_mismatch
        );
        println!("{spec:?}");
        assert!(outcome.agrees());
    }
}

each_method!(every_pixel_of_every_built_in_scene_agrees);
