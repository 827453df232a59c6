//! Cores from `spec.toml`: `run --core` and `generate --spec`.
use std::fs;

use crate::program::Place;

const SIZE: [&str; 2] = ["--size", "64x48"];

/// A Verilog file without its header, which names the command that made it.
fn modules(place: &Place, file: &str) -> String {
    let text = fs::read_to_string(place.path(file)).unwrap();
    text.lines().skip_while(|line| line.starts_with("//")).collect::<Vec<_>>().join("\n")
}

#[test]
fn the_same_core_is_made_again() {
    let place = Place::new();
    place.succeeds(&[
        "run",
        "teapot",
        SIZE[0],
        SIZE[1],
        "--method",
        "phong",
        "--max-error",
        "2lsb",
    ]);
    place.succeeds(&["generate", "--spec", "out/teapot/spec.toml", "-o", "again"]);
    place.succeeds(&["run", "teapot", SIZE[0], SIZE[1], "--core", "out/teapot", "-o", "run"]);
    assert_eq!(place.names("again"), ["spec.toml", "teapot.v"]);
    let spec = |folder: &str| fs::read(place.path(folder).join("spec.toml")).unwrap();
    for other in ["again", "run"] {
        assert!(spec(other) == spec("out/teapot"), "{other}");
        assert_eq!(
            modules(&place, &format!("{other}/teapot.v")),
            modules(&place, "out/teapot/teapot.v")
        );
    }
    let [one, other] = ["out/teapot", "run"].map(|folder| place.report(folder));
    assert_eq!(
        (&one["error"], &one["bound_lsb"], &one["spec"]),
        (&other["error"], &other["bound_lsb"], &other["spec"])
    );
    assert_eq!(other["command"], "specula generate --spec spec.toml");
}

#[test]
fn a_core_shades_a_scene_that_it_was_not_made_for() {
    let place = Place::new();
    place.succeeds(&[
        "generate",
        "spheres",
        SIZE[0],
        SIZE[1],
        "--specialise",
        "general",
        "-o",
        "core",
    ]);
    place.succeeds(&["run", "torus", SIZE[0], SIZE[1], "--core", "core/spec.toml"]);
    let report = place.report("out/torus");
    assert_eq!(
        (&report["scene"], &report["module"], &report["agrees"]),
        (&"torus".into(), &"spheres".into(), &true.into())
    );
    assert!(report["error"]["quantisation"]["max_lsb"].as_f64() <= report["bound_lsb"].as_f64());
    assert_eq!(modules(&place, "out/torus/spheres.v"), modules(&place, "core/spheres.v"));
}

#[test]
fn a_spec_in_the_folder_that_is_written_stays_as_it_is() {
    let place = Place::new();
    place.succeeds(&["generate", "teapot", "-o", "core"]);
    let path = place.path("core/spec.toml");
    let text = "# mine\n".to_owned() + &fs::read_to_string(&path).unwrap();
    fs::write(&path, &text).unwrap();
    assert_eq!(
        place.succeeds(&["generate", "--spec", "core/spec.toml", "-o", "core"]),
        "core/teapot.v\n"
    );
    assert_eq!(fs::read_to_string(&path).unwrap(), text);
}
