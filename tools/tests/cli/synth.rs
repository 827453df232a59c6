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
    let cells = &report["cells"];
    assert!(cells["luts"].as_u64() > Some(100), "{report}");
    assert!(cells["flip_flops"].as_u64() > Some(100), "{report}");
    assert_eq!(cells["blocks"], 0, "the device has none");
    let seeds = report["seeds"].as_array().expect("a list");
    assert_eq!(seeds.len(), 2);
    for placed in seeds {
        let path = &placed["critical_path"];
        let [mhz, ns] = [&placed["reached_mhz"], &path["nanoseconds"]].map(|x| x.as_f64().unwrap());
        assert!((1e3 / mhz - ns).abs() < 0.02 * ns, "{mhz} MHz against {ns} ns");
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
