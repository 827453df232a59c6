//! Replacing what an earlier run wrote.
use std::fs;

use crate::program::Place;

fn run(place: &Place, scene: &str, folder: &str) {
    place.succeeds(&["run", scene, "--size", "16x12", "-o", folder]);
}

#[test]
fn files_of_an_earlier_run_go_and_others_stay() {
    let place = Place::new();
    run(&place, "teapot", "run");
    place.write("run/notes.md", "mine");
    fs::create_dir(place.path("run/obj_dir")).unwrap();
    place.write("run/obj_dir/Vteapot.mk", "mine too");
    run(&place, "icosahedron", "run");
    let names = place.names("run");
    assert!(!names.contains(&"teapot.v".to_owned()), "{names:?}");
    for name in ["icosahedron.v", "notes.md", "obj_dir", "report.json"] {
        assert!(names.contains(&name.to_owned()), "{names:?}");
    }
    assert_eq!(fs::read_to_string(place.path("run/obj_dir/Vteapot.mk")).unwrap(), "mine too");
    assert_eq!(place.names("."), ["run"]);
}

#[test]
fn a_refused_run_leaves_the_earlier_one_as_it_was() {
    let place = Place::new();
    run(&place, "teapot", "run");
    let before = fs::read(place.path("run/report.json")).unwrap();
    let ended = place.specula(&["run", "teapot", "--size", "16x12", "-o", "run", "--trace", "span=100000"]);
    assert_eq!(ended.status, Some(2));
    assert_eq!(fs::read(place.path("run/report.json")).unwrap(), before);
    assert_eq!(place.names("."), ["run"]);
}

#[test]
fn an_empty_folder_and_folders_that_are_not_there_are_filled() {
    let place = Place::new();
    fs::create_dir(place.path("empty")).unwrap();
    run(&place, "teapot", "empty");
    run(&place, "teapot", "a/b/c");
    assert_eq!(place.names("a/b"), ["c"]);
    assert!(place.names("empty").contains(&"report.json".to_owned()));
}

#[cfg(unix)]
#[test]
fn a_link_to_a_folder_stays_a_link() {
    let place = Place::new();
    fs::create_dir(place.path("disk")).unwrap();
    std::os::unix::fs::symlink("disk", place.path("run")).unwrap();
    run(&place, "teapot", "run");
    assert!(place.path("run").symlink_metadata().unwrap().is_symlink());
    assert!(place.names("disk").contains(&"report.json".to_owned()));
    std::os::unix::fs::symlink("nowhere", place.path("dangling")).unwrap();
    let ended = place.specula(&["run", "teapot", "--size", "16x12", "-o", "dangling"]);
    assert_eq!(ended.status, Some(2), "{}", ended.stderr);
}

#[cfg(unix)]
#[test]
fn results_can_be_read_by_others_as_the_user_has_it() {
    use std::os::unix::fs::PermissionsExt;
    let place = Place::new();
    fs::create_dir(place.path("usual")).unwrap();
    run(&place, "teapot", "run");
    let mode = |name: &str| fs::metadata(place.path(name)).unwrap().permissions().mode();
    assert_eq!(mode("run"), mode("usual"));
}
