//! Lights and eyes behind the surface or in its plane.
use glam::DVec3;
use specula_fixtures::frames::{frame, material, mirror, tilted};
use specula_fixtures::specs::spec;
use specula_spec::Method;

use crate::cores::cores;
use crate::run::{assert_agrees, codes};

/// Row 32: a light behind the surface has no diffuse, and its highlight is not gated.
#[test]
fn light_behind_keeps_its_highlight() {
    let (normal, light) = (tilted(60.0), tilted(151.0));
    assert!(normal.dot(light) < 0.0);
    let diffuse = frame([normal; 2], 2, &[light], material(0.0, 1.0, 0.0, 4));
    let specular = frame([normal; 2], 2, &[light], mirror(4));
    for (without, with) in cores(&diffuse).iter().zip(cores(&specular)) {
        assert_eq!(codes(without, &diffuse), [0, 0]);
        assert!(codes(&with, &specular)[0] > 100);
    }
}

/// Row 33: with the eye behind the surface R points inwards, and pixels are what the formula says.
#[test]
fn pixels_seen_from_behind_agree() {
    for degrees in [85.0, 90.0, 95.0, 120.0, 180.0] {
        let frame = frame(
            [tilted(degrees - 5.0), tilted(degrees + 5.0)],
            33,
            &[tilted(2.0 * degrees)],
            material(0.1, 0.4, 0.5, 16),
        );
        for core in cores(&frame) {
            assert_agrees(&core, &frame);
        }
    }
}

/// Row 34: a grazing light keeps its highlight, with both forms of D.
#[test]
fn grazing_lights_keep_their_highlight() {
    let light = DVec3::new(1.0, 1.0, -1.0).normalize();
    let halfway = (light + DVec3::Z).normalize();
    for shininess in [1, 16, 64, 256] {
        let frame = frame([halfway; 2], 2, &[light], mirror(shininess));
        for core in cores(&frame) {
            assert!(codes(&core, &frame)[0] >= 254);
        }
    }
}

/// Lights in the plane of the surface, and a hair above and below it.
#[test]
fn lights_in_the_plane() {
    for degrees in [89.9, 89.999, 90.0, 90.001, 90.1] {
        let frame = frame(
            [tilted(-1.0), tilted(1.0)],
            21,
            &[tilted(degrees), tilted(-degrees)],
            material(0.0, 1.0, 0.0, 256),
        );
        for core in cores(&frame) {
            assert_agrees(&core, &frame);
        }
    }
    let plane = frame([DVec3::Z; 2], 2, &[DVec3::X], material(0.0, 1.0, 0.0, 1));
    assert_eq!(codes(&spec(&plane, Method::Hybrid), &plane), [0, 0]);
}
