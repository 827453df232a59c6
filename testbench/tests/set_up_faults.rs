//! Faults of the set-up, which core and bit-true model share: they agree, and the error that goes
//! beyond its bound tells.
use glam::DVec3;
use specula_fixtures::frames::{Row, frame_of, material, tilted};
use specula_fixtures::specs::spec;
use specula_scene::Frame;
use specula_spec::{CoreSpec, Method, SetUp, SpanPacket};
use specula_testbench::{Bench, EngineKind, Outcome};

/// Spans that turn, under a slanting light.
fn picture() -> Frame {
    let row = |number: u32| Row {
        normals: [tilted(10.0 * f64::from(number) - 50.0), tilted(10.0 * f64::from(number) - 20.0)],
        length: 12 + number,
        material: material(0.1, 0.5, 0.3, 16),
    };
    frame_of(&[0, 1, 2, 3, 4, 5].map(row), &[DVec3::new(0.36, -0.48, 0.8)])
}

/// What a host sends that changes inputs of this name after they are set up.
fn sent(
    core: &CoreSpec,
    frame: &Frame,
    named: &str,
    wrong: impl Fn(i64, u32) -> i64,
) -> Vec<SpanPacket> {
    let (ports, set_up) = (core.inputs(), SetUp::new(core, frame));
    let concerned: Vec<usize> =
        (0..ports.len()).filter(|&input| ports[input].name.contains(named)).collect();
    assert!(!concerned.is_empty(), "there is no input {named}");
    let packet = |span| {
        let mut packet: SpanPacket = set_up.packet(span);
        concerned
            .iter()
            .for_each(|&input| packet.inputs[input] = wrong(packet.inputs[input], packet.length));
        packet
    };
    frame.spans.iter().map(packet).collect()
}

fn run(core: &CoreSpec, frame: &Frame, packets: &Vec<SpanPacket>) -> Outcome {
    let bench = Bench::new(frame, core, "core").unwrap();
    bench.run_given(packets, EngineKind::Fast, &mut |_, _| ()).unwrap()
}

/// Core and model agree on every pixel, and yet the run does not; says the error.
fn is_told(method: Method, named: &str, wrong: impl Fn(i64, u32) -> i64) -> f64 {
    let frame = picture();
    let core = spec(&frame, method).general();
    let right = run(&core, &frame, &sent(&core, &frame, named, |raw, _| raw));
    assert!(right.agrees(), "{} itself is right", method.name());
    let outcome = run(&core, &frame, &sent(&core, &frame, named, wrong));
    assert_eq!((outcome.comparison.mismatches, &outcome.wrong_clocks), (0, &vec![]));
    assert!(!outcome.agrees(), "{}: {named}", method.name());
    let worst = outcome.beyond_bound().expect("what is wrong is the error");
    assert_eq!(worst.simulated, worst.expected);
    assert_eq!(worst.error_lsb, outcome.comparison.errors.quantisation.max_lsb);
    assert_eq!((f64::from(worst.simulated) - worst.method).abs(), worst.error_lsb);
    assert!(worst.error_lsb > outcome.bound_lsb && outcome.comparison.beyond_bound > 0);
    let place = (worst.y * frame.width + worst.x) as usize;
    assert_eq!(outcome.simulated.pixels[place][worst.channel], worst.simulated);
    assert_eq!(
        (frame.spans[worst.span].y, frame.spans[worst.span].x + worst.pixel),
        (worst.y, worst.x)
    );
    worst.error_lsb
}

#[test]
fn a_light_from_behind_is_told() {
    for method in [Method::Lyon, Method::Phong, Method::Consistent] {
        assert!(is_told(method, "light0_direction", |raw, _| -raw) > 50.0);
    }
}

/// Steps that are worked out for a pixel more than there are.
#[test]
fn steps_over_a_pixel_too_many_are_told() {
    let over_one_more = |raw: i64, length: u32| {
        (raw as f64 * f64::from(length - 1) / f64::from(length)).round() as i64
    };
    for (method, named) in [
        (Method::Lyon, "weight_step"),
        (Method::Phong, "weight_step"),
        (Method::Direct, "weight_step"),
        (Method::Gouraud, "diffuse_intensity_step"),
        (Method::Duff, "_step"),
    ] {
        assert!(is_told(method, named, over_one_more) > 1.0, "{}", method.name());
    }
}

/// Of the denominator, which falls a little too far then, so that nothing outgrows what the model
/// allows for.
#[test]
fn a_first_difference_that_is_too_large_is_told() {
    for method in [Method::Hybrid, Method::Reflection] {
        assert!(
            is_told(method, "denominator_first_difference", |raw, _| raw + raw / 10) > 1.0,
            "{}",
            method.name()
        );
    }
}

/// A bound that is wrong is told like a set-up that is: here one of half what is proven of it.
#[test]
fn a_wrong_bound_is_told() {
    let frame = picture();
    let core = spec(&frame, Method::Phong);
    let mut bench = Bench::new(&frame, &core, "core").unwrap();
    bench.design.output_errors = vec![0.25; 3];
    let outcome = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
    assert_eq!(outcome.comparison.mismatches, 0);
    assert!(
        !outcome.agrees() && outcome.beyond_bound().is_some_and(|worst| worst.error_lsb <= 2.0)
    );
}
