//! The highlight: its centre, its end, its exponents.
use glam::DVec3;
use specula_fixtures::frames::{Row, frame, frame_of, material, mirror, tilted};
use specula_fixtures::specs::{lyon, spec};
use specula_scene::{Frame, Needs};
use specula_spec::duff::Highlight;
use specula_spec::lyon::Difference;
use specula_spec::{CoreSpec, Method, SpecError};

use crate::cores::{cores, cross_form, duff, duffs, reflection_form};
use crate::run::{assert_agrees, codes};

fn flat(light: DVec3, shininess: u32) -> Frame {
    frame([DVec3::Z; 2], 1, &[light], mirror(shininess))
}

/// Rows 10, 22, 29 and 53: the centre of the highlight on an axis-aligned normal is 255. H·H is 4
/// there.
#[test]
fn centre_is_full_scale() {
    for squarings in 0..=3 {
        for shininess in [1, 256, 8191] {
            let frame = flat(DVec3::Z, shininess);
            for core in [cross_form(&frame, squarings), reflection_form(&frame, squarings)] {
                assert_eq!(codes(&core, &frame), [255]);
            }
        }
    }
    for j in 0..=12 {
        let frame = flat(DVec3::Z, 1 << j);
        assert_eq!(codes(&spec(&frame, Method::Hybrid), &frame), [255]);
        for core in duffs(&frame) {
            assert_eq!(codes(&core, &frame), [255]);
        }
    }
}

/// Row 21: x = 2^k exactly. N = V and L across it make |R - L|² = 2, and n = 2^k.
#[test]
fn end_of_the_shape_is_zero() {
    for squarings in 0..=3 {
        for light in [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y] {
            let frame = flat(light, 1 << squarings);
            assert_eq!(codes(&reflection_form(&frame, squarings), &frame), [0]);
        }
    }
}

/// Row 21: with a light a little to either side of x = 2^k, the code falls to 0 and stays there;
/// k = 0 is the steepest.
#[test]
fn nothing_comes_back_behind_the_end() {
    for squarings in 0..=3 {
        let mut last = 255;
        for tenths in 880..=920 {
            let frame = frame(
                [DVec3::Z; 2],
                1,
                &[tilted(f64::from(tenths) / 10.0)],
                mirror(1 << squarings),
            );
            let code = codes(&reflection_form(&frame, squarings), &frame)[0];
            assert!(code <= last, "{code} at {tenths} tenths of a degree comes after {last}");
            assert!(tenths < 900 || code == 0);
            last = code;
        }
    }
}

/// Row 23: n = 1 at 180 and 90 degrees, for k = 0 to 3; codes are 255 f rounded.
#[test]
fn tails_are_the_methods() {
    for (k, at_180, at_90) in [(0, 0, 0), (1, 0, 64), (2, 16, 81), (3, 26, 88)] {
        for (light, code) in [(-DVec3::Z, at_180), (DVec3::X, at_90)] {
            let frame = flat(light, 1);
            assert_eq!(codes(&reflection_form(&frame, k), &frame), [code], "k = {k}");
        }
    }
}

/// Rows 24, 25 and 31: D as long as it can be, along one axis, with n = 8191: 0 and not wrapped
/// around.
#[test]
fn the_longest_difference_gives_no_highlight() {
    for squarings in 0..=3 {
        let opposite = flat(-DVec3::Z, 8191);
        assert_eq!(codes(&reflection_form(&opposite, squarings), &opposite), [0]);
        for light in [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y] {
            let across = flat(light, 8191);
            for core in [cross_form(&across, squarings), reflection_form(&across, squarings)] {
                assert_eq!(codes(&core, &across), [0]);
            }
        }
    }
}

/// Rows 24 and 28: where z = 0.8 g2 overshoots by 0.176 %; 2 N·V is 2.0035 and R longer than 1,
/// with the light opposite to it.
#[test]
fn longest_difference_with_overshoot() {
    let half = 0.8f64.sqrt().acos().to_degrees();
    for light in [DVec3::Z, -DVec3::Z] {
        for (newton_steps, shininess) in [(0, 16), (0, 8191), (1, 8191)] {
            let frame = frame([tilted(-half), tilted(half)], 3, &[light], mirror(shininess));
            let core = lyon(&frame, |lyon| {
                lyon.difference = Difference::ReflectionMinusLight;
                lyon.newton_steps = newton_steps;
            });
            assert_agrees(&core, &frame);
        }
    }
}

/// Row 5: a negative base has no highlight, though n is even.
#[test]
fn negative_base_is_zero() {
    for degrees in [91.0, 100.0, 135.0, 180.0] {
        let frame = frame([DVec3::Z; 2], 4, &[tilted(degrees)], mirror(2));
        assert_eq!(codes(&spec(&frame, Method::Hybrid), &frame), [0; 4]);
        for highlight in [Highlight::Quotient, Highlight::Eq33, Highlight::Eq34] {
            assert_eq!(codes(&duff(&frame, highlight), &frame), [0; 4]);
        }
    }
    // Blinn's base is negative where N and H are more than 90 degrees apart.
    let behind = frame([-DVec3::Z; 2], 4, &[DVec3::Z], mirror(2));
    assert_eq!(codes(&duff(&behind, Highlight::Blinn), &behind), [0; 4]);
}

/// Row 6: with the light in the reflection p and q are the same but for rounding, and the base is
/// 1, never more.
#[test]
fn base_is_at_most_one() {
    for degrees in (0..900).step_by(7).map(|tenths| f64::from(tenths) / 10.0) {
        let frame = frame([tilted(degrees); 2], 2, &[tilted(2.0 * degrees)], mirror(4096));
        let hybrid = spec(&frame, Method::Hybrid);
        for core in duffs(&frame).iter().chain([&hybrid]) {
            let codes = codes(core, &frame);
            assert!(
                codes.iter().all(|&code| code >= 254),
                "{codes:?} at {degrees} degrees: {core:?}"
            );
        }
    }
}

/// Row 54: every kind of exponent that a method takes.
#[test]
fn every_kind_of_exponent_agrees() {
    let lit = |shininess| {
        frame([tilted(-10.0), tilted(10.0)], 40, &[tilted(5.0)], material(0.1, 0.4, 0.5, shininess))
    };
    for shininess in [1, 2, 3, 5, 100, 255, 257, 4095, 4097, 8190, 8191] {
        let frame = lit(shininess);
        for core in [cross_form(&frame, 2), reflection_form(&frame, 2)] {
            assert_agrees(&core, &frame);
        }
    }
    for j in 0..=12 {
        let frame = lit(1 << j);
        assert_agrees(&spec(&frame, Method::Hybrid), &frame);
        for core in duffs(&frame) {
            assert_agrees(&core, &frame);
        }
    }
}

/// Row 54: squaring that is asked for does not reach every exponent, and tables do.
#[test]
fn squaring_alone_refuses_exponents() {
    let needs = Needs::of(&flat(DVec3::Z, 100));
    for method in [
        Method::Hybrid,
        Method::Duff,
        Method::Reflection,
        Method::Slerp,
        Method::Direct,
        Method::Consistent,
    ] {
        let core = |options: &str| {
            let options = format!("{}.{options}", method.name()).parse().unwrap();
            CoreSpec::for_scene(&needs, Some(&options), Some(method))
        };
        let refused = core("power = \"squaring\"").unwrap_err();
        assert_eq!(
            refused,
            SpecError::UnevenShininess {
                method: method.name(),
                shininess: 100,
                below: 64,
                above: 128
            }
        );
        assert_eq!(
            core("power = \"tables\"").unwrap(),
            CoreSpec::for_scene(&needs, None, Some(method)).unwrap()
        );
    }
}

/// Row 54: exponents that there is no core for are refused before anything is built.
#[test]
fn exponents_without_a_core() {
    let refused = |shininess, method| {
        let frame = flat(DVec3::Z, shininess);
        CoreSpec::for_scene(&Needs::of(&frame), None, Some(method)).unwrap_err()
    };
    for method in Method::ALL {
        assert!(matches!(refused(0, method), SpecError::OutOfRange { .. }));
        assert!(matches!(refused(8192, method), SpecError::OutOfRange { .. }));
    }
}

/// Many materials in one frame: the exponent changes from span to span, and the core follows.
#[test]
fn exponents_change_between_spans() {
    let row = |j: u32| Row {
        normals: [tilted(-20.0), tilted(25.0)],
        length: 9,
        material: mirror(1 << j),
    };
    let rows: Vec<Row> = (0..=12).map(row).collect();
    let frame = frame_of(&rows, &[tilted(12.0)]);
    for core in cores(&frame) {
        assert_agrees(&core, &frame);
    }
}
