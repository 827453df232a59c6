//! On every built-in scene the measured quantisation error stays within what the core states, and the statement says something.
use specula_scene::load;
use specula_testbench::{Bench, EngineKind};

#[path = "common/served.rs"]
mod served;

#[test]
fn measured_errors_stay_within_the_stated_bound() {
    for scene in specula_scene::builtin_names() {
        let loaded = load(scene, Some((120, 90))).unwrap();
        for method in served::methods(&loaded.frame) {
            let spec = loaded.core_spec(Some(method)).unwrap();
            let bench = Bench::new(&loaded.frame, &spec, scene).unwrap();
            let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
            let (error, bound) = (outcome.comparison.errors.quantisation.max_lsb, bench.design.error_bound());
            println!("{scene} {}: {error} of {bound} LSB", method.name());
            assert!(outcome.agrees());
            assert!(error <= bound, "{scene} {}: off by {error} LSB, bound {bound}", method.name());
            assert!(bound < 255.0, "{scene} {}: a bound of {bound} LSB says nothing", method.name());
        }
    }
}
