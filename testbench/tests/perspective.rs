//! Cores before a perspective camera: the host makes their packets of other weights, and they are the
//! same.
use specula_fixtures::each_method;
use specula_scene::parse;
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind};

const MESHES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../fixtures/meshes");

/// A house on hills that reach behind the eye.
fn scene(interpolation: &str, viewer: &str) -> String {
    format!(
        "size = [64, 48]\n[camera]\nkind = \"perspective\"\neye = [1, 5, 2]\ntarget = [-6, 1, -20]\nfield_of_view = 50\n\
         interpolation = {interpolation:?}\nviewer = {viewer:?}\n[[light]]\ndirection = [1, 2, 1]\n[[light]]\nkind = \"point\"\nposition = [-3, 9, -9]\n\
         [[object]]\nmesh = '{MESHES}/hills.obj'\n[[object]]\nmesh = '{MESHES}/building.obj'\ntranslate = [-6, 2.5, -18]\nscale = 0.7\n"
    )
}

fn every_pixel_in_perspective_agrees(method: Method) {
    for (interpolation, viewer) in [("screen", "infinite"), ("perspective", "local")] {
        let loaded = parse("house.toml", scene(interpolation, viewer)).unwrap();
        assert!(loaded.frame.interpolation().is_some());
        let spec = loaded.core_spec(Some(method)).unwrap();
        let bench = Bench::new(&loaded.frame, &spec, "house").unwrap();
        let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
        assert_eq!(outcome.fault(), None, "{} {interpolation} {viewer}", method.name());
    }
}

each_method!(every_pixel_in_perspective_agrees);
