//! `specula explore`.
use serde_json::Value;

use crate::program::Place;

const SMALL: [&str; 8] =
    ["explore", "torus", "--size", "48x36", "--methods", "phong,gouraud", "--max-error", "2lsb"];

#[test]
fn the_best_core_is_written_and_runs() {
    let place = Place::new();
    let said = place.succeeds(&SMALL);
    assert!(said.ends_with("out/torus-explored/spec.toml\n"), "{said}");
    place.succeeds(&["run", "torus", "--size", "48x36", "--core", "out/torus-explored"]);
    let report = place.report("out/torus");
    assert!(
        report["error"]["total"]["max_lsb"].as_f64().is_some_and(|error| error <= 2.0),
        "{said}"
    );
    assert_eq!(report["method"], "phong");
}

#[test]
fn fronts_are_for_programs_too() {
    let place = Place::new();
    let said = place.succeeds(&[&SMALL[..], &["--json", "--device", "ecp5-25"]].concat());
    let report: Value = serde_json::from_str(&said).expect("it prints JSON");
    let best = report["best"].as_u64().expect("there is one") as usize;
    assert_eq!(report["device"]["name"], "ecp5-25");
    let best = &report["front"][best];
    assert!(best["on_target"]["resources"]["blocks"].as_u64() > Some(0), "{said}");
    assert_eq!(best["spec"]["target"]["name"], "ecp5");
    let predicted = best["on_target"]["predicted_mhz"].as_f64();
    assert!(predicted >= best["spec"]["target"]["clock_mhz"].as_f64(), "{said}");
    assert_eq!(place.succeeds(&[&SMALL[..], &["--json", "--device", "ecp5-25"]].concat()), said);
}
