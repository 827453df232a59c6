//! `specula wave`: values of any width and kind, and the last instant.
use std::fs;

use crate::program::Place;

const HEADER: &str = "$timescale 1ns $end\n$scope module top $end\n";

fn row<'a>(text: &'a str, name: &str) -> &'a str {
    let found = text.lines().find(|line| line.trim_start().split(' ').next() == Some(name));
    found.unwrap_or_else(|| panic!("{name} is drawn: {text}"))
}

/// A clock, a bus of 64 bits, another of 256, and a real number.
fn wide() -> Place {
    let place = Place::new();
    let variables = "$var wire 1 ! clk $end\n$var wire 64 \" bus [63:0] $end\n$var wire 256 # key [255:0] $end\n\
                     $var real 64 $ volts $end\n$upscope $end\n$enddefinitions $end\n";
    let clocks = (0..20u64).map(|clock| {
        let bus = 0x1d95_0c83_fb72_ea46u64.rotate_left(4 * clock as u32);
        let volts = 1.0 / (clock as f64 + 3.0);
        format!(
            "#{}\n0!\n#{}\n1!\nb{bus:b} \"\nb{bus:064b}{bus:0192b} #\nr{volts} $\n",
            10 * clock,
            10 * clock + 5
        )
    });
    place.write("wide.vcd", format!("{HEADER}{variables}{}", clocks.collect::<String>()));
    place
}

#[test]
fn columns_are_as_wide_as_a_short_window_leaves_room_for() {
    let place = wide();
    let one = place.succeeds(&["wave", "wide.vcd", "--from", "2", "--to", "2"]);
    assert!(row(&one, "bus").contains("\u{2502}950c83fb72ea461d "), "{one}");
    assert!(row(&one, "volts").contains("\u{2502}0.2 "), "{one}");
    let key = format!("950c83fb72ea461d{}950c83fb72ea461d", "0".repeat(32));
    assert!(row(&one, "key").ends_with(&format!("\u{2502}{key}\u{2502}")), "{one}");
    let few = place.succeeds(&[
        "wave",
        "wide.vcd",
        "--from",
        "3",
        "--to",
        "6",
        "--signals",
        "top.volts",
        "--signals",
        "top.bus",
    ]);
    assert!(
        row(&few, "bus").contains("\u{2502}50c83fb72ea461d9   \u{2502}0c83fb72ea461d95   \u{2502}"),
        "{few}"
    );
    assert!(row(&few, "volts").contains("\u{2502}0.16666666666666666"), "{few}");
}

#[test]
fn a_longer_window_shows_64_bits_all_the_same() {
    let text =
        wide().succeeds(&["wave", "wide.vcd", "--signals", "top.bus", "--signals", "top.clk"]);
    insta::assert_snapshot!("wide", text);
}

#[test]
fn lines_are_as_wide_as_is_asked_for() {
    let place = wide();
    for width in [60, 80, 200] {
        let text = place.succeeds(&[
            "wave",
            "wide.vcd",
            "--signals",
            "*bus",
            "--signals",
            "*clk",
            "--from",
            "0",
            "--to",
            "19",
            "--width",
            &width.to_string(),
        ]);
        let longest = text.lines().map(|line| line.chars().count()).max();
        assert!(
            longest.is_some_and(|longest| longest <= width && longest > width - 20),
            "{longest:?} of {width}: {text}"
        );
        assert!(text.contains("1d950c83fb72ea46"), "{text}");
    }
    assert_eq!(place.specula(&["wave", "wide.vcd", "--width", "3"]).status, Some(2));
}

#[test]
fn pictures_have_room_for_wide_values_too() {
    let place = wide();
    let size = |arguments: &[&str]| -> (u32, String) {
        place.succeeds(&[&["wave", "wide.vcd", "-o", "wide.svg"], arguments].concat());
        let svg = fs::read_to_string(place.path("wide.svg")).expect("it was written");
        let width = svg.split("width=\"").nth(1).and_then(|rest| rest.split('"').next());
        (width.and_then(|width| width.parse().ok()).expect("it has a width"), svg)
    };
    let (_, one) = size(&["--from", "2", "--to", "2"]);
    assert!(one.contains(">950c83fb72ea461d<"), "{one}");
    let (default, _) = size(&[]);
    let (asked, svg) = size(&["--width", "5000", "--from", "0", "--to", "19"]);
    assert!(default < 1800 && (4900..=5000).contains(&asked), "{default} {asked}");
    assert!(svg.contains(">950c83fb72ea461d<"), "{svg}");
}

#[test]
fn the_last_instant_is_drawn() {
    let place = Place::new();
    let variables =
        "$var wire 1 ! a $end\n$var wire 8 \" d [7:0] $end\n$upscope $end\n$enddefinitions $end\n";
    place.write("last.vcd", format!("{HEADER}{variables}#0\n0!\nb0 \"\n#10\n1!\nb10100101 \"\n"));
    place.write("one.vcd", format!("{HEADER}{variables}#0\n1!\nb10100101 \"\n"));
    place.write("none.vcd", format!("{HEADER}{variables}1!\nb10100101 \"\n"));
    place.write(
        "idle.vcd",
        format!("{HEADER}{variables}#0\n0!\nb0 \"\n#10\n1!\nb10100101 \"\n#20\n"),
    );
    place.write("long.vcd", format!("{HEADER}{variables}#0\n0!\nb0 \"\n#1000\n1!\nb10100101 \"\n"));
    let cases: [&[&str]; 8] = [
        &["last.vcd"],
        &["last.vcd", "--from", "10", "--to", "10"],
        &["last.vcd", "--from", "9"],
        &["one.vcd"],
        &["none.vcd"],
        &["idle.vcd", "--from", "18"],
        &["idle.vcd", "--from", "20", "--to", "20"],
        &["long.vcd"],
    ];
    let drawn = cases.map(|arguments| {
        format!(
            "$ specula wave {}\n{}\n",
            arguments.join(" "),
            place.succeeds(&[&["wave"], arguments].concat())
        )
    });
    insta::assert_snapshot!("last_instants", drawn.concat());
}

#[test]
fn a_clock_that_begins_with_the_last_instant_counts() {
    let place = Place::new();
    let variables = "$var wire 1 ! clk $end\n$var wire 8 \" d [7:0] $end\n$upscope $end\n$enddefinitions $end\n";
    let clocks =
        "#0\n0!\nb0 \"\n#5\n1!\nb1 \"\n#10\n0!\n#15\n1!\nb10 \"\n#20\n0!\n#25\n1!\nb11 \"\n";
    place.write("clocks.vcd", format!("{HEADER}{variables}{clocks}"));
    let text = place.succeeds(&["wave", "clocks.vcd"]);
    assert!(text.starts_with("clocks.vcd, clocks 0 to 2\n"), "{text}");
    assert!(row(&text, "d").ends_with("\u{2502}01  \u{2502}02  \u{2502}03  \u{2502}"), "{text}");
}

#[test]
fn values_of_enumerations_have_names() {
    let place = Place::new();
    place.write("enums.fst", include_bytes!("../../../wave/tests/data/wave/enums.fst"));
    // As `fst2vcd -e` writes the same.
    let attributes = "$attrbegin misc 07 enums.state_t 3 IDLE RUN DONE 00 01 10 1 $end\n";
    let variables =
        "$attrbegin misc 07 \"\" 1 $end\n$var logic 2 ! state [1:0] $end\n$var logic 1 \" a $end\n";
    let scopes = "$scope module TOP $end\n$scope module enums $end\n";
    let values = "#0\nb0 !\n0\"\n#5\nb1 !\n1\"\n#10\nb10 !\n#15\nb11 !\n#20\n";
    place.write(
        "enums.vcd",
        format!(
            "$timescale 1ps $end\n{attributes}{scopes}{variables}$enddefinitions $end\n{values}"
        ),
    );
    for name in ["enums.fst", "enums.vcd"] {
        let text = place.succeeds(&["wave", name]);
        let names = row(&text, "state").split('\u{2502}').map(str::trim).collect::<Vec<_>>();
        assert_eq!(names, ["state hex", "IDLE", "RUN", "DONE", "3", ""], "{text}");
    }
}

#[test]
fn events_are_marks_and_text_is_text() {
    let place = Place::new();
    let variables = "$var event 1 ! tick $end\n$var string 1 \" state $end\n$var wire 1 # bit $end\n$upscope $end\n$enddefinitions $end\n";
    let values = "#0\n$dumpvars\n1!\nsA_LONG_STATE_OF_THE_MACHINE \"\n0#\n$end\n#5\n1!\nsRUN \"\n#8\n1!\nU#\n#9\n1!\nH#\n#10\n";
    place.write("events.vcd", format!("{HEADER}{variables}{values}"));
    insta::assert_snapshot!("events", place.succeeds(&["wave", "events.vcd", "--width", "50"]));
    place.succeeds(&["wave", "events.vcd", "-o", "events.svg"]);
    insta::assert_snapshot!(
        "events_svg",
        fs::read_to_string(place.path("events.svg")).expect("it was written")
    );
    place.succeeds(&["wave", "events.vcd", "-o", "events.png"]);
}
