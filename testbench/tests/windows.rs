//! Traced windows: which clocks they are, and that what they show is what the whole run shows.
use std::ops::Range;

use specula_fixtures::frames::{Row, frame_of, material, tilted};
use specula_fixtures::specs::{lyon, spec};
use specula_scene::Frame;
use specula_sim::{Batch, Columns, Flow, Stimulus};
use specula_spec::{CoreSpec, Method};
use specula_testbench::trace::{Choice, WORST_WINDOW, leaving_clock};
use specula_testbench::{Bench, EngineKind, FrameSpans, Outcome, WorstPixel};

const LENGTHS: [u32; 7] = [1, 30, 1, 1, 200, 3, 64];

fn picture() -> Frame {
    let row = |(number, &length): (usize, &u32)| {
        let from = 20.0 * number as f64 - 70.0;
        Row {
            normals: [tilted(from), tilted(from + 25.0)],
            length,
            material: material(0.1, 0.4, 0.45, 8),
        }
    };
    let rows: Vec<Row> = LENGTHS.iter().enumerate().map(row).collect();
    frame_of(&rows, &[tilted(12.0)])
}

fn pixels() -> u64 {
    LENGTHS.iter().map(|&length| u64::from(length)).sum()
}

fn run(bench: &Bench) -> Outcome {
    let outcome = bench.run(EngineKind::RustHdl, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.fault(), None);
    outcome
}

/// Every signal over the clocks of a choice, and those clocks.
fn trace(bench: &Bench, choice: &Choice, outcome: &Outcome) -> (Option<Range<u64>>, Columns) {
    let mut shown = Columns::default();
    let mut sink = |batch: &Batch| {
        if shown.nodes.is_empty() {
            shown = Columns::new(batch.nodes());
        }
        shown.extend(batch);
        Flow::Continue
    };
    let window = bench.trace(EngineKind::RustHdl, choice, outcome, &mut sink).unwrap();
    (window, shown)
}

/// The rows of a trace whose clocks lie in `window`.
fn part(whole: &Columns, window: &Range<u64>) -> Columns {
    let mut part = Columns::new(&whole.nodes);
    part.extend(&whole.batch().within(window));
    part
}

fn cores(frame: &Frame) -> [CoreSpec; 2] {
    [lyon(frame, |lyon| lyon.newton_steps = 1), spec(frame, Method::Hybrid)]
}

/// Windows at the very beginning, across spans of one pixel, inside a long span, and at the very
/// end.
#[test]
fn windows_show_what_the_whole_run_shows() {
    let frame = picture();
    for core in cores(&frame) {
        let bench = Bench::new(&frame, &core, "core").unwrap();
        let outcome = run(&bench);
        let (all, whole) = trace(&bench, &Choice::All, &outcome);
        let end = pixels() + u64::from(bench.design.latency()) + 1;
        assert_eq!((all, whole.clocks() as u64), (Some(0..end), end));
        let early = [0..1, 0..50, 1..2, 29..40, 33..36];
        let late = [150..151, 240..300, end - 100..end, end - 2..end, end - 1..end];
        for window in early.into_iter().chain(late) {
            let (shown, columns) = trace(&bench, &Choice::Cycles(window.clone()), &outcome);
            assert_eq!(shown, Some(window.clone()));
            same_values(&bench, &columns, &part(&whole, &window));
        }
    }
}

fn same_values(bench: &Bench, shown: &Columns, wanted: &Columns) {
    assert_eq!((shown.span(), &shown.nodes), (wanted.span(), &wanted.nodes));
    for (number, node) in shown.nodes.iter().enumerate() {
        let name = bench.design.full_name(*node);
        assert_eq!(shown.values[number], wanted.values[number], "{name} over {:?}", shown.span());
    }
}

/// The clocks of a choice in the run of this picture.
fn window(choice: Choice, worst: Option<(usize, u32)>) -> Option<Range<u64>> {
    let frame = picture();
    let core = spec(&frame, Method::Lyon);
    let design = specula_hdl::elaborate(&core, "core").unwrap();
    let spans = FrameSpans::new(&frame, &core);
    let stimulus = Stimulus::whole(&spans, &design);
    let worst = worst.map(|(span, pixel)| WorstPixel { x: 0, y: 0, span, pixel, error_lsb: 1.0 });
    choice.window(&stimulus, &design, worst.as_ref())
}

fn latency() -> u64 {
    let core = spec(&picture(), Method::Lyon);
    u64::from(specula_hdl::elaborate(&core, "core").unwrap().latency())
}

#[test]
fn cycles_are_clipped_to_the_run() {
    let end = pixels() + latency() + 1;
    assert_eq!(window(Choice::Cycles(10..20), None), Some(10..20));
    assert_eq!(window(Choice::Cycles(10..u64::MAX), None), Some(10..end));
    assert_eq!(window(Choice::All, None), Some(0..end));
    let reversed = Range { start: 20, end: 10 };
    for empty in [10..10, reversed, end..end + 5, u64::MAX - 1..u64::MAX] {
        assert_eq!(window(Choice::Cycles(empty.clone()), None), None, "{empty:?}");
    }
    assert_eq!(window(Choice::None, Some((0, 0))), None);
}

/// A span's window holds it from its first pixel's entry to its last pixel's exit.
#[test]
fn spans_are_shown_whole() {
    assert_eq!(window(Choice::Span(0), None), Some(0..1 + latency() + 1));
    assert_eq!(window(Choice::Span(1), None), Some(1..31 + latency() + 1));
    assert_eq!(window(Choice::Span(6), None), Some(pixels() - 64..pixels() + latency() + 1));
}

/// The worst pixel's exit stands three quarters into the window, or as near as the run's ends
/// allow.
#[test]
fn the_worst_pixel_stands_in_its_window() {
    assert_eq!(window(Choice::Worst, None), None);
    let end = pixels() + latency() + 1;
    for (span, pixel, begins) in [(0, 0, 0), (4, 0, 33), (4, 180, 33), (6, 63, 236)] {
        let shown = window(Choice::Worst, Some((span, pixel))).unwrap();
        let leaves = begins + u64::from(pixel) + latency();
        assert!(shown.contains(&leaves), "{shown:?} and {leaves}");
        let first = (leaves + WORST_WINDOW / 4).saturating_sub(WORST_WINDOW);
        assert_eq!(shown, first..(first + WORST_WINDOW).min(end));
        if first > 0 {
            assert_eq!(leaves - shown.start, WORST_WINDOW * 3 / 4);
        }
    }
}

/// The bench names the clock in which the worst pixel leaves, and there its code stands at the
/// outputs.
#[test]
fn the_worst_cycle_is_where_the_worst_pixel_leaves() {
    let frame = picture();
    for core in cores(&frame) {
        let bench = Bench::new(&frame, &core, "core").unwrap();
        let outcome = run(&bench);
        let worst = outcome.comparison.worst_pixel.unwrap();
        let clock = outcome.worst_cycle.unwrap();
        let spans = FrameSpans::new(&frame, &core);
        let stimulus = Stimulus::whole(&spans, &bench.design);
        assert_eq!(clock, leaving_clock(&stimulus, &bench.design, worst.span, worst.pixel));
        let (_, columns) = trace(&bench, &Choice::Cycles(clock..clock + 1), &outcome);
        let at = |node| columns.of(node).unwrap()[0];
        let code: Vec<i64> = bench.design.outputs.iter().map(|&output| at(output)).collect();
        let pixel = outcome.simulated.pixels[(worst.y * frame.width + worst.x) as usize];
        assert_eq!((code, at(bench.design.valid_out)), (pixel.map(i64::from).to_vec(), 1));
    }
}
