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
