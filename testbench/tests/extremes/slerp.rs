//! Angles between nothing and half a turn.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_scene::{Frame, Span};
use specula_spec::slerp::SlerpFormats;
use specula_spec::{CoreSpec, Method, MethodSpec};

use crate::run::{assert_agrees, codes};

fn slerp(frame: &Frame, change: impl FnOnce(&mut SlerpFormats)) -> CoreSpec {
    let mut core = spec(frame, Method::Slerp);
    if let MethodSpec::Slerp(slerp) = &mut core.method {
        change(&mut slerp.formats);
    }
    core
}

/// Rows 13 and 15: no angle at all, one that an arc cosine of a rounded dot product would lose, and
/// those round 10 degrees, where others go over to linear interpolation: within a code of exact
/// shading.
#[test]
fn small_angles_are_within_a_code_of_exact_shading() {
    for degrees in [0.0, 1e-9, 0.01, 9.9, 10.1] {
        for (length, n) in [(17, 32), (250, 256)] {
            let frame = frame(
                [tilted(10.0), tilted(10.0 + degrees)],
                length,
                &[tilted(21.0)],
                material(0.1, 0.4, 0.4, n),
            );
            let outcome = assert_agrees(&spec(&frame, Method::Slerp), &frame);
            let total = outcome.comparison.errors.total.max_lsb;
            assert!(total <= 1.0, "{degrees} degrees over {length} pixels: {total} LSB");
        }
    }
}

/// Row 13: without an angle every pixel is the first.
#[test]
fn no_angle_is_exactly_flat() {
    let frame = frame([tilted(33.0); 2], 1000, &[tilted(50.0)], material(0.0, 0.5, 0.5, 64));
    let codes = codes(&spec(&frame, Method::Slerp), &frame);
    assert!(codes.iter().all(|&code| code == codes[0]));
}

/// Row 14: opposite normals turn by 180 degrees in one of the planes through them, and are unit
/// vectors all the way.
#[test]
fn half_a_turn() {
    for first in [DVec3::X, DVec3::Y, DVec3::Z, tilted(40.0), -tilted(70.0)] {
        for length in [2, 3, 65] {
            let frame = frame([first, -first], length, &[first], material(0.0, 1.0, 0.0, 16));
            let codes = codes(&spec(&frame, Method::Slerp), &frame);
            assert_eq!((codes[0], codes[length as usize - 1]), (255, 0));
            let cosine =
                |i: usize| (std::f64::consts::PI * i as f64 / f64::from(length - 1)).cos().max(0.0);
            for (i, &code) in codes.iter().enumerate() {
                assert!((f64::from(code) - 255.0 * cosine(i)).abs() <= 1.0, "{codes:?}");
            }
        }
    }
}

/// Row 16: 1 degree in 16 steps with 8 fraction bits freezes the normal, and what it is off by
/// stays within its bound; the default formats have bits enough. 30 degrees in 4096 steps with 11
/// are refused.
#[test]
fn sine_that_rounds_to_nothing() {
    let short = frame([tilted(44.0), tilted(45.0)], 17, &[tilted(0.0)], material(0.0, 1.0, 0.0, 1));
    let frozen = slerp(&short, |f| {
        (f.turn.fraction_bits, f.state.fraction_bits, f.weight.fraction_bits) = (8, 8, 8);
    });
    frozen.check().unwrap();
    let port = frozen.inputs().iter().position(|port| port.name == "turn_sine").unwrap();
    assert_eq!(frozen.packet(&short, &short.spans[0]).inputs[port], 0);
    let stays = codes(&frozen, &short);
    assert!(stays.iter().all(|&code| code == stays[0]));
    let moves = codes(&spec(&short, Method::Slerp), &short);
    for (i, &code) in moves.iter().enumerate() {
        let exact = 255.0 * tilted(44.0 + i as f64 / 16.0).z;
        assert!((f64::from(code) - exact).abs() <= 1.0);
        assert!((f64::from(stays[0]) - exact).abs() <= 255.0 * 1f64.to_radians().sin() + 1.0);
    }

    let long = frame([tilted(0.0), tilted(30.0)], 4097, &[tilted(0.0)], mirror(1));
    assert!(slerp(&long, |f| f.state.fraction_bits = 11).check().is_err());
}

/// Row 17: a triangle whose normals are `degrees` apart, scanned in any direction. Linear
/// interpolation has z at its centre whatever the direction is; here the farthest from it is so
/// many degrees off (worked out apart from this, by eq. 4.7).
#[test]
fn centre_depends_on_the_direction_of_scanning() {
    for (degrees, off) in [(30f64, 0.1366), (60.0, 1.2260), (90.0, 5.2644)] {
        // Three unit vectors about z, so far from it that they are `degrees` apart: 3/2 sin² θ =
        // 1 - cos.
        let tilt = ((1.0 - degrees.to_radians().cos()) / 1.5).sqrt().asin();
        let about = |k: f64| {
            let (sin, cos) = (k * std::f64::consts::TAU / 3.0).sin_cos();
            DVec3::new(tilt.sin() * cos, tilt.sin() * sin, tilt.cos())
        };
        let mut frame = frame([DVec3::Z; 2], 3, &[DVec3::Z], mirror(1));
        frame.triangles[0].normals = [0.0, 1.0, 2.0].map(about);
        // From a point on one edge through the centre to another edge, as many times as far behind
        // it as weights reach.
        let off_z = |along: f64| {
            let start = [1.0 - along, along, 0.0];
            let third = 1.0 / 3.0;
            let behind = start
                .iter()
                .filter(|&&w| w > third)
                .map(|w| third / (w - third))
                .fold(f64::INFINITY, f64::min);
            let end = start.map(|w| third + behind * (third - w));
            let arc = frame.arc(&Span { x: 0, y: 0, length: 3, triangle: 0, start, end });
            let (sin, cos) = (arc.angle / (1.0 + behind)).sin_cos();
            (cos * arc.start + sin * arc.across).angle_between(DVec3::Z).to_degrees()
        };
        let farthest = (1..1000).map(|k| off_z(f64::from(k) / 1000.0)).fold(0.0, f64::max);
        assert!((farthest - off).abs() < 1e-4, "{farthest} degrees of {degrees}");
    }
}
