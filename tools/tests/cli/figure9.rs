//! `specula run figure9`.
use serde_json::{Value, json};

use crate::program::Place;

const SMALL: [&str; 4] = ["run", "figure9", "--size", "97x33"];

#[test]
fn every_row_agrees_and_is_its_formula() {
    let place = Place::new();
    let printed = place.succeeds(&SMALL);
    let report = place.report("out/figure9");
    assert_eq!((&report["radius"], &report["agrees"]), (&json!(16), &json!(true)));
    let rows = report["rows"].as_array().expect("rows are a list");
    assert_eq!(rows.len(), 12);
    for row in rows {
        let number = |value: &Value| value.as_f64().expect("a number");
        let title = row["title"].as_str().expect("a title");
        assert!(printed.contains(title), "{title} is not printed");
        assert_eq!(row["mismatches"], 0, "{title}");
        let (error, bound) = (number(&row["error"]["max_lsb"]), number(&row["bound_lsb"]));
        assert!(error <= bound && error < 1.5, "{title}: off by {error} LSB, bound {bound}");
    }
    let files: Vec<&str> = report["files"].as_array().expect("files").iter().filter_map(Value::as_str).collect();
    let mut names = files.clone();
    names.sort_unstable();
    assert_eq!(place.names("out/figure9"), names);
    assert!(files.contains(&"figure9.png") && files.contains(&"figure9_row11.v"));
}

#[test]
fn what_is_for_one_core_is_refused() {
    let place = Place::new();
    for (arguments, said) in [
        (["--method", "phong"], "--method"),
        (["--specialise", "general"], "--specialise"),
        (["--max-error", "1lsb"], "--max-error"),
        (["--device", "xc7a35t"], "--device"),
        (["--clock", "100"], "--clock"),
        (["--trace", "all"], "--trace"),
        (["--size", "6x480"], "6x480"),
    ] {
        let ended = place.specula(&["run", "figure9", arguments[0], arguments[1]]);
        assert_eq!(ended.status, Some(2), "{arguments:?}");
        assert!(ended.stderr.contains(said), "{}", ended.stderr);
        assert!(place.names(".").is_empty());
    }
}
