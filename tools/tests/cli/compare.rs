//! `specula compare`.
use std::fs;

use serde_json::Value;

use crate::program::Place;

const SMALL: [&str; 8] = [
    "compare",
    "icosahedron",
    "--size",
    "48x36",
    "--methods",
    "lyon,gouraud",
    "--formats",
    "-4,default",
];

fn compare(place: &Place, folder: &str, more: &[&str]) -> String {
    place.succeeds(&[&SMALL[..], &["-o", folder], more].concat())
}

fn text(place: &Place, file: &str) -> String {
    fs::read_to_string(place.path(file)).expect("it is there")
}

#[test]
fn it_measures_errors_run_times_and_sizes() {
    let place = Place::new();
    let table = compare(&place, "c", &["--clock", "200"]);
    assert!(
        table.contains("a given 200 MHz")
            && table.contains("gouraud -4")
            && table.contains("fast-phong"),
        "{table}"
    );
    let report = place.report("c");
    assert_eq!((&report["agrees"], &report["clock_is_assumed"]), (&true.into(), &false.into()));
    for file in report["files"].as_array().expect("a list") {
        assert!(place.path(&format!("c/{}", file.as_str().expect("a name"))).is_file(), "{file}");
    }
    let cores = report["cores"].as_array().expect("a list");
    assert_eq!(cores.len(), 4);
    for core in cores {
        let number = |key: &str| core[key].as_f64().expect("a number");
        assert!(
            core["surface"]["rms_lsb"].as_f64() > Some(0.0),
            "an icosahedron stands for a sphere: {core}"
        );
        // 200 MHz: 5 ns a clock.
        assert!(
            (number("ns_per_pixel") - 5.0 * number("cycles_per_pixel_with_set_up")).abs() < 1e-9,
            "{core}"
        );
        assert!(
            number("cycles_per_pixel_with_set_up") > number("cycles_per_pixel")
                && number("cycles_per_pixel") > 1.0,
            "{core}"
        );
    }
    assert_eq!(text(&place, "c/cores.csv").lines().count(), 5);
    assert_eq!(report["interpolation"]["rms_lsb"].as_f64().map(|rms| rms > 0.0), Some(true));
}

/// A loop that takes one clock limits the clock of the whole core: Newton's root of the pixel before
/// is what the next pixel begins with.
#[test]
fn a_loop_of_one_clock_is_slow() {
    let place = Place::new();
    let scene = |root: &str| {
        format!(
            "[[object]]\nprimitive = \"icosahedron\"\n[core]\nmethod = \"direct\"\n[core.direct]\nroot = \"{root}\"\n"
        )
    };
    let time = |root: &str| {
        place.write(&format!("{root}.toml"), scene(root));
        let file = format!("{root}.toml");
        let small = ["compare", &file, "--size", "32x24", "--methods", "direct"];
        let more = ["--formats", "default", "--target", "ecp5", "-o", root];
        let said = place.succeeds(&[&small[..], &more].concat());
        assert!(said.contains("the delays of ecp5 predict"), "{said}");
        let core = place.report(root)["cores"][0].clone();
        [&core["clock_mhz"], &core["ns_per_pixel"], &core["cycles_per_pixel_with_set_up"]]
            .map(|number| number.as_f64().expect("a number"))
    };
    let [fast, slow] = ["exact", "newton"].map(time);
    for [mhz, nanoseconds, clocks] in [fast, slow] {
        assert!((nanoseconds - 1000.0 * clocks / mhz).abs() < 1e-9 * nanoseconds);
    }
    assert!(fast[0] > 2.0 * slow[0] && slow[1] > 2.0 * fast[1], "{fast:?} {slow:?}");
}

/// All but what is measured of the machine.
#[test]
fn the_same_comparison_gives_the_same_bytes() {
    let place = Place::new();
    let [mut once, mut again] = ["once", "again"].map(|folder| {
        compare(&place, folder, &[]);
        place.report(folder)
    });
    for report in [&mut once, &mut again] {
        report["software"] = Value::Null;
    }
    assert_eq!(once, again);
    for file in [
        "cores.csv",
        "results.jsonl",
        "error-size.svg",
        "error-size.png",
        "error-time.svg",
        "error-time.png",
    ] {
        let [once, again] = ["once", "again"]
            .map(|folder| fs::read(place.path(&format!("{folder}/{file}"))).expect("it is there"));
        assert!(once == again, "{file}");
    }
}

#[test]
fn an_interrupted_sweep_goes_on_where_it_stopped() {
    let place = Place::new();
    compare(&place, "whole", &[]);
    let whole = text(&place, "whole/results.jsonl");
    let lines: Vec<&str> = whole.lines().collect();
    // One result is known (and marked, so that it can be told from one that is measured again), one
    // is damaged, two are missing.
    let marked = lines[0].replacen("\"latency\":", "\"latency\":9", 1);
    fs::create_dir(place.path("part")).expect("there is room");
    place.write("part/results.jsonl", format!("{marked}\n{}", &lines[1][..80]));
    let ended = place.specula(&[&SMALL[..], &["-o", "part"]].concat());
    let said =
        "part/results.jsonl, line 2: it has no end; what it held is measured again\n".to_owned();
    assert_eq!((ended.status, ended.stderr), (Some(0), said));
    assert!(
        ended.stdout.contains("1 of 4 cores were known from results.jsonl"),
        "{}",
        ended.stdout
    );
    let part = text(&place, "part/results.jsonl");
    assert_eq!(part.lines().collect::<Vec<_>>(), [&[marked.as_str()], &lines[1..]].concat());
    compare(&place, "part", &["--fresh"]);
    assert_eq!(text(&place, "part/results.jsonl"), whole);
}

/// Files that a killed sweep leaves: its journal, what was to take the place of a damaged one, and
/// both in the folder of another command's results.
#[test]
fn a_killed_sweep_leaves_a_folder_that_the_next_knows() {
    let place = Place::new();
    compare(&place, "whole", &[]);
    let whole = text(&place, "whole/results.jsonl");
    let first = whole.lines().next().expect("it has lines");
    place.succeeds(&["run", "icosahedron", "--size", "16x12", "-o", "run"]);
    fs::create_dir(place.path("part")).expect("there is room");
    for folder in ["part", "run"] {
        place.write(&format!("{folder}/results.jsonl"), format!("{first}\n{}", &first[..80]));
        place.write(&format!("{folder}/.results.jsonl-Yd3kQz"), &first[..300]);
        place.write(&format!("{folder}/.results.jsonl-begun0"), "");
        place.write(&format!("{folder}/.results.jsonl-list"), "mine");
    }
    let refused = place.specula(&[&SMALL[..], &["-o", "part"]].concat());
    assert_eq!(refused.status, Some(2));
    assert!(refused.stderr.contains("`.results.jsonl-list`"), "{}", refused.stderr);
    fs::remove_file(place.path("part/.results.jsonl-list")).expect("it is there");
    for folder in ["part", "run"] {
        let ended = place.specula(&[&SMALL[..], &["-o", folder]].concat());
        assert_eq!(ended.status, Some(0), "{folder}: {}", ended.stderr);
        assert!(ended.stdout.contains("1 of 4 cores were known"), "{}", ended.stdout);
        assert_eq!(text(&place, &format!("{folder}/results.jsonl")), whole);
    }
    let mine = |folder| place.names(folder).into_iter().filter(|name| name.starts_with('.'));
    assert_eq!(mine("part").count(), 0);
    assert_eq!(mine("run").collect::<Vec<_>>(), [".results.jsonl-list"]);
}

/// Exponents that squaring, which two methods are told to use, does not reach.
const THREE: &str = "[[object]]\nprimitive = \"torus\"\n[object.material]\nshininess = 3\n\n\
    [core.slerp]\npower = \"squaring\"\n[core.duff]\npower = \"squaring\"\n";

#[test]
fn where_no_method_serves_nothing_is_written() {
    let place = Place::new();
    place.write("three.toml", THREE);
    let ended = place.specula(&[
        "compare",
        "three.toml",
        "--size",
        "32x24",
        "--methods",
        "slerp,duff",
        "-o",
        "c",
    ]);
    assert_eq!(ended.status, Some(2), "{ended:?}");
    assert!(
        ended.stderr.contains("there is nothing to compare") && ended.stderr.contains("slerp -8: "),
        "{}",
        ended.stderr
    );
    assert_eq!(place.names("."), ["three.toml"]);
}

/// Methods that do not serve a scene do not keep others from being compared.
#[test]
fn what_cannot_be_built_is_told() {
    let place = Place::new();
    place.write("three.toml", THREE);
    let words = [
        "compare",
        "three.toml",
        "--size",
        "32x24",
        "--methods",
        "slerp,phong",
        "--formats",
        "default",
        "-o",
        "c",
    ];
    let table = place.succeeds(&words);
    assert!(
        table.contains("not built: slerp default: ") && table.contains("phong default"),
        "{table}"
    );
}

/// Where lights are at places, the loops that have them are timed, and those that have not left
/// out.
#[test]
fn loops_for_lights_at_places_are_timed_where_there_are_some() {
    let place = Place::new();
    let words = [
        "compare",
        "lamps",
        "--size",
        "32x24",
        "--methods",
        "phong",
        "--formats",
        "default",
        "-o",
        "c",
    ];
    let table = place.succeeds(&words);
    let report = fs::read_to_string(place.path("c/report.md")).expect("a report");
    // Every loop takes lights at places.
    for text in [&table, &report] {
        assert!(text.contains("fast-phong-2"), "{text}");
    }
    for name in ["| uniform |", "| gouraud |", "| phong-places |", "| phong-wrapped-places |"] {
        assert!(report.contains(name), "{name} is not in {report}");
    }
    assert!(place.path("c/error-software.svg").exists() && place.path("c/error-size.svg").exists());
}
