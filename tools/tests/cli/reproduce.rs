//! `specula reproduce`.
use std::fs;

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
