//! `specula schedule`.
use std::fs;

use serde_json::Value;

use crate::program::Place;

const SCENE: [&str; 6] = ["schedule", "torus", "--size", "32x24", "--method", "gouraud"];
const TARGET: [&str; 4] = ["--target", "ecp5", "--clock", "150"];

fn json(place: &Place, words: &[&str]) -> Value {
    let text = place.succeeds(&[&["schedule", "--json"], words].concat());
    serde_json::from_str(&text).expect("it prints JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

#[test]
fn a_core_for_any_device_is_shown_without_nanoseconds() {
    insta::assert_snapshot!(Place::new().succeeds(&SCENE));
}

#[test]
fn a_core_for_a_clock_is_shown_with_its_paths() {
    let place = Place::new();
    let words = [&SCENE[..], &TARGET].concat();
    insta::assert_snapshot!("for_a_clock", place.succeeds(&words));
    let all = place.succeeds(&[&words[..], &["--all"]].concat());
    let first: Vec<&str> = all.split("\n\n").take(2).collect();
    insta::assert_snapshot!("all_of_two_clocks", first.join("\n\n"));
}

#[test]
fn a_row_of_the_picture_is_a_clock() {
    let place = Place::new();
    place.succeeds(&[&SCENE[..], &TARGET, &["-o", "schedule.svg"]].concat());
    let svg = fs::read_to_string(place.path("schedule.svg")).unwrap();
    insta::assert_snapshot!("svg", svg);
    place.succeeds(&[&SCENE[..], &["-o", "generic.svg"]].concat());
    assert!(!fs::read_to_string(place.path("generic.svg")).unwrap().contains("longest path"));
    let refused = place.specula(&[&SCENE[..], &["-o", "schedule.png"]].concat());
    assert_eq!(refused.status, Some(2));
    assert!(refused.stderr.contains("ends in .svg"), "{}", refused.stderr);
    assert!(!place.path("schedule.png").exists());
}

#[test]
fn figures_add_up() {
    let place = Place::new();
    for method in ["lyon", "hybrid", "slerp"] {
        for target in [&[][..], &TARGET] {
            let words = [&["teapot", "--size", "48x36", "--method", method], target].concat();
            let schedule = json(&place, &words);
            let stages = schedule["stages"].as_array().expect("a list");
            for kind in ["in_blocks", "flip_flops", "in_memories", "total"] {
                let sum: f64 = stages.iter().map(|stage| number(&stage["carried"][kind])).sum();
                assert_eq!(sum, number(&schedule["register_bits"][kind]), "{method} {kind}");
            }
            assert_eq!(stages.len() as f64, number(&schedule["latency"]) + 1.0);
            let paths = stages.iter().map(|stage| &stage["longest_path"]);
            if target.is_empty() {
                assert!(paths.clone().all(Value::is_null) && schedule["made_for"].is_null());
                continue;
            }
            let slowest = paths.map(|path| path["ns"].as_f64().unwrap_or(0.0)).fold(0.0, f64::max);
            assert_eq!(slowest, number(&schedule["slowest_path"]["ns"]));
            let predicted = number(&schedule["made_for"]["predicted_mhz"]);
            assert!((predicted - 1000.0 / slowest).abs() < 1e-9);
        }
    }
}

#[test]
fn a_loop_that_limits_the_clock_is_named() {
    let schedule = json(&Place::new(), &["teapot", "--method", "slerp", "--target", "ecp5"]);
    let limit = &schedule["limited_by"];
    assert_eq!(limit["kind"], "loop");
    assert!(limit["from"].as_str().expect("a name").starts_with("rotation."), "{limit}");
    let highest = number(&schedule["highest_mhz"]);
    assert!(number(&limit["ns"]) > 1000.0 / (highest + 1.0), "{schedule}");
}

#[test]
fn a_core_made_before_is_shown() {
    let place = Place::new();
    let words = [&["generate"], &SCENE[1..], &TARGET, &["-o", "core"]].concat();
    place.succeeds(&words);
    assert_eq!(
        place.succeeds(&["schedule", "--spec", "core"]),
        place.succeeds(&[&SCENE[..], &TARGET].concat())
    );
}
