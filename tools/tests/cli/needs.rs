//! `specula needs`.
use serde_json::Value;

use crate::program::Place;

#[test]
fn a_scene_is_told_what_it_does_without() {
    let place = Place::new();
    insta::assert_snapshot!(place.succeeds(&["needs", "spheres", "--size", "104x40"]));
}

#[test]
fn every_built_in_scene_is_spared_hardware() {
    let place = Place::new();
    for scene in specula_fixtures::still_scenes() {
        let text = place.succeeds(&["needs", scene, "--size", "64x48", "--json"]);
        let report: Value = serde_json::from_str(&text).expect("it prints JSON");
        // Against both general cores, each with a name.
        let together = report["savings"]["together"].as_array().expect("general cores");
        assert_eq!(
            together.iter().map(|general| &general["baseline"]).collect::<Vec<_>>(),
            ["nothing", "renderer"]
        );
        for saves in together.iter().map(|general| &general["saves"]) {
            assert!(
                saves["multiplier_bits"].as_i64() > Some(0)
                    && saves["register_bits"].as_i64() > Some(0),
                "{scene}: {text}"
            );
        }
        assert!(
            report["needs"]["ranges"]["normal"].as_array().is_some_and(|axes| axes.len() == 3),
            "{scene}: {text}"
        );
    }
}

/// A mesh of two triangles, the second with this normal at its vertices.
fn two_triangles(normal: &str) -> String {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\nvn 0 0 1\n";
    format!("{corners}vn {normal}\nf 1//1 2//1 3//1\nf 2//2 4//2 3//2\n")
}

/// Normals that are the polygons' own are; others are shaded as they are, and so interpolated.
#[test]
fn flat_meshes_are_not_interpolated() {
    let place = Place::new();
    place.write("tilted.obj", two_triangles("0.4 0 0.9"));
    let report =
        place.succeeds(&["needs", "tilted.obj", "--method", "lyon", "--size", "64x48", "--json"]);
    let report: Value = serde_json::from_str(&report).expect("it prints JSON");
    assert_eq!(report["needs"]["flat"], Value::Bool(false));
    place.write("flat.obj", two_triangles("-0.5 -0.5 1"));
    place.succeeds(&["run", "flat.obj", "--method", "lyon", "--size", "64x48"]);
    let report = place.report("out/flat");
    assert_eq!(
        (&report["agrees"], &report["spec"]["method"]["lyon"]["normals"]),
        (&true.into(), &"flat".into())
    );
    let report =
        place.succeeds(&["needs", "flat.obj", "--method", "lyon", "--size", "64x48", "--json"]);
    let report: Value = serde_json::from_str(&report).expect("it prints JSON");
    assert_eq!(report["needs"]["flat"], Value::Bool(true));
}

/// Yosys is not everywhere; where it is not, it is named.
#[test]
fn cells_are_counted_if_asked_for() {
    let place = Place::new();
    let arguments =
        ["needs", "icosahedron", "--size", "24x18", "--method", "gouraud", "--synthesis", "--json"];
    let ended = place.specula(&arguments);
    if ended.stderr.contains("Yosys is not installed") && std::env::var_os("CI").is_none() {
        assert!(
            ended.status == Some(2) && ended.stderr.contains("leave out `--synthesis`"),
            "{}",
            ended.stderr
        );
        return;
    }
    assert_eq!(ended.status, Some(0), "{}", ended.stderr);
    let report: Value = serde_json::from_str(&ended.stdout).expect("it prints JSON");
    let cells = &report["savings"]["together"][0]["saves"]["cells"];
    assert!(
        cells["luts"].as_i64() > Some(0) && cells["flip_flops"].as_i64() > Some(0),
        "{}",
        ended.stdout
    );
    assert!(place.succeeds(&arguments[..7]).contains("MULT18X18D"));
}

/// A perspective camera is told of, and what it does with weights; others are not.
#[test]
fn perspective_is_named() {
    const TORUS: &str = "[[object]]\nprimitive = \"torus\"\n[core]\nmethod = \"lyon\"\n";
    let place = Place::new();
    let scene = |camera: &str| format!("[camera]\n{camera}{TORUS}");
    place.write("eye.toml", scene("kind = \"perspective\"\ninterpolation = \"perspective\"\n"));
    let text = place.succeeds(&["needs", "eye.toml", "--size", "64x48"]);
    let line = "perspective; weights are perspective-correct at the ends of spans";
    assert!(text.contains(line), "{text}");
    let text = place.succeeds(&["needs", "eye.toml", "--size", "64x48", "--json"]);
    let report: Value = serde_json::from_str(&text).expect("it prints JSON");
    assert_eq!(report["interpolation"], "perspective");
    place.succeeds(&["run", "eye.toml", "--size", "64x48"]);
    assert_eq!(place.report("out/eye")["interpolation"], "perspective");
    let text = place.succeeds(&["needs", "torus", "--size", "64x48", "--json"]);
    assert!(!text.contains("interpolation"), "{text}");
}
