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
    let ended =
        place.specula(&["run", "teapot", "--size", "16x12", "-o", "run", "--trace", "span=100000"]);
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

/// What every command says of a folder in which a foreign file has the name of one that it would
/// write.
fn refused(place: &Place, arguments: &[&str], file: &str) {
    let before = fs::read(place.path(file)).unwrap();
    let ended = place.specula(arguments);
    assert_eq!(
        (ended.status, ended.stdout.as_str()),
        (Some(2), ""),
        "{arguments:?}: {}",
        ended.stderr
    );
    let name = file.rsplit_once('/').unwrap().1;
    assert!(ended.stderr.contains(&format!("`{name}`")), "{arguments:?}: {}", ended.stderr);
    assert!(fs::read(place.path(file)).unwrap() == before, "{arguments:?}");
}

#[test]
fn no_command_replaces_what_specula_did_not_write() {
    let place = Place::new();
    let foreign = |folder: &str, name: &str, text: &str| {
        fs::create_dir_all(place.path(folder)).unwrap();
        place.write(&format!("{folder}/{name}"), text);
        format!("{folder}/{name}")
    };
    let package = "[package]\nname = \"mine\"\n";
    let spec = foreign("a", "spec.toml", package);
    refused(&place, &["generate", "teapot", "-o", "a"], &spec);
    let explore = [
        "explore",
        "icosahedron",
        "--size",
        "16x12",
        "--methods",
        "gouraud",
        "--max-error",
        "255lsb",
        "-o",
        "a",
    ];
    refused(&place, &explore, &spec);
    let verilog = foreign("b", "teapot.v", "module teapot;\nendmodule\n");
    refused(&place, &["generate", "teapot", "-o", "b"], &verilog);
    // Without a report that is Specula's the folder is not Specula's, whatever its files are called.
    for (name, text) in [
        ("report.md", "# mine\n"),
        ("spec.toml", package),
        ("report.json", "{\"files\":[\"report.json\"]}"),
    ] {
        let file = foreign(&format!("run-{name}"), name, text);
        refused(
            &place,
            &["run", "teapot", "--size", "16x12", "-o", file.rsplit_once('/').unwrap().0],
            &file,
        );
    }
    let results = foreign("c", "results.jsonl", "{\"accuracy\":1}\n");
    refused(&place, &["compare", "icosahedron", "--size", "16x12", "-o", "c"], &results);
    let report = foreign("s", "report.md", "# mine\n");
    refused(&place, &["stress", "-o", "s"], &report);
    let document = foreign("r", "reproduction.md", "# mine\n");
    refused(&place, &["reproduce", "lecture", "-o", "r"], &document);
}

#[test]
fn a_file_of_the_users_in_the_folder_of_a_run_is_not_taken_for_one_of_the_runs() {
    let place = Place::new();
    run(&place, "teapot", "run");
    // A run may write one of that name, but this one has not.
    place.write("run/trace.fst", "mine");
    refused(&place, &["run", "teapot", "--size", "16x12", "-o", "run"], "run/trace.fst");
    fs::remove_file(place.path("run/trace.fst")).unwrap();
    fs::create_dir(place.path("run/trace.fst")).unwrap();
    assert_eq!(place.specula(&["run", "teapot", "--size", "16x12", "-o", "run"]).status, Some(2));
    fs::remove_dir(place.path("run/trace.fst")).unwrap();
    run(&place, "teapot", "run");
}

#[test]
fn every_command_knows_the_folder_that_it_wrote() {
    let place = Place::new();
    for arguments in [
        &["run", "icosahedron", "--size", "16x12"][..],
        &["reproduce", "figure9", "--size", "28x76"],
        &[
            "compare",
            "icosahedron",
            "--size",
            "16x12",
            "--methods",
            "gouraud",
            "--formats",
            "default",
        ],
        &["stress", "--method", "gouraud", "--spans", "1"],
        &["stress", "--method", "gouraud", "--climb", "--scenes", "20"],
    ] {
        let arguments = [arguments, &["-o", "folder"]].concat();
        for _ in 0..2 {
            let ended = place.specula(&arguments);
            assert_eq!(ended.status, Some(0), "{arguments:?}: {}", ended.stderr);
        }
        fs::remove_dir_all(place.path("folder")).unwrap();
    }
}

#[test]
fn a_core_that_was_generated_is_replaced_by_another() {
    let place = Place::new();
    place.succeeds(&["generate", "teapot", "-o", "core"]);
    place.succeeds(&["generate", "teapot", "--method", "hybrid", "-o", "core"]);
    assert_eq!(place.names("core"), ["spec.toml", "teapot.v"]);
}

#[cfg(target_os = "linux")]
#[test]
fn reports_and_results_are_read_if_they_are_regular_files() {
    use std::os::unix::fs::symlink;
    let place = Place::new();
    let make = |folder: &str, name: &str, pipe: bool| {
        fs::create_dir(place.path(folder)).unwrap();
        let path = place.path(folder).join(name);
        if pipe {
            assert!(std::process::Command::new("mkfifo").arg(path).status().unwrap().success());
        } else {
            symlink("/dev/zero", path).unwrap();
        }
    };
    for (folder, name, pipe) in [
        ("zero", "report.json", false),
        ("pipe", "report.json", true),
        ("zeros", "results.jsonl", false),
        ("pipes", "results.jsonl", true),
    ] {
        make(folder, name, pipe);
        for command in ["run", "compare"] {
            let ended = place.specula(&[command, "icosahedron", "--size", "16x12", "-o", folder]);
            assert_eq!(ended.status, Some(2), "{command} {folder}");
            assert!(
                ended.stderr.contains(&format!("`{name}`")),
                "{command} {folder}: {}",
                ended.stderr
            );
        }
    }
    // Beside a report that lists it, too.
    run(&place, "icosahedron", "run");
    let listing = fs::read_to_string(place.path("run/report.json"))
        .unwrap()
        .replace("\"report.json\"", "\"results.jsonl\"");
    fs::create_dir(place.path("listed")).unwrap();
    place.write("listed/report.json", listing.replace("\"simulated.png\"", "\"report.json\""));
    symlink("/dev/zero", place.path("listed/results.jsonl")).unwrap();
    let ended = place.specula(&["compare", "icosahedron", "--size", "16x12", "-o", "listed"]);
    assert_eq!(ended.status, Some(2), "{}", ended.stderr);
}

#[cfg(unix)]
mod interrupted {
    use super::*;
    use std::process::{Child, Command, Stdio};
    use std::thread;
    use std::time::{Duration, Instant};

    /// A run that is writing results.
    fn writing(place: &Place) -> Child {
        let mut program = Command::new(env!("CARGO_BIN_EXE_specula"));
        program.args(["run", "teapot", "--size", "1600x1200", "--trace", "all", "-o", "here/out"]);
        let child = program
            .current_dir(place.path("."))
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let begin = Instant::now();
        let writes = || {
            let hidden = fs::read_dir(place.path("here")).into_iter().flatten().flatten();
            hidden.map(|entry| entry.path().join("folder/out/trace.vcd")).any(|dump| dump.exists())
        };
        while !writes() {
            assert!(begin.elapsed() < Duration::from_secs(60), "nothing is written");
            thread::sleep(Duration::from_millis(5));
        }
        child
    }

    fn signal(child: &Child, name: &str) {
        assert!(
            Command::new("kill")
                .args([format!("-{name}"), child.id().to_string()])
                .status()
                .unwrap()
                .success()
        );
    }

    #[test]
    fn signals_leave_nothing() {
        for (name, number) in [("INT", 2), ("TERM", 15), ("HUP", 1)] {
            let place = Place::new();
            let child = writing(&place);
            signal(&child, name);
            let ended = child.wait_with_output().unwrap();
            assert_eq!(
                (ended.status.code(), ended.stderr.as_slice()),
                (Some(128 + number), &b""[..]),
                "{name}"
            );
            assert!(place.names(".").is_empty(), "{name}: {:?}", place.names("."));
        }
    }

    #[test]
    fn what_a_kill_leaves_is_removed_by_the_next_run() {
        let place = Place::new();
        let mut child = writing(&place);
        child.kill().unwrap();
        child.wait().unwrap();
        let left = place.names("here");
        assert_eq!(left.len(), 1, "{left:?}");
        let ended = place.specula(&["generate", "icosahedron", "-o", "here"]);
        assert_eq!(ended.status, Some(0), "{}", ended.stderr);
        assert!(
            ended.stderr.starts_with("removed `") && ended.stderr.contains(&left[0]),
            "{}",
            ended.stderr
        );
        assert_eq!(place.names("here"), ["icosahedron.v", "spec.toml"]);
    }

    #[test]
    fn what_another_run_is_writing_is_left_alone() {
        let place = Place::new();
        let mut child = writing(&place);
        place.succeeds(&["run", "icosahedron", "--size", "16x12", "-o", "here/other"]);
        assert!(place.names("here").iter().any(|name| name.starts_with(".specula-")));
        child.kill().unwrap();
        child.wait().unwrap();
    }
}
