//! `specula reproduce`.
use std::fs;
use std::process::Command;

use specula_fixtures::tools;

use crate::program::Place;

/// What is checked in is what the program writes: the text, and every picture that it shows.
#[test]
fn the_document_is_what_it_writes() {
    let place = Place::new();
    let printed = place.succeeds(&["reproduce", "-o", "out"]);
    assert!(fs::read_to_string(place.path("out/reproduction.md")).unwrap() == printed);
    let checked_in = fs::read_to_string("../docs/reproduction.md").unwrap();
    let first = checked_in.lines().zip(printed.lines()).find(|(checked_in, now)| checked_in != now);
    assert!(checked_in == printed, "docs/reproduction.md is not what is written; first {first:#?}");
    let names = place.names("out/images");
    assert!(names.len() > 10, "{names:?}");
    for name in names {
        assert!(printed.contains(&format!("(images/{name})")), "{name} is not shown");
        let written = fs::read(place.path(&format!("out/images/{name}"))).unwrap();
        assert!(
            fs::read(format!("../docs/images/{name}")).unwrap() == written,
            "docs/images/{name} differs"
        );
    }
}

#[test]
fn a_paper_and_a_mesh_can_be_chosen() {
    let place = Place::new();
    place.write(
        "roof.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0.3\nv 0 1 0.3\nv 0 2 0\nv 1 2 0\nf 1 2 3 4\nf 4 3 6 5\n",
    );
    let text = place.succeeds(&["reproduce", "hast", "--mesh", "roof.obj", "-o", "out"]);
    assert!(text.contains("figures 1 to 3 on the roof") && !text.contains("Lyon"), "{text}");
    assert!(place.names("out/images").contains(&"hast_figures_1_to_3_roof.png".to_owned()));
}

/// Times differ from run to run; that every loop is there, and every claim has a verdict, does not.
#[test]
fn the_project_times_three_models() {
    let place = Place::new();
    place.write("roof.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.3\nv 0 1 0.3\nf 1 2 3 4\n");
    let arguments = ["reproduce", "project", "--mesh", "roof.obj", "--rounds", "1", "-o", "out"];
    let text = place.succeeds(&arguments);
    assert!(fs::read_to_string(place.path("out/project.md")).unwrap() == text);
    for model in ["teapot", "torus", "roof"] {
        for illumination in ["at infinity", "at places"] {
            assert!(
                text.contains(&format!("## {model}, {illumination}")),
                "{model} {illumination}"
            );
        }
    }
    assert!(!text.contains("not timed") && !text.contains("NaN"), "{text}");
    assert_eq!(text.matches("| reflection shading, eq. 34 |").count(), 6, "{text}");
}

#[test]
fn what_is_no_mesh_is_refused() {
    let place = Place::new();
    place.write("not.obj", "nothing");
    for (mesh, reason) in
        [("not.obj", "not.obj"), ("absent.ply", "absent.ply"), ("teapot", "teapot")]
    {
        let ended = place.specula(&["reproduce", "hast", "--mesh", mesh]);
        assert!(
            ended.status == Some(2) && ended.stderr.contains(reason) && ended.stdout.is_empty(),
            "{mesh}: {ended:?}"
        );
    }
}

/// Coarse formats make small cores, which take seconds.
#[test]
fn gates_of_lyon_and_phong_are_counted_at_equal_error() {
    if !tools::is_installed("yosys") {
        return;
    }
    let place = Place::new();
    let arguments = "reproduce gates icosahedron --size 24x18 --max-quantisation 24lsb --specialise scene -o out";
    let text = place.succeeds(&arguments.split(' ').collect::<Vec<_>>());
    assert!(fs::read_to_string(place.path("out/gates.md")).unwrap() == text);
    assert!(text.contains("## For this scene alone, n = 16\n"), "{text}");
    assert!(!text.contains("any scene, n"), "{text}");
    let rows: Vec<Vec<&str>> = text
        .lines()
        .filter(|line| line.starts_with("| Phong |") || line.starts_with("| Lyon"))
        .map(|line| line.split('|').map(str::trim).collect::<Vec<_>>())
        .filter(|cells| cells.len() > 10)
        .collect();
    assert_eq!(rows.len(), 4, "{text}");
    for row in &rows {
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        let [quantisation, gates, flip_flops, luts] = [3, 4, 5, 6].map(number);
        assert!(quantisation <= 24.0 && gates > luts && luts > 100.0, "{row:?}");
        assert!(flip_flops > 100.0, "{row:?}");
    }
    assert!(text.contains("| two-input gates, figures 6 and 7 / Phong |"), "{text}");
}

#[test]
fn counting_without_yosys_is_refused_at_once() {
    let program = Command::new(env!("CARGO_BIN_EXE_specula"))
        .args(["reproduce", "gates"])
        .env("PATH", "")
        .output()
        .unwrap();
    let stderr = String::from_utf8(program.stderr).unwrap();
    assert_eq!((program.status.code(), program.stdout.len()), (Some(2), 0), "{stderr}");
    assert!(stderr.contains("Yosys"), "{stderr}");
}
