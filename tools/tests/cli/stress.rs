//! `specula stress`.
use crate::program::Place;

const SMALL: [&str; 7] = ["stress", "--method", "gouraud", "--spans", "1", "-o", "stress"];

#[test]
fn it_writes_scenes_that_run_takes() {
    let place = Place::new();
    let table = place.succeeds(&SMALL);
    assert!(table.contains("What is wanted happens in every row."), "{table}");
    let text = std::fs::read_to_string(place.path("stress/report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(report["holds"], true);
    for file in report["files"].as_array().unwrap() {
        assert!(place.path(&format!("stress/{}", file.as_str().unwrap())).is_file(), "{file}");
    }
    let rows = report["rows"].as_array().unwrap();
    let wide = rows.iter().find(|row| row["row"] == "3").unwrap();
    let scene = wide["methods"][0]["scene"].as_str().unwrap();
    place.succeeds(&["run", &format!("stress/{scene}"), "--trace", "none"]);
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let place = Place::new();
    let [once, again] = [(); 2].map(|()| place.succeeds(&[&SMALL[..], &["--json"]].concat()));
    assert_eq!(once, again);
}

#[test]
fn the_search_for_broken_bounds_writes_scenes_that_run_takes() {
    let place = Place::new();
    let climb = ["stress", "--climb", "--method", "gouraud", "--scenes", "120", "-o", "climb"];
    let table = place.succeeds(&climb);
    assert!(table.contains("No bound is broken.") && table.contains("seed 1; 120 scenes"), "{table}");
    let [report, again] = [(); 2].map(|()| place.succeeds(&[&climb[..], &["--json"]].concat()));
    assert_eq!(report, again);
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    let largest = &report["methods"][0]["largest"];
    assert_eq!((&report["holds"], &report["methods"][0]["scenes"]), (&true.into(), &120.into()));
    let run = place.succeeds(&["run", "climb/highest_gouraud.toml", "--trace", "none", "--json"]);
    let run: serde_json::Value = serde_json::from_str(&run).unwrap();
    assert_eq!(run["error"]["quantisation"]["max_lsb"], largest["quantisation_lsb"], "{run}");
    assert_eq!(run["bound_lsb"], largest["bound_lsb"], "{run}");
}

#[test]
fn what_belongs_to_the_search_is_refused_without_it() {
    let place = Place::new();
    for wrong in [&["--scenes", "100"][..], &["--climb", "--spans", "3"], &["--climb", "--scenes", "0"]] {
        assert_eq!(place.specula(&[&["stress"][..], wrong].concat()).status, Some(2), "{wrong:?}");
    }
}
