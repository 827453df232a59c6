//! `specula reproduce figure9`.
use std::fs;

use serde_json::{Value, json};
use specula_experiments::figure9::{Balls, exact};

use crate::program::Place;

const SMALL: [&str; 4] = ["reproduce", "figure9", "--size", "97x33"];

#[test]
fn every_row_agrees_and_is_its_formula() {
    let place = Place::new();
    let printed = place.succeeds(&SMALL);
    let report = place.report("out/figure9");
    assert_eq!((&report["radius"], &report["agrees"]), (&json!(16), &json!(true)));
    let rows = report["rows"].as_array().expect("rows are a list");
    assert_eq!(rows.len(), 12);
    for row in rows {
        let number = |value: &Value| value.as_f64().expect("a number");
        let title = row["title"].as_str().expect("a title");
        assert!(printed.contains(title), "{title} is not printed");
        assert_eq!(row["mismatches"], 0, "{title}");
        let (error, bound) = (number(&row["error"]["max_lsb"]), number(&row["bound_lsb"]));
        assert!(error <= bound && error < 1.5, "{title}: off by {error} LSB, bound {bound}");
    }
    let files: Vec<&str> =
        report["files"].as_array().expect("files").iter().filter_map(Value::as_str).collect();
    let mut names = files.clone();
    names.sort_unstable();
    assert_eq!(place.names("out/figure9"), names);
    assert!(files.contains(&"figure9.png") && files.contains(&"figure9_row11.v"));
}

/// Where a picture stands in another one, as column and row; it has to be there once.
fn place_of(figure: &image::GrayImage, page: &image::GrayImage) -> (u32, u32) {
    let inside = |(left, top): &(u32, u32)| {
        figure.enumerate_pixels().all(|(x, y, pixel)| page.get_pixel(left + x, top + y) == pixel)
    };
    let room = (page.width() - figure.width(), page.height() - figure.height());
    let places = (0..=room.0).flat_map(|x| (0..=room.1).map(move |y| (x, y)));
    let found: Vec<(u32, u32)> = places.filter(inside).collect();
    assert_eq!(found.len(), 1, "{found:?}");
    found[0]
}

/// The pictures that are written have rows laid over each other as the appendix's program has them.
#[test]
fn the_upper_part_of_a_row_lies_over_the_next() {
    let (place, balls) = (Place::new(), Balls { radius: 16 });
    place.succeeds(&SMALL);
    let picture = |name: &str| {
        image::open(place.path(&format!("out/figure9/{name}"))).expect("a picture").to_luma8()
    };
    let codes: Vec<u8> = exact(balls).iter().map(|value| value.min(255.0).round() as u8).collect();
    let figure = image::GrayImage::from_raw(balls.width(), balls.height_of_all(), codes);
    let figure = figure.expect("as many pixels");
    let (formulas, simulated) = (picture("formulas.png"), picture("figure9.png"));
    let (left, top) = place_of(&figure, &formulas);
    for (x, y, wanted) in [(36, 100, 105), (70, 150, 24), (25, 25, 122)] {
        let at = (left + x, top + balls.height_of_all() - 1 - y);
        assert_eq!(formulas.get_pixel(at.0, at.1).0, [wanted], "column {x}, row {y}");
        let code = simulated.get_pixel(at.0, at.1).0[0];
        assert!(code.abs_diff(wanted) <= 1, "column {x}, row {y}: {code} for {wanted}");
    }
}

/// docs/figure9.md and its picture are what the command writes, but for the picture's folder.
#[test]
fn the_document_is_what_it_writes() {
    let place = Place::new();
    place.succeeds(&["reproduce", "figure9"]);
    let written = fs::read_to_string(place.path("out/figure9/report.md")).expect("a report");
    let checked_in = fs::read_to_string("../docs/figure9.md").expect("the document");
    let wanted = written.replace("(figure9.png)", "(images/figure9.png)");
    let first = checked_in.lines().zip(wanted.lines()).find(|(checked_in, now)| checked_in != now);
    assert!(checked_in == wanted, "docs/figure9.md is not what is written; first {first:#?}");
    assert!(written.contains("28579116.4644"), "{written}");
    let picture = fs::read(place.path("out/figure9/figure9.png")).expect("a picture");
    let checked_in = fs::read("../docs/images/figure9.png").expect("its picture");
    assert!(checked_in == picture, "docs/images/figure9.png is not what is written");
}

#[test]
fn what_it_does_not_take_is_refused() {
    let place = Place::new();
    for (arguments, said) in [
        (["--method", "phong"], "--method"),
        (["--mesh", "venus.ply"], "--mesh"),
        (["--size", "6x480"], "five balls in a row take 7x3 pixels at least"),
        (["--size", "7x2"], "five balls in a row take 7x3 pixels at least"),
        (["--size", "7"], "write width and height in pixels"),
    ] {
        let ended = place.specula(&["reproduce", "figure9", arguments[0], arguments[1]]);
        assert_eq!(ended.status, Some(2), "{arguments:?}");
        assert!(ended.stderr.contains(said), "{}", ended.stderr);
        assert!(place.names(".").is_empty());
    }
    let ended = place.specula(&["reproduce", "--mesh", "venus.ply", "figure9"]);
    assert_eq!(ended.status, Some(2), "{}", ended.stdout);
}

/// It was a scene of `run` once: who asks for that learns its place.
#[test]
fn it_is_no_scene() {
    let place = Place::new();
    for command in ["run", "needs"] {
        let ended = place.specula(&[command, "figure9"]);
        assert_eq!(ended.status, Some(2), "{}", ended.stdout);
        assert!(ended.stderr.contains("`specula reproduce figure9`"), "{}", ended.stderr);
        assert!(place.names(".").is_empty());
    }
    assert!(!place.succeeds(&["scenes"]).contains("\nfigure9"));
}
