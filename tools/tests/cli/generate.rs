//! `specula generate`.
use std::fs;

use crate::program::Place;

#[test]
fn the_verilog_is_that_of_run() {
    let place = Place::new();
    assert_eq!(place.succeeds(&["generate", "teapot", "--size", "64x48", "-o", "rtl"]), "rtl/teapot.v\nrtl/spec.toml\n");
    assert_eq!(place.names("rtl"), ["spec.toml", "teapot.v"]);
    place.succeeds(&["run", "teapot", "--size", "64x48"]);
    for file in ["teapot.v", "spec.toml"] {
        let [alone, run] = ["rtl", "out/teapot"].map(|folder| fs::read_to_string(place.path(folder).join(file)).unwrap());
        assert!(alone == run, "{file}");
    }
}

#[test]
fn headers_say_what_the_core_is() {
    let place = Place::new();
    for method in ["lyon", "hybrid"] {
        place.succeeds(&["generate", "teapot", "--method", method, "-o", method]);
        let text = fs::read_to_string(place.path(method).join("teapot.v")).unwrap();
        let header: Vec<&str> = text.lines().take_while(|line| line.starts_with("//")).collect();
        insta::assert_snapshot!(format!("header_of_{method}"), header.join("\n"));
    }
}

#[test]
fn names_that_verilog_keeps_are_avoided() {
    let place = Place::new();
    place.write("module.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(place.succeeds(&["generate", "module.obj"]), "out/module/module_core.v\nout/module/spec.toml\n");
}

#[test]
fn other_files_stay() {
    let place = Place::new();
    fs::create_dir(place.path("rtl")).unwrap();
    place.write("rtl/mine.v", "module mine; endmodule\n");
    place.succeeds(&["generate", "teapot", "-o", "rtl"]);
    place.succeeds(&["generate", "teapot", "-o", "rtl"]);
    assert_eq!(place.names("rtl"), ["mine.v", "spec.toml", "teapot.v"]);
}

#[test]
fn the_verilog_of_a_run_is_not_exchanged() {
    let place = Place::new();
    place.succeeds(&["run", "teapot", "--size", "64x48", "-o", "run"]);
    place.succeeds(&["generate", "teapot", "--size", "64x48", "-o", "run"]);
    let ended = place.specula(&["generate", "teapot", "--size", "64x48", "--method", "hybrid", "-o", "run"]);
    assert_eq!(ended.status, Some(2));
    insta::assert_snapshot!(ended.stderr);
    // A folder with nothing but a generated core can become a run's.
    place.succeeds(&["generate", "teapot", "-o", "core"]);
    place.succeeds(&["run", "teapot", "--size", "64x48", "-o", "core"]);
}
