//! The ranges of `lyon`.
use glam::DVec3;
use specula_fixtures::frames::{frame, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_scene::Frame;
use specula_spec::lyon::{Difference, LyonSpec, Normalisation};
use specula_spec::{CoreSpec, Method, MethodSpec};

use crate::{assert_within_one_code, codes, trace, value};

fn changed(frame: &Frame, change: impl FnOnce(&mut LyonSpec)) -> CoreSpec {
    let mut core = spec(frame, Method::Lyon);
    if let MethodSpec::Lyon(lyon) = &mut core.method {
        change(lyon);
    }
    core.check().unwrap();
    core
}

fn reflection_form(frame: &Frame, squarings: u32) -> CoreSpec {
    changed(frame, |lyon| {
        lyon.difference = Difference::ReflectionMinusLight;
        lyon.squarings = squarings;
    })
}

fn flat(light: DVec3, shininess: u32) -> Frame {
    frame([DVec3::Z; 2], 1, &[light], mirror(shininess))
}

/// Row 21: x = 2^k exactly. N = V and L ⟂ N: |R - L|² = 2 and n = 2^k.
#[test]
fn shape_is_zero_at_its_end() {
    for k in 0..4 {
        let frame = flat(DVec3::X, 1 << k);
        let core = reflection_form(&frame, k);
        let trace = trace(&core, &frame, 0);
        assert_eq!(
            (
                value(&trace, "light0_shape_argument"),
                value(&trace, "light0_shape"),
                codes(&core, &frame)[0]
            ),
            (1.0, 0.0, 0)
        );
    }
}

/// Row 21: one unit in the last place before and behind the end. D = (0, d, 0), n = 1 and k = 0
/// give x = d²/2 of format `shape`.
#[test]
fn shape_is_never_negative() {
    for ulps in [-1, 0, 1] {
        let x = 1.0 + f64::from(ulps) / 4096.0;
        let frame = flat(tilted(2.0 * (x / 2.0).sqrt().asin().to_degrees()), 1);
        let core = changed(&frame, |lyon| {
            (lyon.difference, lyon.squarings) = (Difference::ReflectionMinusLight, 0);
            lyon.formats.vector.fraction_bits = 20;
            lyon.formats.difference.fraction_bits = 20;
        });
        let trace = trace(&core, &frame, 0);
        assert_eq!(value(&trace, "light0_shape_argument"), x);
        assert_eq!(value(&trace, "light0_shape"), f64::from(-ulps.min(0)) / 4096.0);
    }
}

/// Rows 22, 29 and 53: the centre of the highlight on the pixel, and axis-aligned vectors, are
/// exact: 1.0 and 255.
#[test]
fn centre_of_the_highlight_is_full_scale() {
    for shininess in [1, 256, 8191] {
        let frame = flat(DVec3::Z, shininess);
        for core in [spec(&frame, Method::Lyon), reflection_form(&frame, 2)] {
            assert_eq!(value(&trace(&core, &frame, 0), "light0_shape"), 1.0);
            assert_eq!(codes(&core, &frame), [255]);
        }
    }
}

/// Row 23: n = 1 at 180 and 90 degrees, k = 0 to 3; codes are 255 f rounded.
#[test]
fn tails_of_the_shape_are_the_methods() {
    for (k, at_180, at_90) in [(0, 0, 0), (1, 0, 64), (2, 16, 81), (3, 26, 88)] {
        for (light, code) in [(-DVec3::Z, at_180), (DVec3::X, at_90)] {
            let frame = flat(light, 1);
            assert_eq!(codes(&reflection_form(&frame, k), &frame), [code], "k = {k}");
        }
    }
}

/// Rows 24 and 25: L = -R gives D = (0, 0, 2), and n D·D = 32764 at n = 8191.
#[test]
fn longest_difference_fits() {
    let frame = flat(-DVec3::Z, 8191);
    let core = reflection_form(&frame, 2);
    let trace = trace(&core, &frame, 0);
    assert_eq!(value(&trace, "light0_difference_z"), 2.0);
    assert_eq!(value(&trace, "light0_shape_argument"), 8191.0 * 4.0 / 8.0);
    assert_eq!(codes(&core, &frame), [0]);
}

/// Row 26: quantised normals may be longer than 1, and y = 1 - z negative.
#[test]
fn length_may_exceed_one() {
    let longer = (1..90)
        .map(|d| frame([tilted(f64::from(d)); 2], 2, &[tilted(2.0 * f64::from(d))], mirror(256)))
        .filter(|frame| {
            let core = changed(frame, |lyon| lyon.normalisation = Normalisation::G2);
            let long = value(&trace(&core, frame, 0), "length_squared") > 1.0;
            assert_within_one_code(&core, frame);
            long
        });
    assert!(longer.count() > 10);
}

/// Row 28: where z = 0.8, g2 overshoots by 0.176 %, and 2 N·V reaches 2.0035.
#[test]
fn twice_n_dot_v_may_exceed_two() {
    let half = 0.8_f64.sqrt().acos().to_degrees();
    let frame = frame([tilted(-half), tilted(half)], 3, &[DVec3::Z], mirror(16));
    let core = changed(&frame, |lyon| {
        (lyon.difference, lyon.newton_steps) = (Difference::ReflectionMinusLight, 0)
    });
    let twice = value(&trace(&core, &frame, 1), "light0_twice_n_dot_v");
    assert!((twice - 2.003_52).abs() < 1e-4, "{twice}");
    assert_within_one_code(&core, &frame);
}

/// Row 31: D long along one axis alone has no highlight.
#[test]
fn difference_along_one_axis_is_enough() {
    for light in [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y] {
        let frame = flat(light, 256);
        assert_eq!(codes(&spec(&frame, Method::Lyon), &frame), [0]);
    }
}
