//! Directions that leave a core beside its colours.
use crate::program::Place;

const SCENE: &str = "size = [32, 24]\n[core]\nmethod = \"consistent\"\n[core.consistent]\n\
                     directions = \"both\"\n[[object]]\nprimitive = \"icosahedron\"\n";

#[test]
fn a_core_gives_them_and_a_run_compares_them() {
    let place = Place::new();
    place.write("mirror.toml", SCENE);
    for engine in ["fast", "rust-hdl"] {
        place.succeeds(&["run", "mirror.toml", "--engine", engine, "-o", "out"]);
        let report = place.report("out");
        let ports = report["ports"].as_array().unwrap();
        let port = |name: &str| ports.iter().find(|port| port["name"] == name);
        for name in ["reflection_x", "reflection_z", "consistent_normal_y"] {
            let port = port(name).unwrap_or_else(|| panic!("no port {name}"));
            assert_eq!((&port["direction"], &port["unit"]), (&"out".into(), &"1".into()));
        }
        assert_eq!(port("red").unwrap()["unit"], "LSB");
    }
    let verilog = place.succeeds(&["generate", "mirror.toml", "-o", "-"]);
    assert!(verilog.contains("reflection_x") && verilog.contains("consistent_normal_z"));
}

#[test]
fn streams_have_no_place_for_them() {
    let place = Place::new();
    place.write("mirror.toml", SCENE);
    for arguments in [
        &["generate", "mirror.toml", "--ip", "-o", "ip"][..],
        &["run", "mirror.toml", "--top", "axis"][..],
    ] {
        let ended = place.specula(arguments);
        assert!(ended.stderr.contains("have no place for the directions"), "{}", ended.stderr);
        assert!(ended.stderr.contains("leave out `directions`"), "{}", ended.stderr);
        assert!(!place.path("ip").exists() && !place.path("out").exists());
    }
}
