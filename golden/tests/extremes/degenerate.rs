//! Normals that vanish or oppose each other.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_golden::exact;
use specula_spec::Method;

use crate::{assert_within_one_code, codes, method, trace, value};

const AMBIENT: f64 = 0.2;

/// Row 1: N0 = -N1, and t = 1/2 is a pixel.
#[test]
fn opposite_normals_have_a_defined_middle() {
    let frame = frame([DVec3::X, -DVec3::X], 3, &[tilted(30.0)], material(AMBIENT, 0.5, 0.3, 16));
    let span = &frame.spans[0];
    assert_eq!(exact::phong(&frame, span, 1), [255.0 * AMBIENT; 3]);
    for core in Method::ALL.map(|m| spec(&frame, m)) {
        assert!(method(&core, &frame).iter().all(|c| c.is_finite()));
        assert_within_one_code(&core, &frame);
    }
}

/// Row 1: "S = 3 never hits t = 1/2: 1, 1, -1, -1".
#[test]
fn neighbours_of_the_middle_are_right() {
    let normals = [tilted(20.0), -tilted(20.0)];
    let frame = frame(normals, 4, &[tilted(10.0)], material(0.0, 1.0, 0.0, 16));
    let lambert = 255.0 * tilted(20.0).dot(tilted(10.0));
    let phong = [0, 1, 2, 3].map(|i| exact::phong(&frame, &frame.spans[0], i)[0]);
    for (got, want) in phong.into_iter().zip([lambert, lambert, 0.0, 0.0]) {
        assert!((got - want).abs() < 1e-12);
    }
    assert_within_one_code(&spec(&frame, Method::Lyon), &frame);
}

/// Rows 2 and 4: q = 0 in the middle gives no highlight there, and neither does a q that rounds
/// below 0.
#[test]
fn hybrid_has_no_highlight_where_q_is_zero() {
    for length in [3, 5, 9, 257] {
        let frame = frame([DVec3::Z, -DVec3::Z], length, &[DVec3::Z], mirror(16));
        let core = spec(&frame, Method::Hybrid);
        let codes = codes(&core, &frame);
        let middle = length as usize / 2;
        assert_eq!((codes[0], codes[middle], codes[length as usize - 1]), (255, 0, 255));
        assert_eq!(value(&trace(&core, &frame, middle as u32), "light0_base"), 0.0);
    }
}

/// Row 2: where q = 0 the root is 0 and with it everything but ambient light; beside it the root is
/// as long as the normal asks.
#[test]
fn duff_has_no_root_where_q_is_zero() {
    for length in [3, 5, 257] {
        let frame = frame([DVec3::Z, -DVec3::Z], length, &[DVec3::Z], mirror(16));
        let core = spec(&frame, Method::Duff);
        let middle = length / 2;
        let at = |i: u32, name: &str| value(&trace(&core, &frame, i), name);
        assert_eq!(
            (at(middle, "denominator"), at(middle, "root"), at(middle, "light0_base")),
            (0.0, 0.0, 0.0)
        );
        let beside = f64::from(middle);
        assert!((at(middle - 1, "root") - beside).abs() < 0.01 * beside);
        assert_within_one_code(&core, &frame);
    }
}

/// Row 10: with n = N the square of the half-way vector is 1 exactly, and so is its reciprocal.
#[test]
fn reflection_about_the_normal_itself_is_exact() {
    let frame = frame([DVec3::Z; 2], 3, &[DVec3::Z], mirror(16));
    let core = spec(&frame, Method::Reflection);
    let trace = trace(&core, &frame, 2);
    let values = ["denominator", "reciprocal", "light0_cosine", "light0_base"]
        .map(|name| value(&trace, name));
    assert_eq!(values, [1.0; 4]);
}

/// Row 3: a span of 150 degrees makes q small, and the default has bits for that.
#[test]
fn hybrid_serves_150_degrees() {
    let frame = frame([tilted(-75.0), tilted(75.0)], 300, &[tilted(10.0)], mirror(256));
    assert_within_one_code(&spec(&frame, Method::Hybrid), &frame);
    assert_within_one_code(&spec(&frame, Method::Duff), &frame);
}

/// Row 27: z = 0 gives g2 = 2.
#[test]
fn gain_of_a_vanished_normal_is_two() {
    let frame = frame([DVec3::X, -DVec3::X], 3, &[DVec3::Z], mirror(16));
    let core = spec(&frame, Method::Lyon);
    let trace = trace(&core, &frame, 1);
    assert_eq!((value(&trace, "length_squared"), value(&trace, "gain")), (0.0, 2.0));
}

/// Rows 12 and 35: L = -V makes H = 0, and the highlight 1 for every normal; R - L has no such
/// trouble.
#[test]
fn light_opposite_the_eye() {
    let frame = frame([tilted(10.0), tilted(20.0)], 8, &[-DVec3::Z], mirror(16));
    let core = spec(&frame, Method::Lyon);
    assert_eq!(codes(&core, &frame), [255; 8]);
    assert_eq!(codes(&spec(&frame, Method::Hybrid), &frame), [0; 8]);
}
