//! `specula synth`: synthesis and place-and-route, where the programs are installed.
use serde_json::Value;
use specula_fixtures::tools;

use crate::program::Place;

/// A small core on a device for which place-and-route takes seconds.
const SMALL: [&str; 10] = [
    "synth",
    "icosahedron",
    "--size",
    "24x18",
    "--method",
    "gouraud",
    "--target",
    "ice40hx",
    "--seeds",
    "2",
];

#[test]
fn a_small_core_is_placed_and_its_path_is_named() {
    if !["yosys", "nextpnr-ice40"].into_iter().all(tools::is_installed) {
        return;
    }
    let place = Place::new();
    let report = place.succeeds(&[&SMALL[..], &["--json"]].concat());
    let report: Value = serde_json::from_str(&report).expect("it prints JSON");
    assert!(report.get("netlist").is_none(), "{report}");
    let cells = &report["cells"];
    assert!(cells["luts"].as_u64() > Some(100), "{report}");
    assert!(cells["flip_flops"].as_u64() > Some(100), "{report}");
    assert_eq!(cells["blocks"], 0, "the device has none");
    let seeds = report["seeds"].as_array().expect("a list");
    assert_eq!(seeds.len(), 2);
    for placed in seeds {
        let path = &placed["critical_path"];
        let [mhz, ns] = [&placed["reached_mhz"], &path["nanoseconds"]].map(|x| x.as_f64().unwrap());
        // The path has no set-up in it, which is below .2 ns of an iCE40's flip-flop.
        let set_up = 1e3 / mhz - ns;
        assert!((-1e-6..0.2).contains(&set_up), "{mhz} MHz against {ns} ns");
        let steps = path["steps"].as_array().expect("a list");
        let delay = |step: &Value, part: &str| step[part].as_f64().unwrap();
        let sum: f64 = steps.iter().map(|step| delay(step, "logic") + delay(step, "routing")).sum();
        assert!((sum - ns).abs() < 1e-6 * ns);
        assert!(steps.iter().all(|step| step["signal"] != ""), "{path}");
    }
    let slower = seeds.iter().map(|seed| seed["reached_mhz"].as_f64().unwrap());
    assert_eq!(report["median_mhz"].as_f64(), slower.reduce(f64::min));
    let text = place.succeeds(&SMALL);
    assert!(text.contains("Critical path of seed") && text.contains("iCE40HX8K CT256"), "{text}");
}

/// Whether everything is there that simulates a netlist.
fn simulates() -> bool {
    ["yosys", "nextpnr-ice40", "iverilog"].into_iter().all(tools::is_installed)
}

#[test]
fn a_netlist_gives_the_same_pixels_as_the_model() {
    if !simulates() {
        return;
    }
    let place = Place::new();
    let one_seed = [&SMALL[..9], &["1", "--simulate"]].concat();
    let text = place.succeeds(&one_seed);
    let row = text.lines().find(|line| line.starts_with("netlist ")).expect("there is a row");
    assert!(row.contains(" pixels equal, of ") && row.ends_with(" spans of icosahedron"), "{row}");
}

#[test]
fn the_netlist_of_a_core_from_a_file_shades_the_scene_that_is_named() {
    if !simulates() {
        return;
    }
    let place = Place::new();
    place.succeeds(&["generate", "icosahedron", "--method", "gouraud", "-o", "core"]);
    let of_file = ["synth", "--spec", "core", "--target", "ice40hx", "--seeds", "1", "--json"];
    let report = place.succeeds(&[&of_file[..], &["--simulate=icosahedron"]].concat());
    let report: Value = serde_json::from_str(&report).expect("it prints JSON");
    let netlist = &report["netlist"];
    assert_eq!(netlist["scene"], "icosahedron");
    assert!(netlist["pixels"].as_u64() > Some(200), "{netlist}");
    assert!(netlist["spans"].as_u64() > Some(4), "{netlist}");
    assert_eq!((&netlist["differing_pixels"], &netlist["wrong_clocks"]), (&0.into(), &0.into()));
    assert_eq!(netlist["first_difference"], Value::Null);

    let ended = place.specula(&[&of_file[..], &["--simulate"]].concat());
    assert_eq!(ended.status, Some(2));
    assert!(ended.stderr.contains("there is no scene to simulate the core on"), "{ended:?}");
    let ended = place.specula(&[&of_file[..], &["--simulate=teapot"]].concat());
    assert_eq!(ended.status, Some(2));
    assert!(ended.stderr.contains("cannot shade `teapot`"), "{ended:?}");
}
