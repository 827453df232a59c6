//! Lengths of spans.
use glam::DVec3;
use rayon::prelude::*;
use specula_fixtures::frames::{Row, frame, frame_of, material, mirror, tilted};
use specula_scene::Material;
use specula_spec::Method;

use crate::cores::cores;
use crate::run::{assert_agrees, codes, row};

fn lit(shininess: u32) -> Material {
    material(0.1, 0.3, 0.5, shininess)
}

/// Row 37: one pixel, whose step has nothing to divide by, and two.
#[test]
fn the_shortest_spans_agree() {
    for length in [1, 2, 3] {
        let frame =
            frame([tilted(-20.0), tilted(20.0)], length, &[tilted(-38.0), tilted(39.0)], lit(64));
        for core in cores(&frame) {
            assert_agrees(&core, &frame);
        }
    }
}

/// Row 38: S = 8191, where second differences add up to 2^24 times their error.
#[test]
fn the_longest_span_has_its_highlight() {
    let frame = frame([tilted(-30.0), tilted(60.0)], 8192, &[tilted(90.0)], mirror(4096));
    for core in cores(&frame) {
        let codes = codes(&core, &frame);
        // `gouraud` sees the vertices alone.
        assert_eq!(
            codes.contains(&255),
            core.method() != Method::Gouraud,
            "the highlight lies on the span"
        );
    }
}

/// Row 52: a flat face has one code from end to end.
#[test]
fn flat_faces_have_one_code_from_end_to_end() {
    for (tilt, light) in [(0.0, 0.0), (17.3, 31.9), (60.0, 110.0), (85.0, 165.0)] {
        let frame = frame([tilted(tilt); 2], 1000, &[tilted(light)], material(0.1, 0.4, 0.4, 64));
        for core in cores(&frame) {
            let codes = codes(&core, &frame);
            assert!(codes.iter().all(|&code| code == codes[0]));
        }
    }
}

const MIXED: [u32; 12] = [1, 1, 1, 5, 1, 8192, 1, 2, 1, 3, 2, 1];

fn mixed() -> Vec<Row> {
    let tilts = |number: usize| {
        let from = 12.0 * number as f64 - 60.0;
        [tilted(from), (tilted(from + 35.0) + 0.3 * DVec3::Y).normalize()]
    };
    MIXED
        .iter()
        .enumerate()
        .map(|(number, &length)| Row {
            normals: tilts(number),
            length,
            material: lit(1 << (number % 8)),
        })
        .collect()
}

/// Spans of mixed lengths, one straight after the other: each pixel in its clock, and each span as
/// if it were alone.
#[test]
fn spans_leave_nothing_behind() {
    let rows = mixed();
    let lights = [tilted(15.0), DVec3::new(-0.6, 0.64, 0.48)];
    let together = frame_of(&rows, &lights);
    cores(&together).par_iter().for_each(|core| {
        let outcome = assert_agrees(core, &together);
        assert_eq!(outcome.pixels, MIXED.iter().map(|&length| u64::from(length)).sum::<u64>());
        for (number, alone) in rows.iter().enumerate().filter(|(_, row)| row.length < 10) {
            let alone = frame_of(std::slice::from_ref(alone), &lights);
            assert_eq!(
                row(&outcome, &together, number),
                row(&assert_agrees(core, &alone), &alone, 0),
                "{core:?}, span {number}"
            );
        }
    });
}

/// A frame in which nothing is visible still runs to its end.
#[test]
fn no_span_at_all() {
    let mut frame = frame([DVec3::Z; 2], 3, &[DVec3::Z], lit(4));
    frame.spans.clear();
    for core in cores(&frame) {
        let outcome = assert_agrees(&core, &frame);
        assert_eq!((outcome.pixels, outcome.worst_cycle), (0, None));
        assert!(outcome.simulated.pixels.iter().all(|&code| code == frame.background));
    }
}
