//! Lights and eyes at places, and every exponent.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_scene::{Frame, LocalLight, Spot};
use specula_spec::phong::{Highlight, Places};
use specula_spec::{CoreSpec, Method, MethodSpec};

use crate::run::{assert_agrees, codes};

const HIGHLIGHTS: [Highlight; 4] = [
    Highlight::Reflection,
    Highlight::Blinn,
    Highlight::TorranceSparrow,
    Highlight::TrowbridgeReitz,
];

fn with(frame: &Frame, highlight: Highlight) -> CoreSpec {
    let mut core = spec(frame, Method::Phong);
    if let MethodSpec::Phong(phong) = &mut core.method {
        phong.highlight = highlight;
    }
    core.check().unwrap();
    core
}

/// A wall of five pixels from x = -2 to x = 2, seen from the front, under one light at a place.
fn wall(light: DVec3, spot: Option<Spot>, eye: Option<DVec3>) -> Frame {
    let mut frame = frame([DVec3::Z, DVec3::Z], 5, &[], material(0.0, 0.5, 0.5, 20));
    frame.triangles[0].positions =
        [DVec3::new(-2.0, 0.0, 0.0), DVec3::new(2.0, 0.0, 0.0), DVec3::new(-2.0, 1.0, 0.0)];
    frame.local_lights =
        vec![LocalLight { position: light, spot, attenuation: None, colour: [1.0; 3] }];
    frame.eye = eye;
    frame
}

/// Row 12: for L = -V there is no H*; Blinn's lobe is 0 there, and the distributions what they are
/// at 90 degrees.
#[test]
fn opposite_light_and_eye_have_no_halfway_vector() {
    let frame = frame([tilted(80.0), tilted(100.0)], 5, &[-DVec3::Z], mirror(4));
    assert_eq!(codes(&with(&frame, Highlight::Blinn), &frame), [0; 5]);
    let shallow =
        specula_fixtures::frames::frame([tilted(80.0), tilted(100.0)], 5, &[-DVec3::Z], mirror(1));
    // 255 exp(-π²/2) = 1.83
    assert_eq!(codes(&with(&shallow, Highlight::TorranceSparrow), &shallow), [2; 5]);
    // 255/25 = 10.2
    assert_eq!(codes(&with(&frame, Highlight::TrowbridgeReitz), &frame), [10; 5]);
}

/// Rows 12 and 35, found by `specula stress`: light and eye all but opposite, whose half-way vector
/// is longer than its gain can make it.
#[test]
fn all_but_opposite_light_and_eye_stay_within_bounds() {
    for degrees in [177.0, 179.0, 179.99, 180.0 - 1e-12] {
        let frame = frame([tilted(85.0), tilted(95.0)], 33, &[tilted(degrees)], mirror(16));
        for highlight in [Highlight::Blinn, Highlight::TorranceSparrow, Highlight::TrowbridgeReitz]
        {
            assert_agrees(&with(&frame, highlight), &frame);
        }
    }
}

/// Row 39: a light at the very pixel gives it nothing, and its neighbours theirs; so does an eye
/// for highlights.
#[test]
fn a_light_in_the_surface_lights_no_pixel_there() {
    let codes_in = |light, eye| {
        let frame = wall(light, None, eye);
        codes(&spec(&frame, Method::Phong), &frame)
    };
    // The light grazes the wall from within it: no diffuse, and R·L = -V·L = 0.
    assert_eq!(codes_in(DVec3::ZERO, None), [0; 5]);
    let eye_in_the_wall = codes_in(DVec3::Z, Some(DVec3::ZERO));
    // Diffuse alone at the eye's pixel: 255/2.
    assert_eq!(eye_in_the_wall[2], 128);
}

/// Row 40: directions are those of the true vectors however far the light is; unscaled wraps are
/// off by 50 degrees. Nearer than 1/16 of the way to the span's farther end they come out short
/// (docs/arithmetic/phong.md).
#[test]
fn far_and_near_lights_have_true_directions() {
    for distance in [0.25, 1.0, 10.0, 1e4] {
        let direction = tilted(60.0);
        let frame = wall(distance * direction, None, None);
        let total =
            assert_agrees(&spec(&frame, Method::Phong), &frame).comparison.errors.total.max_lsb;
        assert!(total <= 1.0, "a light {distance} away: off by {total} LSB");
    }
}

fn wrapped(frame: &Frame) -> CoreSpec {
    let mut core = spec(frame, Method::Phong);
    if let MethodSpec::Phong(phong) = &mut core.method {
        phong.places = Places::Wrapped;
    }
    core.check().unwrap();
    core
}

/// Rows 11 and 40: wrapped directions are true at both ends of the span, however far the light is,
/// and all along it if that is far.
#[test]
fn wrapped_directions_are_true_at_the_ends() {
    for distance in [0.25, 1.0, 10.0, 1e4] {
        let frame = wall(distance * tilted(60.0), None, Some(distance * tilted(20.0)));
        let (wrapped, exact) =
            (codes(&wrapped(&frame), &frame), codes(&spec(&frame, Method::Phong), &frame));
        let pixels = if distance > 1e3 { vec![0, 1, 2, 3, 4] } else { vec![0, 4] };
        for i in pixels {
            assert!(
                wrapped[i].abs_diff(exact[i]) <= 1,
                "{distance} away, pixel {i}: {wrapped:?} and {exact:?}"
            );
        }
    }
}

/// Rows 7, 8 and 39: a light in the surface, at a pixel, at an end, or along it, and an eye
/// likewise. Everything is defined.
#[test]
fn wraps_in_the_surface_are_defined() {
    for place in [
        DVec3::ZERO,
        DVec3::new(-2.0, 0.0, 0.0),
        DVec3::new(-3.0, 0.0, 0.0),
        DVec3::new(0.5, 0.0, 0.0),
    ] {
        for spot in [
            None,
            Some(Spot { axis: DVec3::X, exponent: 5 }),
            Some(Spot { axis: -DVec3::Z, exponent: 1 }),
        ] {
            for eye in [None, Some(place), Some(-DVec3::Z)] {
                let frame = wall(place, spot.clone(), eye);
                assert_agrees(&wrapped(&frame), &frame);
            }
        }
    }
}

/// Eq. 37: a spot is dark 90 degrees from its axis and beyond, where the wrap would fold back (row
/// 8), and true at the ends before that.
#[test]
fn wrapped_spots_are_dark_behind_themselves() {
    for exponent in [1, 60, 8191] {
        let at = |axis| {
            let frame = wall(DVec3::Z, Some(Spot { axis, exponent }), None);
            codes(&wrapped(&frame), &frame)
        };
        assert_eq!(at(DVec3::Z), vec![0; 5], "exponent {exponent}");
        let aslant = at(DVec3::X);
        assert_eq!(aslant[0], 0, "exponent {exponent}: {aslant:?}");
        let frame = wall(DVec3::Z, Some(Spot { axis: -DVec3::Z, exponent }), None);
        let (wrapped, exact) =
            (codes(&wrapped(&frame), &frame), codes(&spec(&frame, Method::Phong), &frame));
        assert!(
            wrapped[0].abs_diff(exact[0]) <= 1 && wrapped[4].abs_diff(exact[4]) <= 1,
            "{wrapped:?} and {exact:?}"
        );
    }
}

/// A spot shines along its axis and not behind it, with the largest exponent too.
#[test]
fn spots_end_where_they_should() {
    for exponent in [1, 60, 8191] {
        let at = |axis| {
            let frame = wall(DVec3::Z, Some(Spot { axis, exponent }), None);
            codes(&spec(&frame, Method::Phong), &frame)
        };
        let (towards, away) = (at(-DVec3::Z), at(DVec3::Z));
        assert_eq!((towards[2], away), (255, vec![0; 5]), "exponent {exponent}");
        assert!(
            towards[2] > towards[1] && towards[1] == towards[3],
            "exponent {exponent}: {towards:?}"
        );
    }
}

/// Rows 24 and 54: the largest exponent and one that is no power of two, across the highlight. For
/// exponents in the thousands the formats end at 22 fraction bits, where the base's error times n
/// comes to one LSB and more.
#[test]
fn every_exponent_is_near_a_code() {
    for (n, most) in [(1, 1.25), (3, 1.25), (100, 1.25), (8190, 1.75), (8191, 1.75)] {
        let frame = frame([tilted(-3.0), tilted(5.0)], 257, &[tilted(2.0)], mirror(n));
        for highlight in HIGHLIGHTS {
            let quantisation = assert_agrees(&with(&frame, highlight), &frame)
                .comparison
                .errors
                .quantisation
                .max_lsb;
            assert!(quantisation <= most, "n = {n}, {highlight:?}: {quantisation} LSB");
        }
    }
}
