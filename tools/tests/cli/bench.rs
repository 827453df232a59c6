//! `specula bench`.
use std::process::Command;

use serde_json::Value;

use crate::program::Place;

const QUICK: [&str; 9] =
    ["bench", "icosahedron", "--size", "32x24", "--rounds", "1", "--seconds", "0.001", "--method"];

/// What it prints where no tool is installed.
fn without_tools(arguments: &[&str]) -> String {
    let program = Command::new(env!("CARGO_BIN_EXE_specula"))
        .args(QUICK)
        .args(arguments)
        .env("PATH", "")
        .output()
        .unwrap();
    let stderr = String::from_utf8(program.stderr).unwrap();
    assert_eq!((program.status.code(), stderr.as_str()), (Some(0), ""));
    String::from_utf8(program.stdout).unwrap()
}

fn names(rows: &Value, engine: &str) -> Vec<String> {
    let of_engine = rows.as_array().unwrap().iter().filter(|row| row["engine"] == engine);
    of_engine.map(|row| row["mode"].as_str().unwrap().to_owned()).collect()
}

fn assert_rows_are_sound(report: &Value) {
    let verilator = report["rows"]
        .as_array()
        .unwrap()
        .iter()
        .find(|r| r["engine"] == "verilator" && r["mode"] == "outputs");
    for row in report["rows"].as_array().unwrap() {
        let rate = row["cycles_per_second"].as_f64().unwrap();
        assert!(rate > 0.0 && row["build_seconds"].as_f64().unwrap() > 0.0, "{row}");
        assert_eq!(row["rounds"], serde_json::json!([rate]));
        assert!(
            row["cycles"].as_u64().unwrap() > 0 && row["threads"].as_u64().unwrap() > 0,
            "{row}"
        );
        let expected =
            verilator.map(|verilator| rate / verilator["cycles_per_second"].as_f64().unwrap());
        let given = row["ratio_to_verilator"].as_f64();
        // Numbers are read to within a unit of the last place.
        let same = given
            .zip(expected)
            .map_or(given == expected, |(given, expected)| (given / expected - 1.0).abs() < 1e-12);
        assert!(same, "{expected:?}, {row}");
    }
}

#[test]
fn engines_of_ours_need_no_tool() {
    for method in ["lyon", "hybrid"] {
        let report: Value = serde_json::from_str(&without_tools(&[method, "--json"])).unwrap();
        assert_rows_are_sound(&report);
        let fast = names(&report["rows"], "fast");
        assert_eq!(fast[..5], ["outputs", "every-signal", "vcd", "vcd-null", "fst"], "{fast:?}");
        assert_eq!(names(&report["rows"], "rust-hdl"), ["outputs", "every-signal"]);
        let skipped: Vec<&Value> = report["skipped"]
            .as_array()
            .unwrap()
            .iter()
            .map(|skipped| &skipped["engine"])
            .collect();
        assert_eq!(skipped, ["verilator", "iverilog"]);
        assert_eq!((&report["method"], &report["scene"]), (&method.into(), &"icosahedron".into()));
        assert!(
            report["machine"]["cores"].as_u64() > Some(0)
                && report["design"]["signals"].as_u64() > Some(0)
        );
    }
}

#[test]
fn the_table_says_how_to_get_what_is_absent() {
    let table = without_tools(&["lyon"]);
    assert!(table.contains("\nengine") && table.contains("\nfast      outputs"), "{table}");
    assert!(
        table.contains(
            "\nwithout verilator: Verilator is not installed: install it with `apt install"
        ),
        "{table}"
    );
    assert!(
        table.contains(
            "\nwithout iverilog: Icarus Verilog is not installed: install it with `apt install"
        ),
        "{table}"
    );
    assert!(!table.contains(['\r', '\u{1b}']), "{table}");
}

/// By the smallest core: simulators' programs are compiled to be fast, which takes long.
#[test]
fn every_engine_that_is_installed_takes_part_and_its_pixels_are_right() {
    let place = Place::new();
    let report: Value =
        serde_json::from_str(&place.succeeds(&[&QUICK[..], &["gouraud", "--json"]].concat()))
            .unwrap();
    assert_rows_are_sound(&report);
    for (engine, modes) in [
        ("verilator", &["outputs", "every-signal", "vcd", "vcd-null"][..]),
        ("iverilog", &["outputs"]),
    ] {
        let is_absent = |skipped: &Value| skipped["engine"] == engine && skipped["mode"].is_null();
        let absent = report["skipped"].as_array().unwrap().iter().any(is_absent);
        assert!(!absent || std::env::var_os("CI").is_none(), "in CI every tool must be there");
        let given = names(&report["rows"], engine);
        assert!(if absent {
            given.is_empty()
        } else {
            given.starts_with(&modes.iter().map(|m| (*m).to_owned()).collect::<Vec<_>>())
        });
    }
    assert_eq!(place.names("."), [""; 0]);
}

#[test]
fn wrong_words_are_refused() {
    let place = Place::new();
    for arguments in [
        ["--seconds", "0"],
        ["--seconds", "x"],
        ["--rounds", "0"],
        ["--size", "0x0"],
        ["--method", "toon"],
    ] {
        let ended = place.specula(&[&["bench"][..], &arguments].concat());
        assert_eq!((ended.status, ended.stdout.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(
            ended.stderr.contains(&format!("invalid value '{}'", arguments[1])),
            "{}",
            ended.stderr
        );
    }
}
