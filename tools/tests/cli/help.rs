//! Help texts and lists.
use crate::program::Place;

#[test]
fn every_command_has_help() {
    let place = Place::new();
    for command in [
        "run",
        "generate",
        "needs",
        "explore",
        "bench",
        "compare",
        "wave",
        "stress",
        "synth",
        "schedule",
        "prove",
        "reproduce",
        "new",
        "scenes",
        "methods",
        "completions",
        "manual",
    ] {
        let text = place.succeeds(&[command, "--help"]);
        let has_example = ["Example: specula", "Examples:\n  specula"].map(|of| text.contains(of));
        assert!(has_example.contains(&true), "{text}");
        insta::assert_snapshot!(format!("help_of_{command}"), text);
    }
    let text = place.succeeds(&["reproduce", "figure9", "--help"]);
    insta::assert_snapshot!("help_of_reproduce_figure9", text);
    insta::assert_snapshot!("help", place.succeeds(&["--help"]));
}

#[test]
fn lists_have_a_line_each() {
    let place = Place::new();
    insta::assert_snapshot!("scenes", place.succeeds(&["scenes"]));
    insta::assert_snapshot!("methods", place.succeeds(&["methods"]));
}

#[test]
fn without_a_command_the_help_is_shown() {
    let ended = Place::new().specula::<&str>(&[]);
    assert_eq!(ended.status, Some(2));
    assert!(ended.stderr.contains("Usage: specula <COMMAND>"), "{}", ended.stderr);
}
