//! `specula wave` on VCD files as simulators write them, beside IEEE 1364 or against it.
use crate::program::Place;

/// All dialects in one file; Latin-1 in a comment.
const DIALECTS: &[u8] = include_bytes!("../../../wave/tests/data/wave/dialects.vcd");

const HEADER: &str = "\
$timescale 1ns $end
$scope module top $end
$var wire 1 ! a $end
$var wire 8 \" d [7:0] $end
$upscope $end
$enddefinitions $end
";
const VALUES: &str = "#0\n0!\nb0 \"\n#10\n1!\n#20\n";

/// What is drawn of a file and the warnings before.
fn drawn(bytes: impl AsRef<[u8]>) -> String {
    let place = Place::new();
    place.write("x.vcd", bytes);
    let ended = place.specula(&["wave", "x.vcd", "--signals", "*", "--width", "120"]);
    assert_eq!(ended.status, Some(0), "{}", ended.stderr);
    format!("{}{}", ended.stderr, ended.stdout)
}

/// The one warning of a file that is drawn as the others here are.
fn warning(bytes: impl AsRef<[u8]>) -> String {
    let drawn = drawn(bytes);
    let (warnings, drawing): (Vec<&str>, Vec<&str>) =
        drawn.lines().partition(|line| line.starts_with("warning: "));
    let steps = drawing.iter().find(|line| line.starts_with("  a "));
    let steps = steps.unwrap_or_else(|| panic!("a is drawn: {drawn}"));
    assert!(steps.contains("__\u{2594}\u{2594}"), "{drawn}");
    warnings.join("\n").replace("warning: `x.vcd`: ", "")
}

#[test]
fn every_dialect_is_drawn() {
    insta::assert_snapshot!("dialects", drawn(DIALECTS));
}

#[test]
fn what_is_passed_over_is_told_with_its_line() {
    let whole = format!("{HEADER}{VALUES}");
    let with = |from: &str, to: &str| {
        assert!(whole.contains(from), "{from}");
        whole.replacen(from, to, 1)
    };
    let cases = [
        ("nothing odd", whole.clone()),
        (
            "upscopes that end nothing",
            with("$upscope $end\n", "$upscope $end\n$upscope $end\n$upscope $end\n"),
        ),
        ("missing upscopes", with("$upscope $end\n", "")),
        ("undeclared identifier", with("1!\n", "1!\n1%\nb101 %\nr1.5 %\nsTEXT %\n")),
        ("scope without a type", with("module top", "dump")),
        ("unknown type of a scope", with("module top", "room top")),
        ("scope without a name", with("$scope module top", "$scope")),
        ("wire of SystemVerilog", with("wire 1", "uwire 1")),
        ("unknown type of a variable", with("wire 1", "nettype 1")),
        ("variable without a type", with("wire 1 !", "1 !")),
        ("variable without a name", with("$upscope", "$var wire 1 # $end\n$upscope")),
        ("size that is none", with("wire 8", "wire many")),
        ("variable that is too wide", with("$upscope", "$var wire 4000000000 # w $end\n$upscope")),
        ("values that are too long", with("b0 \"", "b010101010101 \"")),
        ("values without bits", with("b0 \"", "b \"")),
        ("bits behind a blank", with("b0 \"", "b  101 \"")),
        ("values behind tabs", with("b0 \"", "b0\t\t\"")),
        ("a scalar and a blank", with("0!", "0 !")),
        ("a value without an identifier", with("b0 \"", "b101")),
        ("states in capitals", with("b0 \"", "BXZ01 \"")),
        ("states that are none", with("b0 \"", "b01q2 \"")),
        ("no definitions' end", with("$enddefinitions $end\n", "$dumpvars\n$end\n")),
        ("times with fractions", with("#10", "#10.5")),
        ("times before 0", with("#0", "#-5")),
        ("times that go back", with("#20", "#5\nb11 \"\n#20")),
        ("times that are none", with("#20", "#ten\n#20")),
        ("times behind a blank", with("#10", "# 10")),
        ("times without values", with("#10", "#3\n#4\n#5\n#10")),
        ("a comment anywhere", with("#10", "$comment #7 1! $end\n#10 $comment b1 $end")),
        ("an unknown section", with("#10", "$mystery what is this $end\n#10")),
        ("an unknown section without an end", with("#10", "$mystery what is this\n#10")),
        ("a section without an end", with("$scope", "$version Simulator 1.0\n$scope")),
        (
            "dumping switched off and on",
            with("#10", "#5\n$dumpoff\nx!\nbx \"\n$end\n#6\n$dumpon\n0!\nb0 \"\n$end\n#10"),
        ),
        ("a checkpoint", with("#10", "#5\n$dumpall\n0!\nb0 \"\n$end\n#10")),
        ("no unit of time", with("$timescale 1ns $end\n", "")),
        ("a unit of time that is none", with("1ns", "3 hours")),
        ("a unit of time without a blank behind it", with("1ns $end", "1 ns$end")),
        (
            "sections without a blank before their end",
            whole.replace("top $end", "top$end").replace("scope $end", "scope$end"),
        ),
        ("a time zero", with("$scope", "$timezero 100 $end\n$scope")),
        (
            "values on the line of the definitions' end",
            with("$enddefinitions $end\n", "$enddefinitions $end "),
        ),
        ("lines that end as under DOS", whole.replace('\n', "\r\n")),
        ("lines that end as on a Macintosh", whole.replace('\n', "\r")),
        ("a byte order mark", format!("\u{feff}{whole}")),
        ("long identifiers", whole.replace('!', "!long~{id}")),
        ("an identifier that is a keyword's sign", whole.replace('!', "#")),
        ("a mark of GTKWave's", with("$var", "$attrbegin misc 02 st 1024 $end\n$var")),
        ("a word that is none", with("#10", "hello\n?\n#10")),
        ("a port of an extended dump", with("b0 \"", "pDDDDUUUD 00000000 66666666 \"")),
        ("a last line without an end", whole.trim_end().to_owned()),
        ("a section cut off", format!("{whole}$comment and then")),
        (
            "variables behind values",
            format!("{whole}$scope module more $end $var wire 1 ~ b $end $upscope $end\n1~\n"),
        ),
        ("empty scopes", with("$upscope", "$scope module none $end $upscope $end\n$upscope")),
    ];
    let told = cases.map(|(name, text)| format!("{name}: {}", warning(text)));
    insta::assert_snapshot!("warnings", told.join("\n"));
}

#[test]
fn times_that_are_too_large_are_the_last() {
    let drawn = drawn(format!("{HEADER}#0\n0!\nb0 \"\n#99999999999999999999\n1!\n"));
    assert!(
        drawn
            .starts_with("warning: `x.vcd`: line 10: the time `99999999999999999999` is too large"),
        "{drawn}"
    );
    assert!(drawn.contains("x.vcd, 0 to 18446744073709551614, in ns"), "{drawn}");
}

#[test]
fn vectors_are_extended_and_cut_as_the_standard_says() {
    let shown = |bits: &str| {
        let text = drawn(format!("{HEADER}#0\n0!\nb{bits} \"\n#1\n1!\n#2\n"));
        let row =
            text.lines().find(|line| line.starts_with("  d ")).expect("it is drawn").to_owned();
        row.split('\u{2502}').nth(1).expect("it has a value").trim().to_owned()
    };
    let cases = [
        ("1", "01"),
        ("010101010101", "55"),
        ("x", "x"),
        ("z", "z"),
        ("x0", "xX"),
        ("Z1010", "za"),
        ("uuuu0000", "u0"),
        ("-", "-"),
    ];
    for (bits, expected) in cases {
        assert_eq!(shown(bits), expected, "{bits}");
    }
}

#[test]
fn a_file_is_drawn_up_to_where_it_is_cut_off() {
    let text = format!("{HEADER}#0\n0!\nb0 \"\n#10\n1!\nb1010");
    let drawn = drawn(&text);
    assert!(
        drawn.starts_with("warning: `x.vcd`: line 12: the value `b1010` has no identifier"),
        "{drawn}"
    );
    assert!(
        drawn.contains("line 12: the file ends within a line: `b1010` may be cut off"),
        "{drawn}"
    );
    assert!(
        drawn.contains("  a     __________________________________________________\u{2594}"),
        "{drawn}"
    );
}

#[test]
fn states_of_myhdl_are_drawn_as_text() {
    let text =
        HEADER.replace("wire 1 !", "real 1 !") + "#0\nsIDLE !\nb0 \"\n#10\nsRUN !\nb1 \"\n#20\n";
    insta::assert_snapshot!("myhdl", drawn(text));
}

#[test]
fn signals_are_found_by_the_names_that_the_file_has() {
    let place = Place::new();
    let header = "$scope module top $end\n$var wire 4 ! m[0] [3:0] $end\n$var wire 4 \" m[1] [3:0] $end\n\
                  $var wire 8 # d\t[7:0] $end\n$var wire 1 $ \\esc.a[0] $end\n$var wire 4 % v [7:4] $end\n\
                  $var wire 4 & v [3:0] $end\n$var wire 1 ' bit [2] $end\n$scope module u.v $end\n\
                  $var wire 1 ( in.ner $end\n$upscope $end\n$upscope $end\n$enddefinitions $end\n";
    place.write(
        "names.vcd",
        format!("{header}#0\nb1 !\nb10 \"\nb11 #\n1$\nb100 %\nb101 &\n0'\n1(\n#10\n"),
    );
    let rows = |pattern: &str| -> String {
        let text = place.succeeds(&["wave", "names.vcd", "--signals", pattern]);
        let rows = text
            .lines()
            .filter(|line| line.starts_with("  "))
            .map(|line| line.split(" hex").next().unwrap_or(line));
        rows.map(|row| row.split_whitespace().next().unwrap_or_default())
            .collect::<Vec<_>>()
            .join(" ")
    };
    let cases = [
        ("top.m[0]", "m[0]"),
        ("top.m[0][3:0]", "m[0]"),
        ("top.m[0] [3:0]", "m[0]"),
        ("top.m*", "m[0] m[1]"),
        ("top.d", "d"),
        ("top.d[7:0]", "d"),
        ("top.\\esc.a[0]", "\\esc.a[0]"),
        ("top.esc.a[0]", "\\esc.a[0]"),
        ("top.v[7:4]", "v[7:4]"),
        ("top.v*", "v[7:4] v[3:0]"),
        ("top.bit[2]", "bit[2]"),
        ("top.u.v.in.ner", "in.ner"),
    ];
    for (pattern, expected) in cases {
        assert_eq!(rows(pattern), expected, "{pattern}");
    }
    let unit = place.succeeds(&["wave", "names.vcd", "--unit", "top.u.v"]);
    assert!(unit.contains("in.ner") && !unit.contains("m[0]"), "{unit}");
    for (asked, meant) in
        [("top.esc.a[1]", "top.\\esc.a[0]"), ("top.m[2]", "top.m[0]"), ("D", "top.d")]
    {
        let ended = place.specula(&["wave", "names.vcd", "--signals", asked]);
        let said = ended.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            ended.status == Some(2) && said.contains(&format!("did you mean `{meant}`?")),
            "{asked}: {said}"
        );
    }
}

#[test]
fn no_words_of_a_library_are_on_standard_output() {
    let place = Place::new();
    place.write("back.vcd", format!("{HEADER}#0\n0!\nb0 \"\n#20\n1!\n#10\n0!\nb11 \"\n#30\n"));
    let ended = place.specula(&["wave", "back.vcd"]);
    assert_eq!(ended.status, Some(0));
    assert!(ended.stdout.starts_with("back.vcd, 0 to 30, in ns\n"), "{}", ended.stdout);
    let told =
        "warning: `back.vcd`: line 12: time goes back from 20 to 10: what follows is drawn at 20\n";
    assert_eq!(ended.stderr, told);
}
