//! `specula wave`.
use std::fs;

use crate::program::Place;

/// Icarus wrote these two; data/wave/counter.v says how.
const VCD: &[u8] = include_bytes!("../../../wave/tests/data/wave/counter.vcd");
const FST: &[u8] = include_bytes!("../../../wave/tests/data/wave/counter.fst");

/// A save file as GTKWave and Specula write them.
const SAVE_FILE: &str = "\
*-15.0 65000 -1 -1
@800200
-shown
@28
bench.reset
@24
bench.dut.count[3:0]
@40000420
[fpshift_count] 6
bench.dut.wave[7:0]
@1000200
-shown
@c00200
-hidden
@28
bench.enable
@1000200
-hidden
";

/// Signals without a clock, as an analogue tool or a protocol analyser gives them.
const TIMES: &str = "\
$timescale 10 us $end
$scope module bus $end
$var wire 1 ! request $end
$var wire 12 \" address [11:0] $end
$var real 64 # volts $end
$upscope $end
$enddefinitions $end
#0
0!
bx \"
r0.5 #
#7
1!
b101010111100 \"
#23
z!
r-1.25 #
#24
b1 \"
#40
";

fn place() -> Place {
    let place = Place::new();
    place.write("counter.vcd", VCD);
    place.write("counter.fst", FST);
    place
}

#[test]
fn a_foreign_dump_is_drawn_as_text() {
    let place = place();
    let vcd = place.succeeds(&["wave", "counter.vcd"]);
    insta::assert_snapshot!("text_of_a_foreign_dump", vcd);
    assert_eq!(
        sorted(&place.succeeds(&["wave", "counter.fst"])),
        sorted(&vcd.replace("vcd", "fst"))
    );
}

/// The lines of a drawing, in the same order for tools that order signals differently.
fn sorted(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    lines.sort();
    lines
}

#[test]
fn formats_order_and_marker_are_those_of_the_save_file() {
    let place = place();
    place.write("counter.gtkw", SAVE_FILE);
    insta::assert_snapshot!("text_with_a_save_file", place.succeeds(&["wave", "counter.vcd"]));
    let hidden = place.succeeds(&["wave", "counter.vcd", "--unit", "bench", "--to", "3"]);
    assert!(hidden.contains("enable") && hidden.contains("S1.6"), "{hidden}");
}

#[test]
fn signals_are_chosen_by_pattern_and_unit() {
    let place = place();
    let names = |arguments: &[&str]| -> Vec<String> {
        let text = place.succeeds(&[&["wave", "counter.vcd"], arguments].concat());
        let rows = text.lines().filter(|line| line.starts_with("  "));
        rows.map(|line| line.split_whitespace().next().unwrap_or_default().to_owned()).collect()
    };
    assert_eq!(names(&["--signals", "bench.*e"]), ["wave", "enable", "enable", "wave"]);
    assert_eq!(
        names(&["--signals", "*.full", "--signals", "bench.c????"]),
        ["count", "clock", "full"]
    );
    assert_eq!(names(&["--unit", "dut"]), ["clock", "enable", "reset", "full", "count", "wave"]);
    assert_eq!(names(&["--unit", "dut", "--signals", "*count"]), ["count"]);
}

#[test]
fn long_windows_are_drawn_in_panels() {
    let text = place().succeeds(&[
        "wave",
        "counter.vcd",
        "--signals",
        "bench.dut.*",
        "--from",
        "0",
        "--to",
        "1000",
    ]);
    assert!(text.contains("clocks 0 to 15"), "{text}");
    let place = Place::new();
    place.succeeds(&["run", "icosahedron", "--size", "16x12", "-o", "run"]);
    let text = place.succeeds(&[
        "wave",
        "run/trace.vcd",
        "--unit",
        "normalise",
        "--from",
        "10",
        "--to",
        "40",
    ]);
    assert!(text.lines().filter(|line| line.starts_with("clocks ")).count() > 1, "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
}

#[test]
fn time_is_in_the_files_units_without_a_clock() {
    let place = Place::new();
    place.write("bus.vcd", TIMES);
    insta::assert_snapshot!("text_without_a_clock", place.succeeds(&["wave", "bus.vcd"]));
}

#[test]
fn our_own_waveform_is_read_as_numbers() {
    let place = Place::new();
    place.succeeds(&["run", "icosahedron", "--size", "16x12", "-o", "run"]);
    let cycle = place.report("run")["worst_pixel"]["cycle"].as_u64().unwrap();
    let text = place.succeeds(&["wave", "run/trace.vcd"]);
    assert!(text.contains(&format!("\u{25bc}{cycle}")), "{text}");
    let red = text.lines().find(|line| line.contains(" red ")).unwrap();
    assert!(red.contains("U8.0") && red.contains('\u{2502}'), "{red}");
    assert!(!text.contains(" hex "), "{text}");
}

#[test]
fn a_picture_is_svg_or_png() {
    let place = place();
    let chosen = ["wave", "counter.vcd", "--signals", "bench.*t", "--from", "0", "--to", "3", "-o"];
    let said = place.succeeds(&[&chosen[..], &["counter.svg"]].concat());
    assert_eq!(said, "counter.svg: counter.vcd, clocks 0 to 3, 4 signals\n");
    insta::assert_snapshot!("svg", fs::read_to_string(place.path("counter.svg")).unwrap());
    place.succeeds(&[&chosen[..], &["new/counter.PNG"]].concat());
    let png = image::load_from_memory(&fs::read(place.path("new/counter.PNG")).unwrap()).unwrap();
    let svg = fs::read_to_string(place.path("counter.svg")).unwrap();
    let size = format!("width=\"{}\" height=\"{}\"", png.width() / 2, png.height() / 2);
    assert!(svg.contains(&size), "{size}");
    assert_eq!(place.names("."), ["counter.fst", "counter.svg", "counter.vcd", "new"]);
    assert_eq!(place.names("new"), ["counter.PNG"]);
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let place = place();
    fs::create_dir(place.path("folder")).unwrap();
    fs::create_dir(place.path("folder.svg")).unwrap();
    place.write("empty.vcd", "");
    place.write(
        "noise.vcd",
        (0..4096u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect::<Vec<_>>(),
    );
    place.write("words.vcd", "clock = 1\n");
    place.write("header.vcd", &VCD[..200]);
    place.write("still.vcd", &VCD[..VCD.windows(3).position(|three| three == b"#0\n").unwrap()]);
    place.write("bare.vcd", "$timescale 1 ns $end\n$enddefinitions $end\n#0\n#10\n");
    place.write("half.fst", &FST[..FST.len() / 2]);
    place.write("wide.vcd", "$var wire 4000000000 ! w $end\n$enddefinitions $end\n#0\nb1 !\n#1\n");
    place.write(
        "long.vcd",
        "$var wire 1 ! clock $end\n$enddefinitions $end\n#0\n1!\n#1\n0!\n#2\n1!\n#99999999999\n",
    );
    let before = place.names(".");
    let wrong: &[&[&str]] = &[
        &["missing.vcd"],
        &["folder"],
        &["empty.vcd"],
        &["noise.vcd"],
        &["words.vcd"],
        &["header.vcd"],
        &["still.vcd"],
        &["bare.vcd"],
        &["half.fst"],
        &["wide.vcd"],
        &["long.vcd", "--from", "0", "--to", "99999999999"],
        &["counter.vcd", "--signals", "teapot.*"],
        &["counter.vcd", "--unit", "normalise"],
        &["counter.vcd", "--unit", "dut", "--signals", "bench.clock"],
        &["counter.vcd", "--from", "16"],
        &["counter.vcd", "--from", "5", "--to", "4"],
        &["counter.vcd", "--from", "-1"],
        &["counter.vcd", "--from", "18446744073709551615"],
        &["counter.vcd", "-o", "counter.gif"],
        &["counter.vcd", "-o", "counter"],
        &["counter.vcd", "-o", "empty.vcd/counter.svg"],
        &["counter.vcd", "-o", "folder.svg"],
    ];
    let refused = |arguments: &&[&str]| {
        let ended = place.specula(&[&["wave"], *arguments].concat());
        assert_eq!(
            (ended.status, ended.stdout.as_str()),
            (Some(2), ""),
            "{arguments:?}: {}",
            ended.stderr
        );
        format!("$ specula wave {}\n{}\n", arguments.join(" "), ended.stderr)
    };
    insta::assert_snapshot!("refusals", wrong.iter().map(refused).collect::<String>());
    assert_eq!(place.names("."), before);
}
