//! Tests of what a run leaves when the core disagrees with its models, which should never happen
//! with a scene.
use std::fs;
use std::path::Path;

use clap::Parser;
use serde_json::Value;
use specula_datapath::design::Range;
use specula_spec::Format;
use specula_testbench::{Mismatch, Violation};
use tempfile::TempDir;

use super::*;
use crate::cli::{Cli, Command};
use crate::html;
use crate::output::MARKDOWN;

fn arguments(words: &[&str]) -> Arguments {
    let cli = Cli::try_parse_from(
        [&["specula", "run", "icosahedron", "--size", "48x36"], words].concat(),
    )
    .expect("the words are right");
    match cli.command {
        Command::Run(arguments) => arguments,
        other => panic!("{other:?}"),
    }
}

/// Runs the scene, corrupts the outcome, and writes the files into `folder`. The result is the
/// clock of the corruption and the verdict.
fn spoilt_run(
    words: &[&str],
    folder: &Path,
    spoil: impl FnOnce(&mut Outcome) -> u64,
) -> (u64, Verdict) {
    let arguments = arguments(words);
    let job = arguments.job().expect("the scene is built in");
    let bench =
        Bench::new(&job.scene.frame, job.spec(), &job.module()).expect("the core can be built");
    let mut outcome = simulate(&bench, arguments.engine).expect("the engine works");
    assert!(outcome.agrees());
    let clock = spoil(&mut outcome);
    let run =
        run_of(&arguments, &job, &bench, None, (&outcome, None)).expect("frames can be drawn");
    let destination =
        Destination::check(folder, &artifacts::names(&run.module, 0), &Interrupts::default())
            .expect("the folder can be written");
    let staging = destination.stage().expect("the folder can be written");
    write(&arguments, Instant::now(), (&destination, staging), &run).expect("files can be written");
    (clock, verdict(run.disagreement.as_ref()))
}

fn report(folder: &Path) -> Value {
    serde_json::from_slice(&fs::read(folder.join(REPORT)).expect("there is a report"))
        .expect("it is JSON")
}

/// Corrupts the first pixel of the frame's last span but one; it leaves before all pixels of the
/// last two spans.
fn spoil_a_pixel(outcome: &mut Outcome) -> u64 {
    let c = &mut outcome.comparison;
    c.mismatches = 2;
    c.first_mismatch =
        Some(Mismatch { x: 3, y: 4, span: 0, pixel: 0, simulated: [1, 2, 3], expected: [1, 2, 4] });
    // The very first pixel leaves after the latency.
    outcome.cycles - outcome.pixels
}

#[test]
fn a_wrong_pixel_is_named_and_shown() {
    let place = TempDir::new().expect("there is room");
    let folder = place.path().join("run");
    let (clock, verdict) = spoilt_run(&[], &folder, spoil_a_pixel);
    assert_eq!(verdict, Verdict::Disagrees);
    let report = report(&folder);
    assert_eq!(report["agrees"], false);
    assert_eq!(report["mismatches"], 2);
    let first = &report["first_mismatch"];
    assert_eq!((&first["x"], &first["y"], &first["cycle"]), (&3.into(), &4.into(), &clock.into()));
    let first = clock.saturating_sub(100);
    assert_eq!(report["trace"], serde_json::json!([first, first + 200]));
    let text = fs::read_to_string(folder.join(MARKDOWN)).expect("there is a report");
    let said = format!(
        "2 pixels differ, first (3, 4) in cycle {clock}: simulated (1, 2, 3), expected (1, 2, 4)"
    );
    assert!(text.contains(&said), "{text}");
    let save_file =
        fs::read_to_string(folder.join(waveform::SAVE_FILE)).expect("there is a save file");
    assert!(save_file.contains(&format!(" {} -1", clock * 10)), "{save_file}");
}

#[test]
fn a_waveform_is_left_though_none_was_asked_for() {
    let place = TempDir::new().expect("there is room");
    spoilt_run(&["--trace", "none"], &place.path().join("run"), spoil_a_pixel);
    assert!(place.path().join("run").join(TraceFormat::Vcd.file_name()).exists());
}

/// The core gives a pixel another colour than the stream has to show.
#[test]
fn a_wrong_stream_is_named() {
    let arguments = arguments(&["--top", "axis", "--stalls", "3", "--trace", "none"]);
    let job = arguments.job().expect("the scene is built in");
    let bench =
        Bench::new(&job.scene.frame, job.spec(), &job.module()).expect("the core can be built");
    let (bench, streamed) = arguments.entering(&job, bench).expect("the stream comes to an end");
    let mut outcome = simulate(&bench, arguments.engine).expect("the engine works");
    outcome.codes[5][0] ^= 1;
    let streamed = streamed.expect("the stream top is asked for");
    let stream =
        streamed.outcome(&job, &bench, &outcome, arguments.engine).expect("it is compared");
    let fault = stream.fault.clone().expect("a pixel differs");
    assert!(fault.in_words.starts_with("pixel 5 of the stream is "), "{fault:?}");
    let run = run_of(&arguments, &job, &bench, None, (&outcome, Some(stream)))
        .expect("frames can be drawn");
    assert_eq!(run.clock_to_look_at(), fault.cycle);
    let disagreement = run.disagreement.as_ref().expect("it disagrees");
    assert_eq!(disagreement.lines(), [fault.in_words]);
    assert!(!disagreement.is_bound_only());
}

#[test]
fn clocks_that_were_asked_for_are_shown_all_the_same() {
    let place = TempDir::new().expect("there is room");
    spoilt_run(&["--trace", "cycles=7..11"], &place.path().join("run"), spoil_a_pixel);
    assert_eq!(report(&place.path().join("run"))["trace"], serde_json::json!([7, 11]));
}

#[test]
fn wrong_clocks_and_facts_count_too() {
    let place = TempDir::new().expect("there is room");
    let folder = place.path().join("run");
    let (clock, verdict) = spoilt_run(&[], &folder, |outcome| {
        outcome.wrong_clocks = vec![300, 301];
        let (fact, signal) = ("|N| <= 1".to_owned(), "core.n".to_owned());
        let (format, raw) = (Format::signed(1, 56), (1 << 56) + 7);
        outcome.violation = Some(Violation {
            fact,
            signal,
            clock: 250,
            raw,
            limits: Range::new(0, 1 << 56),
            format,
        });
        250
    });
    assert_eq!(verdict, Verdict::Disagrees);
    let report = report(&folder);
    assert_eq!(report["wrong_clocks"], 2);
    assert_eq!(report["violation"]["cycle"], clock);
    let said = "`|N| <= 1` does not hold: signal core.n is 1.00000000000000009714451465470119728706777095794677734375 in cycle 250, \
                and must lie from 0 to 1";
    assert_eq!(report["violation"]["in_words"], said);
    let text = fs::read_to_string(folder.join(MARKDOWN)).expect("there is a report");
    assert!(text.contains(said), "{text}");
    assert_eq!(report["trace"], serde_json::json!([150, 350]));
}

/// An error above its bound ends a run as a wrong pixel does: the pixel, both numbers and their
/// meaning are reported, and the waveform shows the surroundings.
#[test]
fn an_error_above_its_bound_is_named_and_shown() {
    let place = TempDir::new().expect("there is room");
    let folder = place.path().join("run");
    let mut lines = String::new();
    let (_, verdict) = spoilt_run(&["--trace", "none"], &folder, |outcome| {
        outcome.bound_lsb = 0.25;
        outcome.comparison.beyond_bound = 9;
        let worst = outcome.beyond_bound().expect("rounding alone is half an LSB");
        lines = format!(
            "9 pixels have a quantisation error above the proven bound of 0.250 LSB, the largest {:.3} LSB: {} of ({}, {}) is {} in cycle",
            worst.error_lsb,
            ["red", "green", "blue"][worst.channel],
            worst.x,
            worst.y,
            worst.simulated
        );
        0
    });
    assert_eq!(verdict, Verdict::Disagrees);
    let report = report(&folder);
    assert_eq!((&report["agrees"], &report["mismatches"]), (&false.into(), &0.into()));
    let broken = &report["beyond_bound"];
    assert_eq!((&broken["pixels"], &broken["bound_lsb"]), (&9.into(), &0.25.into()));
    assert!(broken["error_lsb"].as_f64() > Some(0.25) && broken["simulated"] == broken["expected"]);
    let cycle = broken["cycle"].as_u64().expect("it leaves in a clock");
    let window = [report["trace"][0].as_u64(), report["trace"][1].as_u64()]
        .map(|clock| clock.expect("a waveform is left"));
    assert!(window[0] <= cycle && cycle < window[1]);
    let text = fs::read_to_string(folder.join(MARKDOWN)).expect("there is a report");
    let page = fs::read_to_string(folder.join(html::FILE)).expect("there is a page");
    for text in [&text, &page] {
        assert!(text.contains("The quantisation error is above its proven bound."), "{text}");
        assert!(text.contains(&lines), "{lines} is not in {text}");
        assert!(text.contains("the set-up of spans or the bound is wrong"));
    }
}

/// Facts are shown with their limits and with the values seen, which lie within the limits and
/// differ from them.
#[test]
fn facts_have_limits_and_what_was_seen() {
    let place = TempDir::new().expect("there is room");
    let folder = place.path().join("run");
    spoilt_run(&["--method", "lyon"], &folder, |_| 0);
    let facts = report(&folder)["facts"].as_array().expect("lyon rests on facts").clone();
    let ends =
        |range: &Value| [&range[0], &range[1]].map(|end| end.as_f64().expect("it is a number"));
    let mut narrower = 0;
    for fact in &facts {
        let (limits, seen) = (ends(&fact["limits"]), ends(&fact["seen"]));
        assert!(limits[0] <= seen[0] && seen[0] <= seen[1] && seen[1] <= limits[1], "{fact}");
        narrower += usize::from(seen != limits);
    }
    assert!(narrower > 0, "{facts:?}");
    let weight =
        facts.iter().find(|fact| fact["fact"] == "0 <= a <= 1").expect("weights are interpolated");
    assert_eq!(weight["seen"][0], 0.0);
    let text = fs::read_to_string(folder.join(MARKDOWN)).expect("there is a report");
    assert!(text.contains("| fact | signal | must lie in | seen |"), "{text}");
}
