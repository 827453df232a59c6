//! What is wrong is said, with status 2, and nothing is left behind.
use std::fs;

use crate::program::Place;

/// What the program says of `arguments`, which are wrong; the folder must be as it was.
fn refusal(place: &Place, arguments: &[&str]) -> String {
    let before = place.names(".");
    let ended = place.specula(arguments);
    assert_eq!(
        (ended.status, ended.stdout.as_str()),
        (Some(2), ""),
        "{arguments:?}: {}",
        ended.stderr
    );
    assert_eq!(place.names("."), before, "{arguments:?} left something");
    format!(
        "$ specula {}\n{}\n",
        arguments.join(" ").escape_debug(),
        ended.stderr.replace('\\', "/")
    )
}

fn refusals(place: &Place, all: &[&[&str]]) -> String {
    all.iter().map(|arguments| refusal(place, arguments)).collect()
}

#[test]
fn wrong_words_are_refused() {
    let said = refusals(
        &Place::new(),
        &[
            &["run"],
            &["rum", "teapot"],
            &["run", "teapot", "--method", "toon"],
            &["generate", "teapot", "--method", "lyonn"],
            &["run", "teapot", "--engine", "abacus"],
            &["run", "teapot", "--size", "640"],
            &["run", "teapot", "--size", "0x0"],
            &["run", "teapot", "--size", "100000x100000"],
            &["run", "teapot", "--size", "-1x5"],
            &["run", "teapot", "--trace", "best"],
            &["run", "teapot", "--trace", "span=x"],
            &["run", "teapot", "--trace", "cycles=9..3"],
            &["run", "teapot", "--trace", "cycles=5"],
            &["run", "teapot", "-o", ""],
            &["run", "teapot", "--colour", "red"],
            &["run", "teapot", "--max-error", "-1lsb"],
            &["run", "teapot", "--bound", "0lsb"],
            &["run", "teapot", "--bound", "1lsb", "--max-error", "1lsb"],
            &["run", "teapot", "--max-error", "1lsb", "--max-quantisation", "1lsb"],
            &["run", "icosahedron", "--size", "16x12", "--max-error", "1lsb"],
            &["run", "icosahedron", "--size", "16x12", "--max-quantisation", "0.01lsb"],
            &["run", "icosahedron", "--size", "16x12", "--bound", "0.4lsb"],
            &["run", "spheres", "--size", "48x36", "--method", "phong", "--bound", "0.6lsb"],
            &["generate", "--spec", "out/spec.toml", "--bound", "1lsb"],
            &[
                "explore",
                "icosahedron",
                "--size",
                "16x12",
                "--methods",
                "gouraud",
                "--max-error",
                "0.6lsb",
            ],
            &["explore", "icosahedron", "--max-error", "1lsb", "--device", "abacus"],
            &["explore", "icosahedron"],
        ],
    );
    insta::assert_snapshot!(said);
}

#[test]
fn wrong_scenes_are_refused() {
    let place = Place::new();
    place.write("latin1.toml", b"# caf\xe9\n");
    place.write("typo.toml", "[[object]]\nprimitve = \"torus\"\n");
    let three = "[[object]]\nprimitive = \"torus\"\n[object.material]\nshininess = 3\n[core.hybrid]\npower = \"squaring\"\n";
    place.write("three.toml", three);
    place.write(
        "wide.toml",
        "[[object]]\nprimitive = \"torus\"\n[core.lyon.formats]\nvector = \"S1.60\"\n",
    );
    place.write("empty.obj", "");
    let said = refusals(
        &place,
        &[
            &["run", "teacup"],
            &["run", "figure9"],
            &["run", "missing.toml"],
            &["generate", "missing.ply"],
            &["run", "latin1.toml"],
            &["run", "typo.toml"],
            &["run", "three.toml", "--method", "hybrid"],
            &["generate", "wide.toml"],
            &["run", "empty.obj"],
            &["run", "."],
        ],
    );
    insta::assert_snapshot!(said);
}

#[test]
fn wrong_cores_are_refused() {
    let place = Place::new();
    place.succeeds(&["generate", "torus", "--size", "48x36", "-o", "core"]);
    place.write("old.toml", "version = 0\n");
    place.write("scene.toml", "[[object]]\nprimitive = \"torus\"\n");
    let said = refusals(
        &place,
        &[
            &["run", "teapot", "--size", "48x36", "--core", "core"],
            &["run", "torus", "--core", "nowhere"],
            &["run", "torus", "--core", "core", "--method", "phong"],
            &["generate", "--spec", "old.toml"],
            &["generate", "--spec", "scene.toml"],
            &["generate", "torus", "--spec", "core/spec.toml"],
            &["generate"],
        ],
    );
    insta::assert_snapshot!(said);
}

#[test]
fn paths_in_messages_are_whole() {
    let place = Place::new();
    let file = "robot-arm-left-upper-link-collision-mesh-v2-final-and-longer.obj";
    place.write(file, b"# caf\xe9\nno mesh at all\n");
    let path = place.path(file).display().to_string();
    for arguments in [["run", path.as_str()], ["generate", path.as_str()]] {
        let said = refusal(&place, &arguments);
        assert!(said.lines().skip(1).any(|line| line.contains(&path)), "{said}");
    }
}

#[test]
fn names_that_no_module_can_have() {
    let place = Place::new();
    let name =
        |name: &str| refusal(&place, &["generate", "teapot", "--size", "16x12", "--name", name]);
    let long = "a".repeat(49);
    let said: String = [
        "red",
        "normal_start_x",
        "reg",
        "entity",
        "Shader",
        "a b",
        "../a",
        "1st",
        "a__b",
        "",
        &long,
    ]
    .map(name)
    .concat();
    insta::assert_snapshot!(said);
}

#[test]
fn wrong_windows_are_refused() {
    let place = Place::new();
    let small =
        |trace: &str| refusal(&place, &["run", "icosahedron", "--size", "16x12", "--trace", trace]);
    let spans = small("span=18446744073709551615");
    let cycles = small("cycles=100000..100001");
    let said = spans + &cycles;
    insta::assert_snapshot!(said);
}

#[test]
fn wrong_folders_are_refused() {
    let place = Place::new();
    place.write("file", "");
    fs::create_dir(place.path("full")).unwrap();
    place.write("full/thesis.tex", "");
    fs::create_dir(place.path("foreign")).unwrap();
    place.write("foreign/report.json", "{}");
    let folders = ["file", "file/below", "full", "foreign", ".", "/"];
    let run =
        |folder: &&str| refusal(&place, &["run", "icosahedron", "--size", "16x12", "-o", folder]);
    let generate = refusal(&place, &["generate", "icosahedron", "-o", "file"]);
    let said = folders.iter().map(run).collect::<String>() + &generate;
    insta::assert_snapshot!(said);
    assert_eq!(
        (place.names("full"), place.names("foreign")),
        (vec!["thesis.tex".to_owned()], vec!["report.json".to_owned()])
    );
}

#[cfg(target_os = "linux")]
#[test]
fn places_where_nothing_can_be_written() {
    let place = Place::new();
    for command in ["run", "generate"] {
        let said = refusal(
            &place,
            &[command, "icosahedron", "--size", "16x12", "-o", "/proc/specula/out"],
        );
        assert!(said.contains("cannot write `/proc/specula/out"), "{said}");
    }
}

#[cfg(unix)]
#[test]
fn words_that_are_not_utf8() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let place = Place::new();
    let ended = place.specula(&[OsStr::new("run"), OsStr::from_bytes(b"caf\xe9.toml")]);
    assert_eq!(ended.status, Some(2));
    insta::assert_snapshot!(ended.stderr);
    // A folder may have any name.
    let ended = place.specula(&[
        OsStr::new("generate"),
        OsStr::new("icosahedron"),
        OsStr::new("-o"),
        OsStr::from_bytes(b"caf\xe9"),
    ]);
    assert_eq!(ended.status, Some(0), "{}", ended.stderr);
}

#[test]
fn a_run_is_not_replaced_under_somebodys_feet() {
    let place = Place::new();
    place.succeeds(&["run", "icosahedron", "--size", "16x12", "-o", "run"]);
    let ended = place.specula_in("run", &["run", "icosahedron", "--size", "16x12", "-o", "."]);
    assert_eq!(ended.status, Some(2));
    insta::assert_snapshot!(ended.stderr);
}
