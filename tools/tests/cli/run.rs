//! `specula run`.
use std::fs;

use serde_json::Value;
use specula_fixtures::tools;

use crate::program::Place;

const FILES: [&str; 12] = [
    "error.png",
    "exact.png",
    "expected.png",
    "report.html",
    "report.json",
    "report.md",
    "simulated.png",
    "spec.toml",
    "teapot.v",
    "trace.gtkw",
    "trace.vcd",
    "worst.svg",
];
const SMALL: [&str; 4] = ["run", "teapot", "--size", "64x48"];

fn small<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&SMALL, more].concat()
}

#[test]
fn everything_is_written_into_the_folder_of_the_scenes_name() {
    let place = Place::new();
    let summary = place.succeeds(&SMALL);
    assert_eq!(place.names("out/teapot"), FILES);
    assert_eq!(place.names("out"), ["teapot"]);
    for file in FILES {
        assert!(summary.contains(&format!("  {file}\n")), "{summary}");
    }
    for picture in FILES.iter().filter(|name| name.ends_with(".png")) {
        let bytes = fs::read(place.path("out/teapot").join(picture)).unwrap();
        assert!(bytes.starts_with(b"\x89PNG"), "{picture}");
    }
    let (simulated, expected) = ("out/teapot/simulated.png", "out/teapot/expected.png");
    assert_eq!(fs::read(place.path(simulated)).unwrap(), fs::read(place.path(expected)).unwrap());
    assert!(
        fs::read_to_string(place.path("out/teapot/report.md")).unwrap().contains("(worst.svg)")
    );
}

#[test]
fn the_report_has_its_keys() {
    let place = Place::new();
    for method in ["lyon", "hybrid"] {
        let printed = place.succeeds(&small(&["--method", method, "--json", "-o", method]));
        assert_eq!(printed.as_bytes(), fs::read(place.path(method).join("report.json")).unwrap());
        let report = place.report(method);
        assert_eq!(report["method"], method);
        assert_eq!((&report["scene"], &report["engine"]), (&"teapot".into(), &"fast".into()));
        assert_eq!((&report["mismatches"], &report["agrees"]), (&0.into(), &true.into()));
        let number =
            |value: &Value| value.as_f64().unwrap_or_else(|| panic!("{value} in {printed}"));
        let (pixels, cycles, latency) =
            (number(&report["pixels"]), number(&report["cycles"]), number(&report["latency"]));
        assert_eq!(cycles, pixels + latency);
        // Text is read back to within a few units in the last place.
        assert!((number(&report["cycles_per_pixel"]) - cycles / pixels).abs() < 1e-12);
        assert!(number(&report["wall_seconds"]) >= number(&report["simulation_seconds"]));
        for part in ["total", "method", "quantisation"] {
            for figure in ["max_lsb", "rms_lsb", "mean_lsb", "psnr_db"] {
                number(&report["error"][part][figure]);
            }
        }
        assert!(
            number(&report["error"]["quantisation"]["max_lsb"]) <= number(&report["bound_lsb"])
        );
        for coordinate in ["x", "y", "cycle"] {
            number(&report["worst_pixel"][coordinate]);
        }
    }
}

#[test]
fn the_same_run_gives_the_same_bytes() {
    let place = Place::new();
    place.succeeds(&small(&["-o", "one"]));
    place.succeeds(&small(&["-o", "other"]));
    for file in FILES.iter().filter(|name| **name != "report.json") {
        let [one, other] =
            ["one", "other"].map(|folder| fs::read(place.path(folder).join(file)).unwrap());
        assert!(one == other, "{file} differs");
    }
    let timeless = |folder: &str| {
        let mut report = place.report(folder);
        let object = report.as_object_mut().unwrap();
        assert!(
            object.remove("wall_seconds").is_some()
                && object.remove("simulation_seconds").is_some()
        );
        report
    };
    assert_eq!(timeless("one"), timeless("other"));
}

#[test]
fn engines_give_the_same_files() {
    let place = Place::new();
    for engine in ["fast", "rust-hdl"] {
        place.succeeds(&small(&["--engine", engine, "--trace", "all", "-o", engine]));
    }
    for file in FILES.iter().filter(|name| !name.starts_with("report")) {
        let [one, other] =
            ["fast", "rust-hdl"].map(|folder| fs::read(place.path(folder).join(file)).unwrap());
        assert!(one == other, "{file} differs");
    }
}

/// The frame goes through the stream top, and comes out as the core alone shades it.
#[test]
fn a_stream_top_gives_the_same_picture() {
    let place = Place::new();
    place.succeeds(&small(&["-o", "core"]));
    let engines = ["fast", "rust-hdl", "icarus"];
    let installed = |engine: &&str| *engine != "icarus" || tools::is_installed("iverilog");
    for engine in engines.into_iter().filter(installed) {
        let summary = place.succeeds(&small(&[
            "--top", "axis", "--stalls", "7", "--engine", engine, "-o", engine,
        ]));
        for said in ["at random, by seed 7", "none lost, doubled or wrong"] {
            assert!(summary.contains(said), "{summary}");
        }
        let report = place.report(engine);
        let stream = &report["stream"];
        assert_eq!((&report["stalls"], &stream["fault"]), (&7.into(), &Value::Null));
        assert_eq!(stream["pixels"], report["pixels"]);
        assert!(stream["clocks"].as_u64() > report["pixels"].as_u64());
        for file in ["simulated.png", "trace.vcd"] {
            let read = |folder: &str| fs::read(place.path(folder).join(file)).unwrap();
            let same = if file == "trace.vcd" { "fast" } else { "core" };
            assert!(read(engine) == read(same), "{engine}: {file} differs");
        }
    }
}

#[test]
fn pauses_between_pixels_change_nothing_but_clocks() {
    let place = Place::new();
    place.succeeds(&small(&["-o", "plain"]));
    place.succeeds(&small(&["--stalls", "7", "-o", "paused"]));
    let [plain, paused] = ["plain", "paused"].map(|folder| place.report(folder));
    assert!(plain["stream"].is_null() && paused["stream"].is_null());
    assert_eq!((&plain["stalls"], &paused["stalls"]), (&Value::Null, &7.into()));
    assert!(paused["cycles"].as_u64() > plain["cycles"].as_u64());
    let picture = |folder: &str| fs::read(place.path(folder).join("simulated.png")).unwrap();
    assert_eq!(picture("plain"), picture("paused"));
    let refused = place.specula(&small(&["--stalls", "0"]));
    assert_eq!(refused.status, Some(2));
}

#[test]
fn no_bar_is_drawn_in_a_pipe() {
    let place = Place::new();
    let ended = place.specula(&SMALL);
    assert_eq!(ended.stderr, "");
    assert!(!ended.stdout.contains(['\r', '\u{1b}']), "{}", ended.stdout);
}

#[test]
fn the_window_is_the_one_asked_for() {
    let place = Place::new();
    let trace = |choice: &str| {
        place.succeeds(&small(&["--trace", choice]));
        place.report("out/teapot")["trace"].clone()
    };
    assert_eq!(trace("cycles=5..9"), serde_json::json!([5, 9]));
    let all = trace("all");
    let report = place.report("out/teapot");
    assert_eq!((&all[0], &all[1]), (&0.into(), &(report["cycles"].as_u64().unwrap() + 1).into()));
    assert_eq!(trace("span=0")[0], 0);
    let worst = trace("worst");
    let cycle = place.report("out/teapot")["worst_pixel"]["cycle"].as_u64().unwrap();
    assert!((worst[0].as_u64().unwrap()..worst[1].as_u64().unwrap()).contains(&cycle));
    assert_eq!(trace("none"), Value::Null);
    assert!(
        place
            .names("out/teapot")
            .iter()
            .all(|name| !name.starts_with("trace") && name != "worst.svg")
    );
}

#[test]
fn the_worst_pixels_way_is_drawn_however_long_the_waveform_is() {
    let place = Place::new();
    // Its core has so many signals that the usual window takes 12 MB.
    place.succeeds(&["run", "lamps", "--size", "160x120"]);
    assert!(fs::metadata(place.path("out/lamps/trace.vcd")).unwrap().len() > 8 << 20);
    let drawn = fs::read_to_string(place.path("out/lamps/worst.svg")).unwrap();
    let cycle = place.report("out/lamps")["worst_pixel"]["cycle"].to_string();
    assert!(drawn.contains(&format!(">{cycle}<")), "{drawn}");
    // A waveform of other clocks does not show it, and the same picture is there.
    let usual = |trace: &str| {
        place.succeeds(&small(&["--trace", trace]));
        fs::read(place.path("out/teapot/worst.svg")).unwrap()
    };
    let worst = usual("worst");
    assert!(worst == usual("cycles=5..9") && worst == usual("all"));
}

#[test]
fn the_time_counts_pictures() {
    let place = Place::new();
    let begin = std::time::Instant::now();
    let said = place.succeeds(&["run", "icosahedron", "--size", "1600x1200", "--trace", "none"]);
    let whole = begin.elapsed().as_secs_f64();
    let line = said.lines().find(|line| line.starts_with("time ")).expect("it is said");
    let told: f64 = line
        .split_whitespace()
        .nth(1)
        .and_then(|seconds| seconds.parse().ok())
        .expect("it is a number");
    // What is left is the program's start and end.
    assert!(told <= whole && told > 0.8 * whole, "{line}; {whole} s");
    let report = place.report("out/icosahedron");
    let [wall, simulation] = ["wall_seconds", "simulation_seconds"]
        .map(|key| report[key].as_f64().expect("it is a number"));
    assert!(
        simulation < wall && wall <= told + 0.001 && wall > 0.5 * whole,
        "{simulation} {wall} {told} {whole}"
    );
}

#[test]
fn a_waveform_may_be_compressed() {
    let place = Place::new();
    place.succeeds(&SMALL);
    place.succeeds(&small(&["--trace-format", "fst"]));
    // The other kind of an earlier run is gone.
    let names: Vec<String> = FILES.iter().map(|name| name.replace(".vcd", ".fst")).collect();
    let mut names: Vec<&str> = names.iter().map(String::as_str).collect();
    names.sort_unstable();
    assert_eq!(place.names("out/teapot"), names);
    let save_file = fs::read_to_string(place.path("out/teapot/trace.gtkw")).unwrap();
    assert!(save_file.contains("[dumpfile] \"trace.fst\""), "{save_file}");
    let report = fs::read_to_string(place.path("out/teapot/report.md")).unwrap();
    assert!(report.contains("gtkwave trace.fst trace.gtkw"), "{report}");
}

#[test]
fn meshes_and_scene_files_are_scenes_too() {
    let place = Place::new();
    place.write("Tri angle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    place.write(
        "scene.toml",
        "[[object]]\nmesh = \"Tri angle.obj\"\n[object.material]\nshininess = 8\n[core]\nmethod = \"hybrid\"\n",
    );
    place.succeeds(&["run", "Tri angle.obj", "--method", "lyon", "--size", "32x32"]);
    assert!(place.names("out/tri_angle").contains(&"tri_angle.v".to_owned()));
    place.succeeds(&["run", "./scene.toml", "--size", "32x32"]);
    assert_eq!(place.report("out/scene")["method"], "hybrid");
    assert_eq!(
        place.report("out/scene")["command"],
        "specula generate scene.toml --size 32x32 --method hybrid"
    );
}

#[test]
fn the_smallest_picture_has_a_heat_map_with_its_legend() {
    let place = Place::new();
    place.write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    place.succeeds(&["run", "square.obj", "--method", "lyon", "--size", "1x1"]);
    assert_eq!(place.report("out/square")["pixels"], 1);
}

#[cfg(unix)]
#[test]
fn a_reader_may_stop_reading() {
    use std::process::{Command, Stdio};
    let mut child = Command::new(env!("CARGO_BIN_EXE_specula"))
        .arg("scenes")
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let ended = child.wait_with_output().unwrap();
    assert_eq!((ended.status.code(), ended.stderr.as_slice()), (Some(0), &b""[..]));
}

#[test]
fn a_core_must_fit_its_device() {
    let place = Place::new();
    let refused = place.specula(&["run", "torus", "--size", "64x48", "--device", "ice40up5k"]);
    assert_eq!(refused.status, Some(2));
    for part in [
        "does not fit ice40up5k",
        "of 8 multiplier blocks",
        "usable logic cells",
        "specula explore",
        "no known device of `ice40up` has enough",
    ] {
        assert!(refused.stderr.contains(part), "{part}: {}", refused.stderr);
    }
    assert!(!place.path("out").exists());
    let said = place.succeeds(&["run", "torus", "--size", "64x48", "--device", "xc7a35t"]);
    assert!(said.contains("of 90 multiplier blocks"), "{said}");
    let report = place.report("out/torus");
    assert_eq!(report["device"]["name"], "xc7a35t");
    assert_eq!(report["spec"]["target"]["name"], "xilinx7");
    assert!(
        report["resources"]["blocks"].as_u64().is_some_and(|blocks| blocks > 8 && blocks <= 90),
        "{report}"
    );
    assert!(
        fs::read_to_string(place.path("out/torus/report.md"))
            .unwrap()
            .contains("| device | xc7a35t: ")
    );
    // The core that was made is asked too.
    let refused = place.specula(&[
        "generate",
        "--spec",
        "out/torus/spec.toml",
        "--device",
        "ice40up5k",
        "-o",
        "rtl",
    ]);
    assert!(refused.status == Some(2) && !place.path("rtl").exists(), "{}", refused.stderr);
}

#[test]
fn frames_per_second_are_said_at_a_clock() {
    let place = Place::new();
    let at = |clock: &str| {
        place.succeeds(&["run", "torus", "--size", "32x24", "--clock", clock]);
        place.report("out/torus")["frames_per_second"].as_f64().expect("a number")
    };
    let (slow, fast) = (at("50"), at("200"));
    assert!((fast / slow - 4.0).abs() < 1e-9, "{slow} {fast}");
    assert!(
        fs::read_to_string(place.path("out/torus/report.md"))
            .unwrap()
            .contains("at a given 200 MHz that is not proven")
    );
    assert!(
        place
            .succeeds(&["run", "torus", "--size", "32x24"])
            .contains("at an assumed 100 MHz that is not proven")
    );
}

#[test]
fn a_core_for_a_clock_says_so_and_is_counted_at_the_predicted_one() {
    let place = Place::new();
    let target = ["--method", "gouraud", "--target", "ecp5", "--clock", "150"];
    let said = place.succeeds(&[&["run", "torus", "--size", "32x24"], &target[..]].concat());
    let report = place.report("out/torus");
    let made_for = &report["made_for"];
    assert_eq!((&made_for["target"], &made_for["asked_mhz"]), (&"ecp5".into(), &150.0.into()));
    let predicted = made_for["predicted_mhz"].as_f64().expect("a number");
    assert!(predicted >= 150.0, "{predicted}");
    assert_eq!(report["clock_mhz"].as_f64(), Some(predicted));
    assert_eq!(report["spec"]["target"]["clock_mhz"], 150.0);
    let prediction = format!("at 150 MHz; its delays predict {predicted:.1} MHz");
    for file in ["report.md", "report.html", "torus.v"] {
        let text = fs::read_to_string(place.path("out/torus").join(file)).unwrap();
        assert!(text.contains(&prediction), "{file}");
    }
    assert!(said.contains(&prediction), "{said}");
    assert!(said.contains(&format!("at a predicted {predicted:.1} MHz")), "{said}");
    // The core made again has the same clock, unless one is given.
    let again = ["run", "torus", "--size", "32x24", "--core", "out/torus", "-o", "again"];
    place.succeeds(&again);
    assert_eq!(place.report("again")["clock_mhz"].as_f64(), Some(predicted));
    place.succeeds(&[&again[..], &["--clock", "20"]].concat());
    assert_eq!(place.report("again")["clock_mhz"], 20.0);
    let plain = place.succeeds(&["run", "torus", "--size", "32x24", "-o", "plain"]);
    assert!(!plain.contains("made for"), "{plain}");
    assert_eq!(place.report("plain")["made_for"], serde_json::Value::Null);
}
