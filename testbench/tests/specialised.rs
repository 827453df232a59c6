//! A core for one scene gives the codes of the general core, and is never larger.
use specula_datapath::Design;
use specula_fixtures::each_method;
use specula_scene::load;
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind, Image};

/// What a core gives, with a right answer to every question a bench asks.
fn shaded(bench: &Bench) -> Image {
    let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.fault(), None);
    outcome.simulated
}

/// Multipliers by bits, adders by bits, registers.
fn sizes(design: &Design) -> [u64; 3] {
    let size = design.size();
    [size.multiplier_bits, size.adder_bits, size.register_bits]
}

fn every_pixel_is_that_of_the_general_core(method: Method) {
    for scene in specula_fixtures::still_scenes() {
        let loaded = load(scene, Some((96, 72))).unwrap();
        let special = loaded.core_spec(Some(method)).unwrap();
        let general = special.general();
        let [special, general] =
            [&special, &general].map(|spec| Bench::new(&loaded.frame, spec, scene).unwrap());
        assert!(shaded(&special) == shaded(&general), "{scene} {}", method.name());
        let (s, g) = (sizes(&special.design), sizes(&general.design));
        println!(
            "{scene} {}: {s:?} of {g:?}, latency {} of {}",
            method.name(),
            special.design.latency(),
            general.design.latency()
        );
        assert!(s[0] < g[0] && s[2] < g[2], "{scene} {}", method.name());
        assert!(special.design.latency() <= general.design.latency());
    }
}

each_method!(every_pixel_is_that_of_the_general_core);
