//! Lengths of spans, and packets that are not a core's.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::{packet, spec, spec_with};
use specula_golden::fixed::{Model, PacketError};
use specula_spec::{CoreSpec, Method, SpanPacket};

use crate::{assert_within_one_code, codes};

/// Row 37: one pixel (S = 0, nothing to divide by) and two.
#[test]
fn the_shortest_spans_are_within_a_code() {
    for length in [1, 2] {
        let frame = frame(
            [tilted(-20.0), tilted(20.0)],
            length,
            &[tilted(-38.0), tilted(39.0)],
            material(0.1, 0.3, 0.3, 64),
        );
        for method in Method::ALL {
            assert_within_one_code(&spec(&frame, method), &frame);
        }
    }
}

/// Row 38: S = 8191, where second differences add up 2^24 times.
#[test]
fn the_longest_span_is_within_a_code() {
    for (widest, shininess) in [(30.0, 256), (90.0, 4096)] {
        let frame = frame(
            [tilted(-widest / 3.0), tilted(widest * 2.0 / 3.0)],
            8192,
            &[tilted(widest)],
            mirror(shininess),
        );
        for method in Method::ALL {
            assert_within_one_code(&spec(&frame, method), &frame);
        }
    }
}

/// Row 52: a flat face, k·k = 0, has one code from end to end.
#[test]
fn flat_faces_are_flat() {
    for (tilt, light) in [(0.0, 0.0), (17.3, 31.9), (60.0, 110.0), (85.0, 165.0)] {
        let frame = frame([tilted(tilt); 2], 1000, &[tilted(light)], material(0.1, 0.4, 0.4, 64));
        for core in Method::ALL.map(|m| spec(&frame, m)) {
            let codes = codes(&core, &frame);
            assert!(codes.iter().all(|&c| c == codes[0]));
            assert_within_one_code(&core, &frame);
        }
    }
}

/// A packet of another core or with values out of range is refused, and nothing is shaded.
#[test]
fn foreign_packets_are_refused() {
    let frame = frame([DVec3::Z; 2], 8, &[DVec3::Z], mirror(16));
    for core in Method::ALL.map(|m| spec(&frame, m)) {
        let good = packet(&core, &frame);
        let refused = |packet: SpanPacket| {
            let mut out = vec![[1, 2, 3]];
            let error = Model::new(&core).shade(&packet, &mut out).unwrap_err();
            assert_eq!(out, [[1, 2, 3]]);
            error
        };
        let of_length = |length| refused(SpanPacket { length, ..good.clone() });
        let with_inputs = |inputs| refused(SpanPacket { inputs, ..good.clone() });
        assert_eq!(
            [0, 9].map(of_length),
            [0, 9].map(|length| PacketError::Length { length, longest: 8 })
        );
        assert!(matches!(with_inputs(Vec::new()), PacketError::InputCount { given: 0, .. }));
        assert!(matches!(
            with_inputs(vec![i64::MAX; good.inputs.len()]),
            PacketError::OutOfRange { .. }
        ));
        assert_eq!(
            Model::new(&core).trace(&good, 8),
            Err(PacketError::NoSuchPixel { pixel: 8, length: 8 })
        );
    }
}

/// Ports have room for steps that only short spans take.
#[test]
fn scalars_that_are_added_past_a_unit_are_refused() {
    let frame = frame([DVec3::Z; 2], 8, &[DVec3::Z], mirror(16));
    let core = spec_with(&frame, Method::Direct, "increments = \"added\"");
    for name in ["view", "light0"] {
        let mut packet = packet(&core, &frame);
        assert_eq!(Model::new(&core).shade(&packet, &mut Vec::new()), Ok(()));
        let step = core.inputs().iter().position(|port| port.name == format!("{name}_step"));
        packet.inputs[step.expect("increments are added")] = core.inputs()[step.unwrap()].range.1;
        let refused = Model::new(&core).shade(&packet, &mut Vec::new());
        assert!(
            matches!(&refused, Err(PacketError::Outgrown { name: of, pixel: 7, .. }) if of == name),
            "{refused:?}"
        );
    }
}

/// `lyon` asks more of a packet than each port says.
#[test]
fn packets_past_the_unit_ball_are_refused() {
    let frame = frame([DVec3::Z; 2], 8, &[DVec3::Z], mirror(16));
    let cores = ["multiplied", "added"]
        .map(|increments| spec_with(&frame, Method::Lyon, &format!("increments = {increments:?}")));
    let with_high = |core: &CoreSpec, names: [&str; 3]| {
        let mut packet = packet(core, &frame);
        for (raw, port) in packet.inputs.iter_mut().zip(core.inputs()) {
            *raw = if names.contains(&port.name.as_str()) { port.range.1 } else { *raw };
        }
        Model::new(core).shade(&packet, &mut Vec::new())
    };
    let [multiplied, added] = &cores;
    for (core, high, long) in [
        (multiplied, ["normal_start_x", "normal_start_y", ""], "normal at the first pixel"),
        (multiplied, ["normal_delta_x", "", ""], "normal at the last pixel"),
        (added, ["normal_start_x", "normal_start_y", ""], "normal at the first pixel"),
    ] {
        let refused = with_high(core, high);
        assert!(
            matches!(&refused, Err(PacketError::LongVector { name, .. }) if name == long),
            "{refused:?}"
        );
    }
    let step = with_high(added, ["normal_step_x", "", ""]);
    assert!(
        matches!(&step, Err(PacketError::Outgrown { name, pixel: 7, value: 14.0, .. }) if name == "normal_x"),
        "{step:?}"
    );
    let weight = with_high(multiplied, ["weight_step", "", ""]);
    assert!(
        matches!(weight, Err(PacketError::Outgrown { pixel: 7, value: 7.0, .. })),
        "{weight:?}"
    );
}
